// Shading: what is seen in a tile becomes colours, each pixel once.
//
// The depth pass left the number of the nearest triangle in every pixel; VisibleTriangles has each
// of them set up. Here pixels are shaded, two vectors of them at a time (number_pair.h): what
// depends on the shader, and is compiled for each.
//
// A triangle whose corners have the same varyings looks the same all over: it is shaded once, as if
// it were a pixel, and painted.
//
// A pixel's barycentric weights come from the exact integer edge functions: with q_i = E_i · w0/w_i
// the perspective-correct weights are q_i / (q_0 + q_1 + q_2), computed in double. They become
// floats last, so they are right to about a unit in the last place for slivers and for any ratio of
// w.
#pragma once

#include "common/engine/number_pair.h"
#include "common/engine/pixel_records.h"
#include "common/engine/shading.h"
#include "common/engine/visible_triangles.h"
#include "common/mesh/shader_types.h"

#include <bit>
#include <concepts>
#include <span>

// One function without calls is 7 to 33 % faster, and takes five times as long to compile: done for
// the instruction sets that are met with, where speed is what is compiled for.
#if defined(__AVX2__) && defined(NDEBUG)
#define RASTERLAB_FLATTEN [[gnu::flatten, gnu::noinline]]
#else
#define RASTERLAB_FLATTEN [[gnu::noinline]]
#endif

namespace rasterlab::RASTERLAB_SIMD {

/// Shades the tiles of one draw call.
template <class Shader>
class TileShading {
 public:
  TileShading(const DrawJob& job, const Tile& tile, Worker& worker)
      : shader_(*static_cast<const Shader*>(job.shader)),
        triangles_(job, tile, corner_varyings, worker),
        block_count_(tile.block_count()),
        statistics_(worker.statistics) {}

  void run() {
    triangles_.take_all();
    shade_constant_triangles();
    for (int block = 0; block < block_count_; ++block) {
      const BlockColors colors = shade_block(block);
      if (colors.mask == 0) continue;
      triangles_.write_colors(block, colors.packed.data(), colors.mask);
      statistics_.pixels_shaded += static_cast<unsigned>(std::popcount(colors.mask));
    }
  }

  /// For one triangle and a tile of one block: which of the pixels the shader keeps.
  BlockMask keep(std::uint32_t key, BlockMask covered) {
    triangles_.take_one(key, covered);
    shade_constant_triangles();
    return shade_block(0).kept & covered;
  }

 private:
  template <class N>
  using Varyings = typename Shader::template Varyings<N>;
  template <class N>
  using Point = SurfacePoint<Shader::template Varyings, N>;
  static constexpr int varying_count = number_count<Shader::template Varyings>();

  static void write_corners(const void* shader, const Mesh& mesh, std::uint32_t triangle, int first,
                            float* corners) {
    for (int i = 0; i < 3; ++i) {
      const Varyings<float> value =
          static_cast<const Shader*>(shader)->vertex(mesh, triangle, (first + i) % 3);
      std::copy_n(numbers<Shader::template Varyings, float>(value), varying_count,
                  corners + i * varying_count);
    }
  }
  static constexpr CornerVaryings corner_varyings = {varying_count, &write_corners};

  using EachRecord = EachRecordOf<corner_varyings.record_size()>;

  template <class Record>
  static Number at_0(const Record& r, int i) {
    return r.number(word::count + i);
  }
  template <class Record>
  static Number to_1(const Record& r, int i) {
    return r.number(word::count + varying_count + i);
  }
  template <class Record>
  static Number to_2(const Record& r, int i) {
    return r.number(word::count + 2 * varying_count + i);
  }

  // -------------------------------------------------------------------------------------------
  // A block

  struct BlockColors {
    BlockMask mask = 0;  ///< of what the triangles cover
    BlockMask kept = 0;  ///< of that, what isn't discarded
    alignas(64) std::array<std::uint32_t, 64> packed = {};
  };

  BlockColors shade_block(int block) const {
    BlockColors colors;
    const std::span<const VisiblePart> parts = triangles_.parts(block);
    BlockMask varying = 0;
    for (const VisiblePart& part : parts) {
      const ShadedTriangle& triangle = triangles_.triangle(part.slot);
      colors.mask |= part.mask;
      if (triangle.is_constant) {
        paint(triangle, part.mask, colors);
      } else {
        varying |= part.mask;
      }
    }
    for (int first = 0; first < 64; first += 2 * lanes) {
      const std::uint32_t wanted = static_cast<std::uint32_t>(varying >> first) & all_pair_lanes;
      if (wanted == 0) continue;
      PartsOfVector low = triangles_.parts_of_vector(block, first);
      PartsOfVector high = triangles_.parts_of_vector(block, first + lanes);
      // Lanes that see nothing, while others do, see anything.
      if (low.count == 0) low = high;
      if (high.count == 0) high = low;
      const PairColors pair = shade_pair(low, high, wanted);
      const BlockMask here = BlockMask{wanted} << first;
      write_pixels(pair.packed.data(), here, first, colors);
      colors.kept |= here & ~(BlockMask{pair.discarded} << first);
    }
    return colors;
  }

