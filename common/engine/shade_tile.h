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
#include <utility>

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

  template <class N>
  static N& number_of(Varyings<N>& varyings, int i) {
    return numbers<Shader::template Varyings, N>(varyings)[i];
  }
  template <class N>
  static const N& number_of(const Varyings<N>& varyings, int i) {
    return numbers<Shader::template Varyings, N>(varyings)[i];
  }

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

  /// Calls `visit(i)` for the varyings' Numbers. Not a loop: only what is written out is dropped by
  /// the compiler where the shader doesn't read it.
  template <class Visit>
  static void for_each_number(const Visit& visit) {
    [&]<int... i>(std::integer_sequence<int, i...>) {
      (visit(i), ...);
    }
    (std::make_integer_sequence<int, varying_count>());
  }

  using Table = RecordTable<corner_varyings.record_size()>;
  using Records = EachRecord<corner_varyings.record_size()>;

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

  struct PairColors {
    std::uint32_t discarded = 0;
    alignas(64) std::array<std::uint32_t, 2 * lanes> packed;
  };

  BlockColors shade_block(int block) const {
    BlockColors colors;
    PartsOfBlock varying;
    for (const VisiblePart& part : triangles_.parts(block)) {
      const ShadedTriangle& triangle = triangles_.triangle(part.slot);
      colors.mask |= part.mask;
      if (triangle.is_constant) {
        paint(triangle, part.mask, colors);
      } else {
        varying.add(part);
      }
    }
    if (varying.count > 0) shade_varying(block, varying, colors);
    return colors;
  }

  /// Triangles that aren't the same all over, and which of a block's pixels see them.
  struct PartsOfBlock {
    std::size_t count = 0;
    BlockMask mask = 0;
    std::array<VisiblePart, 64> part;

    void add(const VisiblePart& one) {
      part[count++] = one;
      mask |= one.mask;
    }
    std::span<const VisiblePart> parts() const { return std::span(part).first(count); }
  };

  static std::uint32_t pair_at(BlockMask mask, int first) {
    return static_cast<std::uint32_t>(mask >> first) & all_pair_lanes;
  }

  void shade_varying(int block, const PartsOfBlock& varying, BlockColors& colors) const {
    if (varying.count <= most_by_themselves) {
      shade_few(block, varying, colors);
    } else {
      shade_many(block, varying, colors);
    }
  }

  void take(const PairColors& pair, std::uint32_t wanted, int first, BlockColors& colors) const {
    const BlockMask here = BlockMask{wanted} << first;
    write_pixels(pair.packed.data(), here, first, colors);
    colors.kept |= here & ~(BlockMask{pair.discarded} << first);
  }

  /// Up to this many, each is interpolated by itself.
  static constexpr std::size_t most_by_themselves = 2;

  void shade_few(int block, const PartsOfBlock& varying, BlockColors& colors) const {
    std::array<EdgesInBlock, most_by_themselves> edges;
    for (std::size_t i = 0; i < varying.count; ++i) {
      const VisiblePart& part = varying.part[i];
      edges[i] = triangles_.edges_in_block(part.slot, block, std::countr_zero(part.mask));
    }
    for (int first = 0; first < 64; first += 2 * lanes) {
      const std::uint32_t wanted = pair_at(varying.mask, first);
      if (wanted == 0) continue;
      PartsOfPair few;
      few.first = first;
      for (std::size_t i = 0; i < varying.count; ++i) {
        const std::uint32_t here = pair_at(varying.part[i].mask, first);
        if (here != 0) few.part[few.count++] = {varying.part[i].slot, here, &edges[i]};
      }
      take(shade_pair(&few, nullptr, nullptr, wanted), wanted, first, colors);
    }
  }

  /// Their records in a table: one for the block, or, where it sees too many, one for each vector.
  void shade_many(int block, const PartsOfBlock& varying, BlockColors& colors) const {
    std::array<Table, 2> table;
    const bool in_one = varying.count <= Table::most;
    if (in_one) table[0].fill(triangles_, varying.parts());
    for (int first = 0; first < 64; first += 2 * lanes) {
      const std::uint32_t wanted = pair_at(varying.mask, first);
      if (wanted == 0) continue;
      const auto vector = [&](int pixel, Table& own) {
        if (in_one) return seen_by(varying, block, pixel, table[0]);
        const PartsOfBlock here = seen_in_vector(varying, pixel);
        own.fill(triangles_, here.parts());
        SeenByVector seen = seen_by(here, block, pixel, own);
        seen.parts = varying.parts();
        return seen;
      };
      const SeenByVector low = vector(first, table[0]);
      const SeenByVector high = vector(first + lanes, table[1]);
      take(shade_pair(nullptr, &low, &high, wanted), wanted, first, colors);
    }
  }

  /// Where there are none, anything: lanes beside those that are wanted.
  static PartsOfBlock seen_in_vector(const PartsOfBlock& varying, int first) {
    PartsOfBlock here;
    for (const VisiblePart& part : varying.parts()) {
      if (lanes_at(part.mask, first) != 0) here.add(part);
    }
    if (here.count == 0) here.add(varying.part[0]);
    return here;
  }

  static std::uint32_t lanes_at(BlockMask mask, int first) {
    return static_cast<std::uint32_t>(mask >> first) & all_lanes;
  }

  /// What a vector of a block's pixels sees, or, without a block, triangles that are the same all
  /// over, one per lane.
  struct SeenByVector {
    static constexpr int no_block = -1;

    int block = no_block;
    int first = 0;
    const Table* table = nullptr;
    Ints number_in_table = Ints(0);
    std::uint32_t front = 0;
    bool any_large = false;
    std::span<const VisiblePart> parts;
  };

  SeenByVector seen_by(const PartsOfBlock& parts, int block, int first, const Table& table) const {
    SeenByVector seen;
    seen.block = block;
    seen.first = first;
    seen.table = &table;
    seen.parts = parts.parts();
    for (std::size_t i = 0; i < parts.count; ++i) {
      const std::uint32_t here = lanes_at(parts.part[i].mask, first);
      if (here == 0) continue;
      const ShadedTriangle& triangle = triangles_.triangle(parts.part[i].slot);
      seen.number_in_table =
          select(truth_of(here), Ints(static_cast<std::int32_t>(i)), seen.number_in_table);
      seen.front |= triangle.front ? here : 0;
      seen.any_large = seen.any_large || triangle.is_large;
    }
    return seen;
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

  /// Two vectors of a block's pixels that see a few triangles.
  struct PartsOfPair {
    struct Part {
      std::int32_t slot;
      std::uint32_t lanes;
      const EdgesInBlock* edges;
    };
    int first = 0;
    std::size_t count = 0;
    std::array<Part, most_by_themselves> part;
  };

  /// Of `few`, or of any number in two vectors.
  RASTERLAB_FLATTEN PairColors shade_pair(const PartsOfPair* few, const SeenByVector* low,
                                          const SeenByVector* high, std::uint32_t wanted) const {
    PairColors colors;
    Point<NumberPair> point;
    if (few != nullptr) {
      point = see_part(few->part[0], few->first);
      for (std::size_t i = 1; i < few->count; ++i) {
        const std::uint32_t here = few->part[i].lanes;
        point = chosen({truth_of(here), truth_of(here >> lanes)},
                       see_part(few->part[i], few->first), point);
      }
    } else {
      point = join(see(*low), see(*high));
    }
    const Fragment<NumberPair> fragment = shade(point, wanted);
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
    std::array<Table, 2> table;
    std::array<SeenByVector, 2> seen;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      std::array<VisiblePart, lanes> part;
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        part[lane] = {0, slot[std::min(i * lanes + lane, slot.size() - 1)]};
        if (triangles_.triangle(part[lane].slot).front) seen[i].front |= 1U << lane;
      }
      table[i].fill(triangles_, part);
      seen[i].table = &table[i];
      seen[i].number_in_table = iota(0);
    }
    const std::uint32_t wanted = all_pair_lanes >> (2 * lanes - static_cast<int>(slot.size()));
    const PairColors colors = shade_pair(nullptr, &seen[0], &seen[1], wanted);
    for (std::size_t i = 0; i < slot.size(); ++i) {
      ShadedTriangle& triangle = triangles_.triangle(slot[i]);
      triangle.color = colors.packed[i];
      triangle.is_discarded = (colors.discarded >> i & 1U) != 0;
    }
  }

  // -------------------------------------------------------------------------------------------
  // What a pixel sees

  /// Edge functions, exactly; 0 is what the others leave of twice the area.
  struct Edges {
    Doubles e0, e1, e2;
  };

  Point<NumberPair> see_part(const typename PartsOfPair::Part& part, int first) const {
    const OneRecord record(triangles_, part.slot);
    const auto half = [&](int pixel) {
      return surface_point(
          {part.edges->at(0, pixel), part.edges->at(1, pixel), part.edges->at(2, pixel)}, record);
    };
    return join(half(first), half(first + lanes));
  }

  static Point<NumberPair> chosen(TruthPair condition, const Point<NumberPair>& if_true,
                                  const Point<NumberPair>& if_false) {
    return {chosen(condition, if_true.value, if_false.value),
            chosen(condition, if_true.dx, if_false.dx), chosen(condition, if_true.dy, if_false.dy),
            select(condition, if_true.front_facing, if_false.front_facing)};
  }
  static Varyings<NumberPair> chosen(TruthPair condition, const Varyings<NumberPair>& if_true,
                                     const Varyings<NumberPair>& if_false) {
    Varyings<NumberPair> result;
    for_each_number([&](int i) {
      number_of(result, i) = select(condition, number_of(if_true, i), number_of(if_false, i));
    });
    return result;
  }

  Point<Number> see(const SeenByVector& seen) const {
    const Records records(*seen.table, seen.number_in_table, seen.front);
    if (seen.block == SeenByVector::no_block) return constant_point(records);
    return surface_point(seen.any_large ? edges_of_each(seen) : edges_at(seen, records), records);
  }

  static Point<Number> constant_point(const Records& records) {
    Point<Number> point = {};
    interpolate({Number(0), Number(0)}, records, point.value);
    point.front_facing = records.front_facing();
    return point;
  }

  /// The pixels' columns and rows in the tile.
  struct Place {
    Ints x, y;
  };
  Place place_of(const SeenByVector& seen) const {
    const auto [left, top] = triangles_.place_of_block(seen.block);
    const Ints pixel = iota(seen.first);
    return {(pixel & Ints(7)) + Ints(left), shift_right<3>(pixel) + Ints(top)};
  }

  Edges edges_at(const SeenByVector& seen, const Records& r) const {
    const Place place = place_of(seen);
    const auto edge = [&](int at_first, int step_x, int step_y) {
      return to_doubles(r.integer(at_first) +
                        shift_left<8>(place.x * r.integer(step_x) + place.y * r.integer(step_y)));
    };
    const Doubles e1 = edge(word::edge1, word::step1_x, word::step1_y);
    const Doubles e2 = edge(word::edge2, word::step2_x, word::step2_y);
    return {r.integer_as_doubles(word::area) - (e1 + e2), e1, e2};
  }

  /// When some are large.
  [[gnu::noinline]] Edges edges_of_each(const SeenByVector& seen) const {
    alignas(64) std::array<std::array<double, lanes>, 3> each = {};
    for (const VisiblePart& part : seen.parts) {
      const std::uint32_t here = lanes_at(part.mask, seen.first);
      if (here == 0) continue;
      const EdgesInBlock edges =
          triangles_.edges_in_block(part.slot, seen.block, std::countr_zero(part.mask));
      for (std::size_t e = 0; e < 3; ++e) {
        alignas(64) std::array<double, lanes> own;
        store(edges.at(e, seen.first), own.data());
        for (std::uint32_t rest = here; rest != 0; rest &= rest - 1) {
          const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
          each[e][lane] = own[lane];
        }
      }
    }
    return {load(each[0].data()), load(each[1].data()), load(each[2].data())};
  }

  template <class Record>
  static Point<Number> surface_point(const Edges& edges, const Record& r) {
    const Doubles q1 = edges.e1 * r.number_as_doubles(word::ratio1);
    const Doubles q2 = edges.e2 * r.number_as_doubles(word::ratio2);
    const Doubles inverse = Doubles(1) / (edges.e0 + (q1 + q2));
    const CornerWeights<Number> weights = {to_number(q1 * inverse), to_number(q2 * inverse)};
    Point<Number> point;
    interpolate(weights, r, point.value);
    differentiate(derivative(r, word::step1_x, word::step2_x), weights, to_number(inverse), r,
                  point.dx);
    differentiate(derivative(r, word::step1_y, word::step2_y), weights, to_number(inverse), r,
                  point.dy);
    point.front_facing = r.front_facing();
    return point;
  }

  /// Of q_1, q_2 and the sum of all q.
  struct Derivatives {
    Number q1, q2, sum;
  };
  template <class Record>
  static Derivatives derivative(const Record& r, int step1, int step2) {
    const Number e1 = as_numbers(r.integer(step1)) * Number(256);
    const Number e2 = as_numbers(r.integer(step2)) * Number(256);
    const Number q1 = e1 * r.number(word::ratio1);
    const Number q2 = e2 * r.number(word::ratio2);
    return {q1, q2, (q1 - e1) + (q2 - e2)};
  }

  template <class Record>
  static Number difference(const CornerWeights<Number>& weights, const Record& r, int i) {
    return weights.b1 * to_1(r, i) + weights.b2 * to_2(r, i);
  }

  template <class Record>
  static void interpolate(const CornerWeights<Number>& weights, const Record& r,
                          Varyings<Number>& value) {
    for_each_number([&](int i) { number_of(value, i) = at_0(r, i) + difference(weights, r, i); });
  }

  /// With a = a0 + (q1·d1 + q2·d2) / Q: a' = (q1'·d1 + q2'·d2 − (a − a0)·Q') / Q.
  template <class Record>
  static void differentiate(const Derivatives& d, const CornerWeights<Number>& weights,
                            Number inverse, const Record& r, Varyings<Number>& result) {
    for_each_number([&](int i) {
      const Number steps = d.q1 * to_1(r, i) + d.q2 * to_2(r, i);
      number_of(result, i) = (steps - difference(weights, r, i) * d.sum) * inverse;
    });
  }

  static Point<NumberPair> join(const Point<Number>& low, const Point<Number>& high) {
    return {join(low.value, high.value),
            join(low.dx, high.dx),
            join(low.dy, high.dy),
            {low.front_facing, high.front_facing}};
  }
  static Varyings<NumberPair> join(const Varyings<Number>& low, const Varyings<Number>& high) {
    Varyings<NumberPair> both;
    for_each_number([&](int i) { number_of(both, i) = {number_of(low, i), number_of(high, i)}; });
    return both;
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
    for_each_number([&](int i) {
      Lanes values;
      store(number_of(from, i).low, values.data());
      store(number_of(from, i).high, values.data() + lanes);
      number_of(to, i) = values[lane];
    });
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
