// Shading: what is seen in a tile becomes colours, each pixel once.
//
// The depth pass left the number of the nearest triangle in every pixel; VisibleTriangles has each
// of them set up. Here pixels are shaded, two vectors of them at a time (number_pair.h): what
// depends on the shader, and is compiled for each.
//
// A triangle whose corners have the same varyings looks the same all over: it is shaded once, as if
// it were a pixel, and painted.
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
        leaves_out_unread_(job.skip.unread_attributes),
        statistics_(worker.statistics) {}

  void run() {
    triangles_.take_all();
    shade_constant_triangles();
    BlockColors colors;
    for (int block = 0; block < block_count_; ++block) {
      if (block % triangles_.blocks_per_row() == 0) {
        triangles_.prefetch_colors(block / triangles_.blocks_per_row() + 1);
      }
      shade_block(block, colors);
      if (colors.mask == 0) continue;
      triangles_.write_colors(block, colors.packed.data(), colors.mask);
      statistics_.pixels_shaded += static_cast<unsigned>(std::popcount(colors.mask));
    }
    shade_scattered();
  }

  /// Pixels of one triangle, of a tile of one block. Their colours go to the picture if the tile
  /// has a place for them; returns which the shader keeps.
  BlockMask shade_one(std::uint32_t key, BlockMask pixels, bool writes) {
    triangles_.take_one(key, pixels);
    shade_constant_triangles();
    BlockColors colors;
    shade_block(0, colors);
    const BlockMask kept = colors.kept & pixels;
    if (!writes) {
      statistics_.pixels_asked += static_cast<unsigned>(std::popcount(pixels));
      return kept;
    }
    const BlockMask inside = triangles_.inside(0);
    triangles_.write_colors(0, colors.packed.data(), kept & inside);
    statistics_.pixels_shaded += static_cast<unsigned>(std::popcount(pixels & inside));
    return kept;
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
  /// All corners at once, in registers.
  static bool write_record(const void* shader, const Mesh& mesh, std::uint32_t triangle, int first,
                           float* corners) {
    const auto corner = [&](int i) {
      return static_cast<const Shader*>(shader)->vertex(mesh, triangle, (first + i) % 3);
    };
    const Varyings<float> value0 = corner(0);
    const Varyings<float> value1 = corner(1);
    const Varyings<float> value2 = corner(2);
    std::uint32_t bits = 0;
    for_each_number([&](int i) {
      const float at0 = number_of(value0, i);
      const float to1 = number_of(value1, i) - at0;
      const float to2 = number_of(value2, i) - at0;
      corners[i] = at0;
      corners[varying_count + i] = to1;
      corners[2 * varying_count + i] = to2;
      bits |= std::bit_cast<std::uint32_t>(to1) | std::bit_cast<std::uint32_t>(to2);
    });
    return bits << 1U != 0;  // but for signs
  }
  static constexpr CornerVaryings corner_varyings = {varying_count, reads_derivatives<Shader>(),
                                                     &write_corners, &write_record};

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
  using Own = OwnRecords<corner_varyings.record_size()>;

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

  /// One for all blocks, so that it isn't cleared for each.
  struct BlockColors {
    BlockMask mask = 0;                                     ///< of what the triangles cover
    BlockMask kept = 0;                                     ///< of that, what isn't discarded
    alignas(64) std::array<std::uint32_t, 64> packed = {};  ///< beside `mask`, anything
  };

  using Parts = std::span<const VisiblePart>;

  void shade_block(int block, BlockColors& colors) const {
    const Parts parts = triangles_.parts(block);
    colors.mask = seen_by(parts);
    colors.kept = 0;
    if (!triangles_.any_constant()) {
      if (!parts.empty()) shade_varying(block, parts, colors);
      return;
    }
    SomeParts varying;
    for (const VisiblePart& part : parts) {
      if (!triangles_.triangle(part.slot).is_constant) varying.add(part);
    }
    if (varying.count > 0) shade_varying(block, varying.parts(), colors);
    for (const VisiblePart& part : parts) {
      const ShadedTriangle& triangle = triangles_.triangle(part.slot);
      if (triangle.is_constant) paint(triangle, part.mask, colors);
    }
  }

  static BlockMask seen_by(Parts parts) {
    BlockMask mask = 0;
    for (const VisiblePart& part : parts) mask |= part.mask;
    return mask;
  }

  /// Some of a block's.
  struct SomeParts {
    std::size_t count = 0;
    std::array<VisiblePart, 64> part;

    void add(const VisiblePart& one) { part[count++] = one; }
    Parts parts() const { return std::span(part).first(count); }
  };

  static std::uint32_t pair_at(BlockMask mask, int first) {
    return static_cast<std::uint32_t>(mask >> first) & all_pair_lanes;
  }

  void shade_varying(int block, Parts varying, BlockColors& colors) const {
    count_unread(static_cast<std::size_t>(std::popcount(seen_by(varying))));
    if (varying.size() <= most_by_themselves) {
      shade_few(block, varying, colors);
    } else {
      shade_many(block, varying, colors);
    }
  }

  /// Up to this many, each is interpolated by itself.
  static constexpr std::size_t most_by_themselves = 2;

  void shade_few(int block, Parts varying, BlockColors& colors) const {
    WeightsInBlock weights;
    triangles_.weigh_few(varying, block, weights);
    const OneRecord one(triangles_, varying.front().slot);
    const OneRecord other(triangles_, varying.back().slot);
    const BlockMask seen = seen_by(varying);
    for (int first = 0; first < 64; first += 2 * lanes) {
      const std::uint32_t wanted = pair_at(seen, first);
      if (wanted == 0) continue;
      OneOrTwo few = {&one, nullptr, pair_at(varying.back().mask, first)};
      if (few.is_second == wanted) {
        few.first = &other;
      } else if (few.is_second != 0) {
        few.second = &other;
      }
      shade_pair({.few = &few}, &weights, first, wanted, colors);
    }
  }

  /// What a vector of pixels sees: the records of a table.
  struct SeenByVector {
    const Table* table;
    const RecordNumbers* numbers;

    EachRecord records(int first) const { return {table->word.data(), *numbers, first}; }
  };

  /// Their records in a table: one for the block, or, where it sees too many, one for two vectors
  /// or for each.
  void shade_many(int block, Parts varying, BlockColors& colors) const {
    std::array<Table, 2> table;
    std::array<RecordNumbers, 2> numbers;
    WeightsInBlock weights;
    const auto look_at = [&](Parts parts, std::size_t i, int first, int end) {
      table[i].fill(triangles_, parts);
      triangles_.number_pixels(parts, first, end, numbers[i]);
      triangles_.weigh_each(parts, table[i].word.data(), numbers[i], block, first, end, weights);
    };
    const bool in_one = varying.size() <= Table::most;
    if (in_one) look_at(varying, 0, 0, 64);
    const BlockMask mask = seen_by(varying);
    for (int first = 0; first < 64; first += 2 * lanes) {
      const std::uint32_t wanted = pair_at(mask, first);
      if (wanted == 0) continue;
      const int second = first + lanes;
      std::size_t high = 0;
      if (!in_one) {
        const SomeParts pair = seen_in(varying, first, 2 * lanes);
        if (pair.count <= Table::most) {
          look_at(pair.parts(), 0, first, second + lanes);
        } else {
          high = 1;
          look_at(seen_in(pair.parts(), first, lanes).parts(), 0, first, second);
          look_at(seen_in(pair.parts(), second, lanes).parts(), 1, second, second + lanes);
        }
      }
      const std::array<SeenByVector, 2> seen = {
          {{&table[0], &numbers[0]}, {&table[high], &numbers[high]}}};
      shade_pair({.many = &seen}, &weights, first, wanted, colors);
    }
  }

  /// In these pixels of a block. Where there are none, anything: lanes beside those that are
  /// wanted.
  static SomeParts seen_in(Parts varying, int first, int count) {
    const BlockMask pixels = (all_64 >> (64 - count)) << first;
    SomeParts here;
    for (const VisiblePart& part : varying) {
      const BlockMask mask = part.mask & pixels;
      if (mask != 0) here.add({mask, part.slot});
    }
    if (here.count == 0) here.add({BlockMask{1} << first, varying.front().slot});
    return here;
  }

  /// What two vectors of pixels see: one triangle, or one of two.
  struct OneOrTwo {
    const OneRecord* first;
    const OneRecord* second;  ///< nullptr: there is none
    std::uint32_t is_second;  ///< lanes of the pair
  };

  /// Or any number of them: those of two tables, or `own`, the slots of each pixel's.
  struct SeenByPair {
    const OneOrTwo* few = nullptr;
    const std::array<SeenByVector, 2>* many = nullptr;
    const std::int32_t* own = nullptr;
  };

  /// The whole pair gets a colour, what isn't wanted any.
  RASTERLAB_FLATTEN void shade_pair(const SeenByPair& seen, const WeightsInBlock* weights,
                                    int first, std::uint32_t wanted, BlockColors& colors) const {
    Point<NumberPair> point;
    find_point<reads_derivatives<Shader>()>(seen, weights, first, point);
    const Fragment<NumberPair> fragment = shade(point, wanted);
    write_bytes(fragment.color, colors.packed.data() + first);
    if constexpr (may_discard<Shader>) wanted &= ~bits_of(fragment.discarded);
    colors.kept |= BlockMask{wanted} << first;
    if (!leaves_out_unread_) work_out_all(seen, weights, first);
  }

  /// What the shader doesn't read, and what it reads once more.
  [[gnu::noinline]] void work_out_all(const SeenByPair& seen, const WeightsInBlock* weights,
                                      int first) const {
    Point<NumberPair> point;
    find_point<true>(seen, weights, first, point);
    keep(point);
  }
  void count_unread(std::size_t pixels) const {
    if (reads_derivatives<Shader>() || !leaves_out_unread_) return;
    statistics_.derivatives_unread += pixels * 2 * std::size_t{varying_count};
  }

  /// Without weights, of `own` that are the same all over: seen from the front by the first vector,
  /// from behind by the second. Written to `point`, where it stays: returned, it would be copied.
  template <bool derivatives>
  void find_point(const SeenByPair& seen, const WeightsInBlock* weights, int first,
                  Point<NumberPair>& point) const {
    if (const OneOrTwo* few = seen.few; few != nullptr) {
      const PixelWeights low = weights->at(first);
      const PixelWeights high = weights->at(first + lanes);
      if (few->second == nullptr) {
        point = join(surface_point<derivatives>(low, *few->first),
                     surface_point<derivatives>(high, *few->first));
      } else {
        const auto one_of_two = [few](std::uint32_t is_second) {
          return OneOfTwoRecords(*few->first, *few->second, truth_of(is_second));
        };
        point = join(surface_point<derivatives>(low, one_of_two(few->is_second)),
                     surface_point<derivatives>(high, one_of_two(few->is_second >> lanes)));
      }
    } else if (seen.many != nullptr) {
      const EachRecord low = (*seen.many)[0].records(first);
      const EachRecord high = (*seen.many)[1].records(first + lanes);
      point = join(surface_point<derivatives>(weights->at(first), low),
                   surface_point<derivatives>(weights->at(first + lanes), high));
    } else {
      const Own low(triangles_, seen.own);
      const Own high(triangles_, seen.own + lanes);
      if (weights != nullptr) {
        point = join(surface_point<derivatives>(weights->at(first), low),
                     surface_point<derivatives>(weights->at(first + lanes), high));
      } else {
        point = join(constant_point(low, truth_of(all_lanes)), constant_point(high, truth_of(0)));
      }
    }
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

  // -------------------------------------------------------------------------------------------
  // Scattered pixels

  void shade_scattered() {
    ScatteredPixels& pixels = triangles_.scattered();
    if (pixels.count == 0) return;
    statistics_.pixels_shaded += pixels.count;
    if (triangles_.any_constant()) triangles_.paint_scattered();
    for (std::size_t first = 0; first < pixels.count; first += 64) {
      shade_some_scattered(first, std::min<std::size_t>(64, pixels.count - first), pixels);
    }
    for (int block = 0; block < block_count_; ++block) {
      const auto b = static_cast<std::size_t>(block);
      triangles_.write_colors(block, pixels.color.data() + 64 * b, pixels.in_block[b]);
    }
  }

  void shade_some_scattered(std::size_t first, std::size_t count, ScatteredPixels& pixels) const {
    count_unread(count);
    WeightsInBlock weights;
    triangles_.weigh_scattered(first, weights);
    BlockColors colors;
    for (std::size_t i = 0; i < count; i += 2 * lanes) {
      const std::size_t pair = std::min<std::size_t>(2 * lanes, count - i);
      const std::uint32_t wanted = all_pair_lanes >> (2 * lanes - pair);
      shade_pair({.own = &pixels.slot[first + i]}, &weights, static_cast<int>(i), wanted, colors);
      for (std::size_t j = i; j < i + pair; ++j) {
        pixels.color[static_cast<std::size_t>(pixels.place[first + j])] = colors.packed[j];
      }
    }
  }

  // -------------------------------------------------------------------------------------------
  // Triangles that are the same all over

  /// Triangles that are the same all over get their colour here, a vector of them at a time.
  void shade_constant_triangles() {
    std::array<std::int32_t, lanes> slot = {};
    std::size_t count = 0;
    for (std::int32_t i = triangles_.first_new_slot(); i < triangles_.slot_count(); ++i) {
      if (!triangles_.triangle(i).is_constant) continue;
      slot[count++] = i;
      if (count < slot.size()) continue;
      shade_constant(slot);
      count = 0;
    }
    if (count > 0) shade_constant(std::span(slot).first(count));
  }

  /// Each from its front and from its back: hardly a shader sees a difference, and where none does,
  /// nobody has to know which is seen.
  void shade_constant(std::span<const std::int32_t> slot) {
    std::array<std::int32_t, 2 * lanes> own;
    for (std::size_t i = 0; i < lanes; ++i) {
      own[i] = own[i + lanes] = slot[std::min(i, slot.size() - 1)];
    }
    const std::uint32_t wanted = all_lanes >> (lanes - static_cast<int>(slot.size()));
    BlockColors colors;
    shade_pair({.own = own.data()}, nullptr, 0, wanted | wanted << lanes, colors);
    const auto is_discarded = [&](std::size_t i) { return (colors.kept >> i & 1U) == 0; };
    for (std::size_t i = 0; i < slot.size(); ++i) {
      const std::size_t behind = i + lanes;
      const bool alike =
          colors.packed[i] == colors.packed[behind] && is_discarded(i) == is_discarded(behind);
      const std::size_t seen = alike || triangles_.shows_front(slot[i]) ? i : behind;
      ShadedTriangle& triangle = triangles_.triangle(slot[i]);
      triangle.color = colors.packed[seen];
      triangle.is_discarded = is_discarded(seen);
    }
  }

  // -------------------------------------------------------------------------------------------
  // What a pixel sees

  static Point<Number> constant_point(const Own& records, Truth front_facing) {
    Point<Number> point;
    interpolate({Number(0), Number(0), Number(0)}, records, point.value);
    set_no_derivatives(point);
    point.front_facing = front_facing;
    return point;
  }

  /// Eigen's vectors are not zero of themselves.
  static void set_no_derivatives(Point<Number>& point) {
    for_each_number([&](int i) { number_of(point.dx, i) = number_of(point.dy, i) = Number(0); });
  }

  template <bool derivatives, class Record>
  static Point<Number> surface_point(const PixelWeights& weights, const Record& r) {
    Point<Number> point;
    interpolate(weights, r, point.value);
    if constexpr (derivatives) {
      differentiate(derivative(r, word::step1_x, word::step2_x), weights, r, point.dx);
      differentiate(derivative(r, word::step1_y, word::step2_y), weights, r, point.dy);
    } else {
      set_no_derivatives(point);
    }
    point.front_facing = r.front_facing();
    return point;
  }

  /// Of q_1, q_2 and, negative, the sum of all q.
  struct Derivatives {
    Number q1, q2, minus_sum;
  };
  template <class Record>
  static Derivatives derivative(const Record& r, int step1, int step2) {
    const Number e1 = as_numbers(r.integer(step1)) * Number(256);
    const Number e2 = as_numbers(r.integer(step2)) * Number(256);
    const Number q1 = e1 * r.number(word::ratio1);
    const Number q2 = e2 * r.number(word::ratio2);
    return {q1, q2, (e1 - q1) + (e2 - q2)};
  }

  template <class Record>
  static void interpolate(const PixelWeights& weights, const Record& r, Varyings<Number>& value) {
    for_each_number([&](int i) {
      const Number by_2 = fused_multiply_add(weights.b2, to_2(r, i), at_0(r, i));
      number_of(value, i) = fused_multiply_add(weights.b1, to_1(r, i), by_2);
    });
  }

  /// With a = a0 + (q1·d1 + q2·d2) / Q: a' = (q1'·d1 + q2'·d2 − (a − a0)·Q') / Q.
  template <class Record>
  static void differentiate(const Derivatives& d, const PixelWeights& weights, const Record& r,
                            Varyings<Number>& result) {
    for_each_number([&](int i) {
      const Number from_0 = fused_multiply_add(weights.b1, to_1(r, i), weights.b2 * to_2(r, i));
      const Number steps = fused_multiply_add(d.q1, to_1(r, i), d.q2 * to_2(r, i));
      number_of(result, i) = fused_multiply_add(from_0, d.minus_sum, steps) * weights.inverse;
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

  static void write_bytes(const Vector3<NumberPair>& color, std::uint32_t* packed) {
    store(pack_color(color.x().low, color.y().low, color.z().low), packed);
    store(pack_color(color.x().high, color.y().high, color.z().high), packed + lanes);
  }

  const Shader& shader_;
  VisibleTriangles triangles_;
  int block_count_;
  bool leaves_out_unread_;
  Statistics& statistics_;
};

template <class Shader>
void shade_tile(const DrawJob& job, const Tile& tile, Worker& worker) {
  TileShading<Shader>(job, tile, worker).run();
}

template <class Shader>
BlockMask shade_now(const DrawJob& job, const Tile& block, std::uint32_t key, BlockMask pixels,
                    Worker& worker) {
  return TileShading<Shader>(job, block, worker).shade_one(key, pixels, block.color != nullptr);
}

/// The functions a shader is compiled to, for this file's instruction set.
template <class Shader>
inline constexpr ShadingKernels kernels_of = {&shade_tile<Shader>, &shade_now<Shader>,
                                              may_discard<Shader>};

template <class Shader>
const ShadingKernels& shading_kernels() {
  return kernels_of<Shader>;
}

}  // namespace rasterlab::RASTERLAB_SIMD

#undef RASTERLAB_FLATTEN

/// Compiles a shader for this file's instruction set. Outside all namespaces.
#define RASTERLAB_SHADER(Shader) \
  template const rasterlab::ShadingKernels& rasterlab::RASTERLAB_SIMD::shading_kernels<Shader>();