  /// Beside those of constant triangles.
  static void write_pixels(const std::uint32_t* packed, BlockMask mask, int first,
                           BlockColors& colors) {
    for (int i = 0; i < 2 * lanes; i += lanes) {
      const Truth here = truth_of(static_cast<std::uint32_t>(mask >> (first + i)) & all_lanes);
      std::uint32_t* to = colors.packed.data() + first + i;
      store(select(here, load(packed + i), load(to)), to);
    }
  }

  struct PairColors {
    std::uint32_t discarded = 0;
    alignas(64) std::array<std::uint32_t, 2 * lanes> packed = {};
  };

  RASTERLAB_FLATTEN PairColors shade_pair(const PartsOfVector& low, const PartsOfVector& high,
                                          std::uint32_t wanted) const {
    PairColors colors;
    const Fragment<NumberPair> fragment = shade(join(see(low), see(high)), wanted);
    write_bytes(fragment.color, colors.packed.data());
    if constexpr (may_discard<Shader>) colors.discarded = bits_of(fragment.discarded);
    return colors;
  }

  static constexpr std::uint32_t all_pair_lanes = 0xFFFFFFFFU >> (32 - 2 * lanes);

  static std::uint32_t bits_of(TruthPair truth) {
    return bits(truth.low) | bits(truth.high) << lanes;
  }

  static void paint(const ShadedTriangle& triangle, BlockMask mask, BlockColors& colors) {
    const Ints color(static_cast<std::int32_t>(triangle.color));
    for (int first = 0; first < 64; first += lanes) {
      const Truth here = truth_of(static_cast<std::uint32_t>(mask >> first) & all_lanes);
      std::uint32_t* packed = colors.packed.data() + first;
      store(select(here, color, load(packed)), packed);
    }
    if (!triangle.is_discarded) colors.kept |= mask;
  }

  /// Triangles that are the same all over get their colour here, two vectors of them at a time.
  void shade_constant_triangles() {
    std::array<std::int32_t, 2 * lanes> slot = {};
    std::size_t count = 0;
    for (std::int32_t i = 0; i < triangles_.slot_count(); ++i) {
      if (!triangles_.triangle(i).is_constant) continue;
      slot[count++] = i;
      if (count < slot.size()) continue;
      shade_constant(slot);
      count = 0;
    }
    if (count > 0) shade_constant(std::span(slot).first(count));
  }

  void shade_constant(std::span<const std::int32_t> slot) {
    std::array<PartsOfVector, 2> seen;
    for (std::size_t i = 0; i < 2 * lanes; ++i) {
      seen[i / lanes].add(slot[std::min(i, slot.size() - 1)], 1U << i % lanes);
    }
    const std::uint32_t wanted = all_pair_lanes >> (2 * lanes - static_cast<int>(slot.size()));
    const PairColors colors = shade_pair(seen[0], seen[1], wanted);
    for (std::size_t i = 0; i < slot.size(); ++i) {
      ShadedTriangle& triangle = triangles_.triangle(slot[i]);
      triangle.color = colors.packed[i];
      triangle.is_discarded = (colors.discarded >> i & 1U) != 0;
    }
  }

  // -------------------------------------------------------------------------------------------
  // What a pixel sees

  /// Edge functions 1 and 2 and twice the area, exactly.
  struct Edges {
    Doubles e1, e2, area;
  };

  Point<Number> see(const PartsOfVector& seen) const {
    if (seen.count == 1 && seen.block != PartsOfVector::no_block) {
      const std::int32_t slot = seen.part[0].slot;
      const OneRecord record(triangles_, slot);
      return surface_point(seen.any_large ? large_edges_at(seen, slot) : edges_at(seen, record),
                           record);
    }
    const EachRecord records(triangles_, seen);
    if (seen.block == PartsOfVector::no_block) return constant_point(records);
    return surface_point(seen.any_large ? edges_of_each(seen) : edges_at(seen, records), records);
  }

  static Point<Number> constant_point(const EachRecord& records) {
    const CornerWeights<Number> anywhere = {Number(0), Number(0)};
    Point<Number> point;
    interpolate(anywhere, anywhere, anywhere, records, point);
    point.front_facing = records.front_facing();
    return point;
  }

  /// The pixels' columns and rows in the tile.
  struct Place {
    Ints x, y;
  };
  Place place_of(const PartsOfVector& seen) const {
    const auto [left, top] = triangles_.place_of_block(seen.block);
    const Ints pixel = iota(seen.first);
    return {(pixel & Ints(7)) + Ints(left), shift_right<3>(pixel) + Ints(top)};
  }

