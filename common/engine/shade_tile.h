// Shading: what is seen in a tile becomes colours, each pixel once.
//
// The depth pass left the number of the nearest triangle in every pixel; VisibleTriangles has each
// of them set up. Here pixels are shaded, two vectors of them at a time (number_pair.h): what
// depends on the shader, and is compiled for each.
//
// A pixel's barycentric weights come from the exact integer edge functions: with q_i = E_i · w0/w_i
// the perspective-correct weights are q_i / (q_0 + q_1 + q_2), computed in double. They become
// floats last, so they are right to about a unit in the last place for slivers and for any ratio of
// w.
#pragma once

#include "common/engine/number_pair.h"
#include "common/engine/shading.h"
#include "common/engine/visible_triangles.h"
#include "common/mesh/shader_types.h"

#include <bit>
#include <concepts>

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

  // -------------------------------------------------------------------------------------------
  // A block

  struct BlockColors {
    BlockMask mask = 0;  ///< of what the triangles cover
    BlockMask kept = 0;  ///< of that, what isn't discarded
    alignas(64) std::array<std::uint32_t, 64> packed;
  };

  /// The records of as many pixels as there are lanes.
  struct Records {
    std::array<Number, static_cast<std::size_t>(corner_varyings.record_size())> words;
    bool any_large;

    Ints integer(int i) const { return bit_pattern(words[static_cast<std::size_t>(i)]); }
    Number number(int i) const { return words[static_cast<std::size_t>(i)]; }
    Number at_0(int i) const { return number(word::count + i); }
    Number to_1(int i) const { return number(word::count + varying_count + i); }
    Number to_2(int i) const { return number(word::count + 2 * varying_count + i); }
  };

  [[gnu::flatten]] BlockColors shade_block(int block) const {
    BlockColors colors;
    const std::int32_t block_slot = triangles_.block_slot(block);
    if (block_slot == VisibleTriangles::no_slot) return colors;
    std::array<Records, 2> records;
    if (block_slot >= 0) take_one(block_slot, records[0]);
    for (int first = 0; first < 64; first += 2 * lanes) {
      std::uint32_t mask = every_lane;
      std::array<std::int32_t, 2 * lanes> slot;
      if (block_slot < 0) {
        mask = find_slots(triangles_.slots(block) + first, slot.data());
        if (mask == 0) continue;
        take_each(slot.data(), records[0]);
        take_each(slot.data() + lanes, records[1]);
      } else if (records[0].any_large) {
        slot.fill(block_slot);
      }
      const auto seen = [&](std::size_t half) {
        const int pixel = first + static_cast<int>(half) * lanes;
        const Records& r = records[block_slot < 0 ? half : 0];
        return surface_point(r.any_large ? triangles_.exact_edges(block, pixel, &slot[half * lanes])
                                         : edges_at(block, pixel, r),
                             r);
      };
      const Fragment<NumberPair> fragment = shade(join(seen(0), seen(1)), mask);
      write_bytes(fragment.color, colors.packed.data() + first);
      colors.mask |= BlockMask{mask} << first;
      if constexpr (may_discard<Shader>) {
        colors.kept |= BlockMask{mask & ~bits_of(fragment.discarded)} << first;
      }
    }
    return colors;
  }

  static constexpr std::uint32_t every_lane = 0xFFFFFFFFU >> (32 - 2 * lanes);

  static std::uint32_t bits_of(TruthPair truth) {
    return bits(truth.low) | bits(truth.high) << lanes;
  }

  /// The slots of two vectors of pixels; which of them are this draw call's. Lanes that aren't
  /// shade some triangle of it, for nothing.
  static std::uint32_t find_slots(const std::int32_t* from, std::int32_t* slot) {
    const auto owned = [&](int first) { return load(from + first) >= Ints(0); };
    const std::uint32_t mask = bits_of({owned(0), owned(lanes)});
    if (mask == 0) return 0;
    const Ints some(from[std::countr_zero(mask)]);
    for (const int first : {0, lanes}) {
      store(select(owned(first), load(from + first), some), slot + first);
    }
    return mask;
  }

  /// The same triangle in all lanes.
  void take_one(std::int32_t slot, Records& records) const {
    const float* record = triangles_.record(slot);
    for (std::size_t i = 0; i < records.words.size(); ++i) records.words[i] = Number(record[i]);
    records.any_large = std::bit_cast<std::int32_t>(record[word::is_large]) != 0;
  }

  void take_each(const std::int32_t* slot, Records& records) const {
    std::array<const float*, lanes> record;
    for (std::size_t lane = 0; lane < lanes; ++lane) record[lane] = triangles_.record(slot[lane]);
    for (std::size_t i = 0; i < records.words.size(); i += 4) {
      load_fours(record.data(), &records.words[i]);
      for (const float*& from : record) from += 4;
    }
    records.any_large = any(records.integer(word::is_large) == Ints(1));
  }

  // -------------------------------------------------------------------------------------------
  // What a pixel sees

  Edges edges_at(int block, int first, const Records& r) const {
    const auto [left, top] = triangles_.place_of_block(block);
    const Ints pixel = iota(first);
    const Ints x = (pixel & Ints(7)) + Ints(left);
    const Ints y = shift_right<3>(pixel) + Ints(top);
    const auto edge = [&](int at_first, int step_x, int step_y) {
      return to_doubles(r.integer(at_first) +
                        shift_left<8>(x * r.integer(step_x) + y * r.integer(step_y)));
    };
    return {edge(word::edge1, word::step1_x, word::step1_y),
            edge(word::edge2, word::step2_x, word::step2_y), to_doubles(r.integer(word::area))};
  }

  static Point<Number> surface_point(const Edges& edges, const Records& r) {
    const Number ratio1 = r.number(word::ratio1);
    const Number ratio2 = r.number(word::ratio2);
    const Doubles q1 = edges.e1 * to_doubles(ratio1);
    const Doubles q2 = edges.e2 * to_doubles(ratio2);
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
    point.front_facing = r.integer(word::front) == Ints(1);
    return point;
  }

  static void interpolate(const CornerWeights<Number>& value, const CornerWeights<Number>& dx,
                          const CornerWeights<Number>& dy, const Records& r, Point<Number>& point) {
    if constexpr (varying_count > 0) {
      for (int i = 0; i < varying_count; ++i) {
        const Number to_1 = r.to_1(i);
        const Number to_2 = r.to_2(i);
        numbers<Shader::template Varyings, Number>(point.value)[i] =
            r.at_0(i) + (value.b1 * to_1 + value.b2 * to_2);
        numbers<Shader::template Varyings, Number>(point.dx)[i] = dx.b1 * to_1 + dx.b2 * to_2;
        numbers<Shader::template Varyings, Number>(point.dy)[i] = dy.b1 * to_1 + dy.b2 * to_2;
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

/// Compiles a shader for this file's instruction set. Outside all namespaces.
#define RASTERLAB_SHADER(Shader) \
  template const rasterlab::ShadingKernels& rasterlab::RASTERLAB_SIMD::shading_kernels<Shader>();