  template <class Record>
  Edges edges_at(const PartsOfVector& seen, const Record& r) const {
    const Place place = place_of(seen);
    const auto edge = [&](int at_first, int step_x, int step_y) {
      return to_doubles(r.integer(at_first) +
                        shift_left<8>(place.x * r.integer(step_x) + place.y * r.integer(step_y)));
    };
    return {edge(word::edge1, word::step1_x, word::step1_y),
            edge(word::edge2, word::step2_x, word::step2_y), r.integer_as_doubles(word::area)};
  }

  Edges large_edges_at(const PartsOfVector& seen, std::int32_t slot) const {
    const OneRecord record(triangles_, slot);
    const auto& at_first = triangles_.triangle(slot).edges;
    const Place place = place_of(seen);
    const Doubles x = to_doubles(shift_left<8>(place.x));
    const Doubles y = to_doubles(shift_left<8>(place.y));
    const auto edge = [&](std::size_t i, int step_x, int step_y) {
      return Doubles(at_first[i]) +
             (x * record.integer_as_doubles(step_x) + y * record.integer_as_doubles(step_y));
    };
    return {edge(0, word::step1_x, word::step1_y), edge(1, word::step2_x, word::step2_y),
            Doubles(at_first[2])};
  }

  /// When some are large.
  [[gnu::noinline]] Edges edges_of_each(const PartsOfVector& seen) const {
    alignas(64) std::array<std::array<double, lanes>, 3> each = {};
    for (const PartOfVector& part : seen.parts()) {
      const Edges edges = triangles_.triangle(part.slot).is_large
                              ? large_edges_at(seen, part.slot)
                              : edges_at(seen, OneRecord(triangles_, part.slot));
      alignas(64) std::array<std::array<double, lanes>, 3> own;
      store(edges.e1, own[0].data());
      store(edges.e2, own[1].data());
      store(edges.area, own[2].data());
      for (std::uint32_t rest = part.lanes; rest != 0; rest &= rest - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
        for (std::size_t e = 0; e < 3; ++e) each[e][lane] = own[e][lane];
      }
    }
    return {load(each[0].data()), load(each[1].data()), load(each[2].data())};
  }

  template <class Record>
  static Point<Number> surface_point(const Edges& edges, const Record& r) {
    const Number ratio1 = r.number(word::ratio1);
    const Number ratio2 = r.number(word::ratio2);
    const Doubles q1 = edges.e1 * r.number_as_doubles(word::ratio1);
    const Doubles q2 = edges.e2 * r.number_as_doubles(word::ratio2);
    const Doubles inverse = Doubles(1) / ((edges.area - (edges.e1 + edges.e2)) + (q1 + q2));
    const CornerWeights<Number> weights = {to_number(q1 * inverse), to_number(q2 * inverse)};
    // (q1 / Q)' = (q1' − b1 · Q') / Q
    const auto derivative = [&](int step1, int step2) {
      const Number e1 = as_numbers(r.integer(step1)) * Number(256);
      const Number e2 = as_numbers(r.integer(step2)) * Number(256);
      const Number dq1 = e1 * ratio1;
      const Number dq2 = e2 * ratio2;
      const Number sum = (dq1 - e1) + (dq2 - e2);
      const Number over = to_number(inverse);
      return CornerWeights<Number>{(dq1 - weights.b1 * sum) * over,
                                   (dq2 - weights.b2 * sum) * over};
    };
    Point<Number> point;
    interpolate(weights, derivative(word::step1_x, word::step2_x),
                derivative(word::step1_y, word::step2_y), r, point);
    point.front_facing = r.front_facing();
    return point;
  }

  template <class Record>
  static void interpolate(const CornerWeights<Number>& value, const CornerWeights<Number>& dx,
                          const CornerWeights<Number>& dy, const Record& r, Point<Number>& point) {
    if constexpr (varying_count > 0) {
      for (int i = 0; i < varying_count; ++i) {
        const Number d1 = to_1(r, i);
        const Number d2 = to_2(r, i);
        numbers<Shader::template Varyings, Number>(point.value)[i] =
            at_0(r, i) + (value.b1 * d1 + value.b2 * d2);
        numbers<Shader::template Varyings, Number>(point.dx)[i] = dx.b1 * d1 + dx.b2 * d2;
        numbers<Shader::template Varyings, Number>(point.dy)[i] = dy.b1 * d1 + dy.b2 * d2;
      }
    }
  }

  static Point<NumberPair> join(const Point<Number>& low, const Point<Number>& high) {
    Point<NumberPair> both;
    join(low.value, high.value, both.value);
    join(low.dx, high.dx, both.dx);
    join(low.dy, high.dy, both.dy);
    both.front_facing = {low.front_facing, high.front_facing};
    return both;
  }
  static void join(const Varyings<Number>& low, const Varyings<Number>& high,
                   Varyings<NumberPair>& both) {
    if constexpr (varying_count > 0) {
      for (int i = 0; i < varying_count; ++i) {
        numbers<Shader::template Varyings, NumberPair>(both)[i] = {
            numbers<Shader::template Varyings, Number>(low)[i],
            numbers<Shader::template Varyings, Number>(high)[i]};
      }
    }
  }

  // -------------------------------------------------------------------------------------------
  // What it becomes

  Fragment<NumberPair> shade(const Point<NumberPair>& point, std::uint32_t wanted) const {
    if constexpr (ShadesNumbers<Shader, NumberPair>) {
      return to_fragment(shader_.fragment(point));
    } else {
      return lane_by_lane(point, wanted);
    }
  }

  /// For a shader that only knows floats.
  Fragment<NumberPair> lane_by_lane(const Point<NumberPair>& point, std::uint32_t wanted) const {
    std::array<Lanes, 3> color = {};
    std::uint32_t discarded = 0;
    const std::uint32_t front = bits_of(point.front_facing);
    for (std::uint32_t rest = wanted; rest != 0; rest &= rest - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
      Point<float> one;
      copy_lane(point.value, lane, one.value);
      copy_lane(point.dx, lane, one.dx);
      copy_lane(point.dy, lane, one.dy);
      one.front_facing = (front >> lane & 1U) != 0;
      const Fragment<float> fragment = to_fragment(shader_.fragment(one));
      discarded |= static_cast<std::uint32_t>(fragment.discarded) << lane;
      for (std::size_t c = 0; c < 3; ++c) {
        color[c][lane] = fragment.color[static_cast<Eigen::Index>(c)];
      }
    }
    const auto pair = [](const Lanes& from) {
      return NumberPair(load(from.data()), load(from.data() + lanes));
    };
    return {{pair(color[0]), pair(color[1]), pair(color[2])},
            {truth_of(discarded), truth_of(discarded >> lanes)}};
  }

  using Lanes = std::array<float, static_cast<std::size_t>(2 * lanes)>;

  static void copy_lane(const Varyings<NumberPair>& from, std::size_t lane, Varyings<float>& to) {
    if constexpr (varying_count > 0) {
      for (int i = 0; i < varying_count; ++i) {
        const NumberPair& number = numbers<Shader::template Varyings, NumberPair>(from)[i];
        Lanes values;
        store(number.low, values.data());
        store(number.high, values.data() + lanes);
        numbers<Shader::template Varyings, float>(to)[i] = values[lane];
      }
    }
  }

  /// [0, 1] to 0…255 as to_byte() does; not a number becomes 0.
  static Ints byte(Number value) {
    const Number inside = minimum(maximum(value, Number(0)), Number(1));
    return to_whole(inside * Number(255) + Number(0.5F));
  }
  static void write_bytes(const Vector3<NumberPair>& color, std::uint32_t* packed) {
    const auto pack = [](Number r, Number g, Number b) {
      return byte(r) | shift_left<8>(byte(g)) | shift_left<16>(byte(b));
    };
    store(pack(color.x().low, color.y().low, color.z().low), packed);
    store(pack(color.x().high, color.y().high, color.z().high), packed + lanes);
  }

  const Shader& shader_;
  VisibleTriangles triangles_;
  int block_count_;
  Statistics& statistics_;
};

template <class Shader>
void shade_tile(const DrawJob& job, const Tile& tile, Worker& worker) {
  TileShading<Shader>(job, tile, worker).run();
}

template <class Shader>
BlockMask keep(const DrawJob& job, std::uint32_t key, int left, int top, BlockMask covered,
               Worker& worker) {
  Tile block;
  block.left = left;
  block.top = top;
  block.size = 8;
  return TileShading<Shader>(job, block, worker).keep(key, covered);
}

/// The functions a shader is compiled to, for this file's instruction set.
template <class Shader>
constexpr ShadingKernels make_kernels() {
  ShadingKernels kernels = {&shade_tile<Shader>, nullptr};
  if constexpr (may_discard<Shader>) kernels.keep = &keep<Shader>;
  return kernels;
}

template <class Shader>
inline constexpr ShadingKernels kernels_of = make_kernels<Shader>();

template <class Shader>
const ShadingKernels& shading_kernels() {
  return kernels_of<Shader>;
}

}  // namespace rasterlab::RASTERLAB_SIMD

#undef RASTERLAB_FLATTEN

/// Compiles a shader for this file's instruction set. Outside all namespaces.
#define RASTERLAB_SHADER(Shader) \
  template const rasterlab::ShadingKernels& rasterlab::RASTERLAB_SIMD::shading_kernels<Shader>();
