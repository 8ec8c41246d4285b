// Shading: what is seen in a tile becomes colours, each pixel once.
//
// The depth pass left the number of the nearest triangle in every pixel. Here the tile's triangles
// are collected, each is set up once (its exact edge functions, the ratios of its w, vertex() for
// its corners), and then pixels are shaded, as many at a time as there are lanes.
//
// A pixel's barycentric weights come from the exact integer edge functions in double: with
// q_i = E_i · w0/w_i the perspective-correct weights are q_i / (q_0 + q_1 + q_2). They become
// floats last, so they are right to half a unit in the last place for slivers and for any ratio of
// w.
#pragma once

#include "common/engine/kernels.h"
#include "common/engine/shading.h"
#include "common/engine/window_vertex.h"
#include "common/mesh/shader_types.h"

#include <bit>
#include <concepts>

namespace rasterlab::RASTERLAB_SIMD {

/// A triangle's geometry as doubles in memory, for the tile it is seen in; edges 1 and 2 face
/// corners 1 and 2 and are positive inside.
namespace field {
enum : int { edge1, edge2, step1_x, step1_y, step2_x, step2_y, area, ratio1, ratio2, front, size };
}

/// As many triangles as there are lanes: their window corners and w.
struct TriangleLanes {
  std::array<Ints, 3> x;
  std::array<Ints, 3> y;
  std::array<Number, 3> w;
};

using Geometry = std::array<Doubles, field::size>;

/// The geometry relative to a tile's first pixel.
inline Geometry geometry_of(const TriangleLanes& t, int left, int top, bool mirrored) {
  std::array<Doubles, 3> x;
  std::array<Doubles, 3> y;
  for (std::size_t i = 0; i < 3; ++i) {
    x[i] = to_doubles(t.x[i]);
    y[i] = to_doubles(t.y[i]);
  }
  const Doubles px(left * 256.0 + 128);
  const Doubles py(top * 256.0 + 128);
  const Doubles signed_area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
  // Exact as float: only the sign is asked for.
  const Truth clockwise = to_number(signed_area) > Number(0);
  const Doubles side = to_doubles(select(clockwise, Number(1), Number(-1)));
  Geometry g;
  // Edge 1 runs from corner 2 to 0, edge 2 from 0 to 1.
  g[field::edge1] = side * ((x[0] - x[2]) * (py - y[2]) - (y[0] - y[2]) * (px - x[2]));
  g[field::edge2] = side * ((x[1] - x[0]) * (py - y[0]) - (y[1] - y[0]) * (px - x[0]));
  const Doubles step = side * Doubles(256);
  g[field::step1_x] = step * (y[2] - y[0]);
  g[field::step1_y] = step * (x[0] - x[2]);
  g[field::step2_x] = step * (y[0] - y[1]);
  g[field::step2_y] = step * (x[1] - x[0]);
  g[field::area] = side * signed_area;
  const Doubles w0 = to_doubles(t.w[0]);
  g[field::ratio1] = w0 / to_doubles(t.w[1]);
  g[field::ratio2] = w0 / to_doubles(t.w[2]);
  g[field::front] = to_doubles(mirrored ? select(clockwise, Number(1), Number(0))
                                        : select(clockwise, Number(0), Number(1)));
  return g;
}

/// Shades the tiles of one draw call.
template <class Shader>
class TileShading {
 public:
  template <class N>
  using Varyings = typename Shader::template Varyings<N>;
  template <class N>
  using Point = SurfacePoint<Shader::template Varyings, N>;
  static constexpr int varying_count = number_count<Shader::template Varyings>();
  static constexpr int varying_stride = varying_count * 3;

  TileShading(const DrawJob& job, const Tile& tile, Worker& worker)
      : job_(job),
        shader_(*static_cast<const Shader*>(job.shader)),
        mesh_(job.mesh->mesh()),
        tile_(tile),
        blocks_shift_(std::countr_zero(static_cast<unsigned>(tile.blocks_per_row()))),
        scratch_(worker.scratch),
        statistics_(worker.statistics) {}

  void run() {
    collect_triangles();
    set_up_triangles();
    resolve_clipped_pixels();
    shade_pixels();
  }

  /// For one triangle: which of the pixels of a block the shader keeps.
  BlockMask keep(std::uint32_t key, BlockMask covered) {
    scratch_.slot.assign(64, -1);
    scratch_.key.assign(1, key);
    for (BlockMask rest = covered; rest != 0; rest &= rest - 1) {
      scratch_.slot[static_cast<std::size_t>(std::countr_zero(rest))] = 0;
    }
    set_up_triangles();
    resolve_clipped_pixels();
    BlockMask kept = 0;
    for (int pixel = 0; pixel < 64; pixel += lanes) {
      const Ints slot = load(scratch_.slot.data() + pixel);
      const Truth wanted = slot >= Ints(0);
      if (!any(wanted)) continue;
      const auto result = fragments<false>(pixel, maximum(slot, Ints(0)), wanted);
      kept |= static_cast<BlockMask>(bits(wanted && !result.discarded)) << pixel;
    }
    return kept & covered;
  }

 private:
  std::uint32_t triangle_of(std::uint32_t key) const { return key - job_.first_key; }

  // -------------------------------------------------------------------------------------------
  // Which triangles are seen

  /// Fills slot and key. Pixels of earlier draw calls, or of none, get slot −1.
  void collect_triangles() {
    const int pixels = tile_.size * tile_.size;
    scratch_.slot.resize(static_cast<std::size_t>(pixels));
    scratch_.table.resize(table_size);
    scratch_.key.clear();
    for (int block = 0; block < tile_.block_count(); ++block) {
      const std::uint32_t* key = tile_.key + block * 64;
      std::int32_t* slot = scratch_.slot.data() + block * 64;
      if (same_everywhere(key)) {
        std::fill_n(slot, 64, slot_of(key[0]));
      } else {
        collect_block(key, slot);
      }
    }
  }

  static bool same_everywhere(const std::uint32_t* key) {
    const Ints first(static_cast<std::int32_t>(key[0]));
    Truth same = load(key) == first;
    for (int pixel = lanes; pixel < 64; pixel += lanes) same = same && load(key + pixel) == first;
    return all(same);
  }

  void collect_block(const std::uint32_t* key, std::int32_t* slot) {
    slot[0] = slot_of(key[0]);
    for (int i = 1; i < 64; ++i) {
      if (key[i] == key[i - 1]) {
        slot[i] = slot[i - 1];
      } else if (i >= 8 && key[i] == key[i - 8]) {
        slot[i] = slot[i - 8];
      } else {
        slot[i] = slot_of(key[i]);
      }
    }
  }

  /// A table entry is believed when the list of keys confirms it, so it need not be cleared; a
  /// triangle that lost its entry to another is only set up twice.
  std::int32_t slot_of(std::uint32_t key) {
    if (key < job_.first_key) return -1;
    std::uint32_t& entry = scratch_.table[(key * 2654435761U) >> (32 - table_bits)];
    if (entry >= scratch_.key.size() || scratch_.key[entry] != key) {
      entry = static_cast<std::uint32_t>(scratch_.key.size());
      scratch_.key.push_back(key);
    }
    return static_cast<std::int32_t>(entry);
  }

  static constexpr int table_bits = 12;
  static constexpr std::size_t table_size = std::size_t{1} << table_bits;

  // -------------------------------------------------------------------------------------------
  // Setting them up

  void set_up_triangles() {
    const std::size_t count = scratch_.key.size();
    scratch_.clipped.clear();
    reserve_slots(count);
    for (std::size_t first = 0; first < count; first += lanes) {
      set_up(first, std::min<std::size_t>(lanes, count - first));
    }
    statistics_.triangles_shaded += count;
  }

  /// Geometry and varyings stand side by side for as many triangles as there are lanes.
  void reserve_slots(std::size_t count) {
    const std::size_t packets = (count + lanes - 1) / lanes;
    if (scratch_.geometry.size() < packets * field::size * lanes) {
      scratch_.geometry.resize(packets * field::size * lanes);
    }
    if (scratch_.varyings.size() < packets * varying_stride * lanes) {
      scratch_.varyings.resize(packets * varying_stride * lanes);
    }
  }

  /// The mesh's triangles in these lanes; corner 0 is the one with the lowest vertex index.
  struct CornerLanes {
    std::array<Ints, 3> vertex;
    Ints first;  ///< which of the mesh's corners is corner 0
  };

  CornerLanes corner_order(Ints triangle) const {
    const auto* flat = reinterpret_cast<const std::int32_t*>(mesh_.triangles.data());
    const Ints at = triangle * Ints(3);
    const Ints a = gather_ints(flat, at);
    const Ints b = gather_ints(flat + 1, at);
    const Ints c = gather_ints(flat + 2, at);
    const Truth from_b = b < a && b <= c;
    const Truth from_c = !from_b && c < a && c < b;
    return {{select(from_b, b, select(from_c, c, a)), select(from_b, c, select(from_c, a, b)),
             select(from_b, a, select(from_c, b, c))},
            select(from_b, Ints(1), select(from_c, Ints(2), Ints(0)))};
  }

  std::array<Number, 3> position(Ints vertex) const {
    const auto* flat = reinterpret_cast<const float*>(mesh_.positions.data());
    const Ints at = vertex * Ints(3);
    return {gather_numbers(flat, at), gather_numbers(flat + 1, at), gather_numbers(flat + 2, at)};
  }

  void set_up(std::size_t first_slot, std::size_t count) {
    std::array<std::uint32_t, lanes> key;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      key[lane] = scratch_.key[first_slot + std::min(lane, count - 1)];
    }
    const CornerLanes corners =
        corner_order(load(key.data()) - Ints(static_cast<std::int32_t>(job_.first_key)));
    TriangleLanes triangles;
    Truth direct = !false_everywhere();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::array<Number, 3> p = position(corners.vertex[i]);
      const ClipPoints clip = to_clip(job_.transform, p[0], p[1], p[2]);
      const WindowPoints window = to_window(job_.transform, clip);
      direct = direct && window.direct;
      triangles.x[i] = window.x;
      triangles.y[i] = window.y;
      triangles.w[i] = clip.w;
    }
    const Geometry geometry = geometry_of(triangles, tile_.left, tile_.top, job_.mirrored);
    double* to = scratch_.geometry.data() + first_slot * field::size;
    for (std::size_t i = 0; i < field::size; ++i) store(geometry[i], to + i * lanes);
    std::array<std::int32_t, lanes> first;
    store(corners.first, first.data());
    const std::uint32_t usable = bits(direct);
    for (std::size_t lane = 0; lane < count; ++lane) {
      const std::size_t slot = first_slot + lane;
      if ((usable >> lane & 1U) == 0) {
        scratch_.clipped.push_back(static_cast<std::uint32_t>(slot));
      } else {
        write_varyings(corner_varyings(triangle_of(key[lane]), first[lane]), slot);
      }
    }
  }

  using Corners = std::array<std::array<float, static_cast<std::size_t>(varying_count) + 1>, 3>;

  Corners corner_varyings(std::uint32_t triangle, int first) const {
    Corners corners{};  // a shader without varyings copies nothing into it
    for (int i = 0; i < 3; ++i) {
      const Varyings<float> value = shader_.vertex(mesh_, triangle, (first + i) % 3);
      const float* from = numbers<Shader::template Varyings, float>(value);
      std::copy_n(from, varying_count, corners[static_cast<std::size_t>(i)].data());
    }
    return corners;
  }

  /// Per number: its value at corner 0, and how much it differs at corners 1 and 2.
  void write_varyings(const Corners& corners, std::size_t slot) {
    float* to = scratch_.varyings.data() + slot / lanes * lanes * varying_stride + slot % lanes;
    for (std::size_t i = 0; i < static_cast<std::size_t>(varying_count); ++i) {
      to[3 * i * lanes] = corners[0][i];
      to[(3 * i + 1) * lanes] = corners[1][i] - corners[0][i];
      to[(3 * i + 2) * lanes] = corners[2][i] - corners[0][i];
    }
  }

  // -------------------------------------------------------------------------------------------
  // Triangles that were clipped: their pixels belong to one of the parts

  void resolve_clipped_pixels() {
    std::size_t next_slot = (scratch_.key.size() + lanes - 1) / lanes * lanes;
    for (const std::uint32_t whole : scratch_.clipped) {
      const std::uint32_t triangle = triangle_of(scratch_.key[whole]);
      const CornerLanes order = corner_order(Ints(static_cast<std::int32_t>(triangle)));
      TrianglePositions positions;
      for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector3f& p =
            mesh_.positions[static_cast<std::size_t>(hn::GetLane(order.vertex[i].v))];
        positions[i] = {p.x(), p.y(), p.z()};
      }
      const ClippedPolygon polygon = clip_triangle(job_.transform, positions);
      const Corners corners = corner_varyings(triangle, hn::GetLane(order.first.v));
      for_each_part(job_.transform, polygon, [&](const ClippedPart& part) {
        if (twice_area(part.snapped[0], part.snapped[1], part.snapped[2]) == 0) return;
        add_part(part, corners, static_cast<std::int32_t>(whole), next_slot);
        ++next_slot;
      });
    }
  }

  void add_part(const ClippedPart& part, const Corners& corners, std::int32_t whole,
                std::size_t slot) {
    reserve_slots(slot + 1);
    TriangleLanes lanes_of_part;
    Corners values{};
    for (std::size_t c = 0; c < 3; ++c) {
      const ClippedCorner& corner = *part.corner[c];
      lanes_of_part.x[c] = Ints(part.snapped[c].x);
      lanes_of_part.y[c] = Ints(part.snapped[c].y);
      lanes_of_part.w[c] = Number(corner.w);
      for (std::size_t i = 0; i < static_cast<std::size_t>(varying_count); ++i) {
        const double a0 = corners[0][i];
        values[c][i] = static_cast<float>(
            a0 + (corner.b1 * (corners[1][i] - a0) + corner.b2 * (corners[2][i] - a0)));
      }
    }
    const Geometry vectors = geometry_of(lanes_of_part, tile_.left, tile_.top, job_.mirrored);
    std::array<double, field::size> geometry;
    double* to = scratch_.geometry.data() + slot / lanes * lanes * field::size + slot % lanes;
    for (std::size_t i = 0; i < field::size; ++i) {
      geometry[i] = hn::GetLane(vectors[i].low);
      to[i * lanes] = geometry[i];
    }
    write_varyings(values, slot);
    for (std::size_t pixel = 0; pixel < scratch_.slot.size(); ++pixel) {
      if (scratch_.slot[pixel] == whole && covers(geometry, static_cast<int>(pixel))) {
        scratch_.slot[pixel] = static_cast<std::int32_t>(slot);
      }
    }
  }

  /// Boundaries included: the depth pass has decided already that the pixel is this triangle's.
  bool covers(const std::array<double, field::size>& geometry, int pixel) const {
    const auto [x, y] = place_of(pixel);
    const double e1 =
        geometry[field::edge1] + x * geometry[field::step1_x] + y * geometry[field::step1_y];
    const double e2 =
        geometry[field::edge2] + x * geometry[field::step2_x] + y * geometry[field::step2_y];
    return e1 >= 0 && e2 >= 0 && e1 + e2 <= geometry[field::area];
  }

  struct Place {
    int x, y;
  };
  Place place_of(int pixel) const {
    const int block = pixel >> 6;
    return {(block & (tile_.blocks_per_row() - 1)) * 8 + (pixel & 7),
            (block >> blocks_shift_) * 8 + (pixel >> 3 & 7)};
  }

  // -------------------------------------------------------------------------------------------
  // Shading

  /// Where to find a slot's entries, `stride` to a triangle.
  static Ints entry_of(Ints slot, int stride) {
    constexpr int shift = std::countr_zero(static_cast<unsigned>(lanes));
    return shift_right<shift>(slot) * Ints(stride * lanes) + (slot & Ints(lanes - 1));
  }

  /// The same field of each lane's triangle; of a single one when all lanes show the same.
  template <bool uniform>
  Doubles geometry(Ints entry, int name) const {
    const double* from = scratch_.geometry.data() + name * lanes;
    if constexpr (uniform) return Doubles(from[hn::GetLane(entry.v)]);
    return gather_doubles(from, entry);
  }
  template <bool uniform>
  Number varying(Ints entry, int name) const {
    const float* from = scratch_.varyings.data() + name * lanes;
    if constexpr (uniform) return Number(from[hn::GetLane(entry.v)]);
    return gather_numbers(from, entry);
  }

  template <bool uniform>
  Point<Number> surface_point(int pixel, Ints slot) const {
    const Place block = place_of(pixel & ~63);
    const Ints in_block = iota(pixel & 63);
    const Doubles x = to_doubles((in_block & Ints(7)) + Ints(block.x));
    const Doubles y = to_doubles(shift_right<3>(in_block) + Ints(block.y));
    const Ints entry = entry_of(slot, field::size);
    const auto get = [&](int name) { return geometry<uniform>(entry, name); };
    const Doubles step1_x = get(field::step1_x);
    const Doubles step1_y = get(field::step1_y);
    const Doubles step2_x = get(field::step2_x);
    const Doubles step2_y = get(field::step2_y);
    const Doubles ratio1 = get(field::ratio1);
    const Doubles ratio2 = get(field::ratio2);
    const Doubles e1 = get(field::edge1) + (x * step1_x + y * step1_y);
    const Doubles e2 = get(field::edge2) + (x * step2_x + y * step2_y);
    const Doubles e0 = get(field::area) - (e1 + e2);
    const Doubles q1 = e1 * ratio1;
    const Doubles q2 = e2 * ratio2;
    const Doubles inverse = Doubles(1) / (e0 + (q1 + q2));
    const Doubles b1 = q1 * inverse;
    const Doubles b2 = q2 * inverse;
    // (q1 / Q)' = (q1' − b1 · Q') / Q
    const auto derivative = [&](Doubles step1, Doubles step2) {
      const Doubles dq1 = step1 * ratio1;
      const Doubles dq2 = step2 * ratio2;
      const Doubles sum = (dq1 + dq2) - (step1 + step2);
      return CornerWeights<Number>{to_number((dq1 - b1 * sum) * inverse),
                                   to_number((dq2 - b2 * sum) * inverse)};
    };
    Point<Number> point;
    interpolate<uniform>(entry_of(slot, varying_stride), {to_number(b1), to_number(b2)},
                         derivative(step1_x, step2_x), derivative(step1_y, step2_y), point);
    point.front_facing = to_number(get(field::front)) > Number(0);
    return point;
  }

  template <bool uniform>
  void interpolate(Ints entry, CornerWeights<Number> value, CornerWeights<Number> dx,
                   CornerWeights<Number> dy, Point<Number>& point) const {
    if constexpr (varying_count > 0) {
      for (int i = 0; i < varying_count; ++i) {
        const Number at_0 = varying<uniform>(entry, 3 * i);
        const Number to_1 = varying<uniform>(entry, 3 * i + 1);
        const Number to_2 = varying<uniform>(entry, 3 * i + 2);
        numbers<Shader::template Varyings, Number>(point.value)[i] =
            at_0 + (value.b1 * to_1 + value.b2 * to_2);
        numbers<Shader::template Varyings, Number>(point.dx)[i] = dx.b1 * to_1 + dx.b2 * to_2;
        numbers<Shader::template Varyings, Number>(point.dy)[i] = dy.b1 * to_1 + dy.b2 * to_2;
      }
    }
  }

  /// Lanes of a few different triangles: each triangle is taken for all lanes, which is cheaper
  /// than fetching every field lane by lane.
  Point<Number> mixed_surface_point(int pixel, Ints slot) const {
    std::array<std::int32_t, lanes> slot_of_lane;
    store(slot, slot_of_lane.data());
    std::array<Ints, most_mixed> others;
    int count = 0;
    const Ints first(slot_of_lane[0]);
    for (std::uint32_t rest = bits(!(slot == first)); rest != 0; ++count) {
      if (count == most_mixed) return surface_point<false>(pixel, slot);
      const Ints other(slot_of_lane[static_cast<std::size_t>(std::countr_zero(rest))]);
      others[static_cast<std::size_t>(count)] = other;
      rest &= ~bits(slot == other);
    }
    Point<Number> point = surface_point<true>(pixel, first);
    for (int i = 0; i < count; ++i) {
      const Ints other = others[static_cast<std::size_t>(i)];
      replace(slot == other, surface_point<true>(pixel, other), point);
    }
    return point;
  }

  static constexpr int most_mixed = 3;

  static void replace(Truth here, const Point<Number>& by, Point<Number>& point) {
    const auto replace_numbers = [&](const Varyings<Number>& from, Varyings<Number>& to) {
      if constexpr (varying_count > 0) {
        for (int i = 0; i < varying_count; ++i) {
          Number& number = numbers<Shader::template Varyings, Number>(to)[i];
          number = select(here, numbers<Shader::template Varyings, Number>(from)[i], number);
        }
      }
    };
    replace_numbers(by.value, point.value);
    replace_numbers(by.dx, point.dx);
    replace_numbers(by.dy, point.dy);
    point.front_facing = select(here, by.front_facing, point.front_facing);
  }

  /// Colours, and what is discarded, of as many pixels as there are lanes.
  template <bool uniform>
  Fragment<Number> fragments(int pixel, Ints slot, Truth wanted) const {
    return shade(uniform ? surface_point<true>(pixel, slot) : mixed_surface_point(pixel, slot),
                 wanted);
  }

  Fragment<Number> shade(const Point<Number>& point, Truth wanted) const {
    if constexpr (!ShadesNumbers<Shader, Number>) {
      return lane_by_lane(point, wanted);
    } else if constexpr (may_discard<Shader>) {
      return shader_.fragment(point);
    } else {
      return {shader_.fragment(point), false_everywhere()};
    }
  }

  static Truth false_everywhere() { return Ints(0) < Ints(0); }

  /// For a shader that only knows floats.
  Fragment<Number> lane_by_lane(const Point<Number>& point, Truth wanted) const {
    std::array<std::array<float, lanes>, 3> color = {};
    std::uint32_t discarded = 0;
    const std::uint32_t front = bits(point.front_facing);
    for (std::uint32_t rest = bits(wanted); rest != 0; rest &= rest - 1) {
      const int lane = std::countr_zero(rest);
      Point<float> one;
      copy_lane(point.value, lane, one.value);
      copy_lane(point.dx, lane, one.dx);
      copy_lane(point.dy, lane, one.dy);
      one.front_facing = (front >> lane & 1U) != 0;
      Vector3<float> result;
      if constexpr (may_discard<Shader>) {
        const Fragment<float> fragment = shader_.fragment(one);
        result = fragment.color;
        discarded |= static_cast<std::uint32_t>(fragment.discarded) << lane;
      } else {
        result = shader_.fragment(one);
      }
      for (int c = 0; c < 3; ++c) {
        color[static_cast<std::size_t>(c)][static_cast<std::size_t>(lane)] = result[c];
      }
    }
    return {{load(color[0].data()), load(color[1].data()), load(color[2].data())},
            truth_of(discarded)};
  }

  static void copy_lane(const Varyings<Number>& from, int lane, Varyings<float>& to) {
    if constexpr (varying_count > 0) {
      for (int i = 0; i < varying_count; ++i) {
        std::array<float, lanes> values;
        store(numbers<Shader::template Varyings, Number>(from)[i], values.data());
        numbers<Shader::template Varyings, float>(to)[i] = values[static_cast<std::size_t>(lane)];
      }
    }
  }

  [[gnu::flatten]] void shade_pixels() {
    const int pixels = tile_.size * tile_.size;
    for (int pixel = 0; pixel < pixels; pixel += lanes) {
      const Ints slot = load(scratch_.slot.data() + pixel);
      const Truth owned = slot >= Ints(0);
      const std::uint32_t mask = bits(owned);
      if (mask == 0) continue;
      // Lanes of other draw calls shade some triangle of this one, for nothing.
      const std::int32_t some = scratch_.slot[static_cast<std::size_t>(pixel) +
                                              static_cast<std::size_t>(std::countr_zero(mask))];
      const Ints used = select(owned, slot, Ints(some));
      const Fragment<Number> result = all(used == Ints(some))
                                          ? fragments<true>(pixel, Ints(some), owned)
                                          : fragments<false>(pixel, used, owned);
      write_colors(pixel, result.color, mask);
      statistics_.pixels_shaded += static_cast<unsigned>(std::popcount(mask));
    }
  }

  /// [0, 1] to 0…255 as to_byte() does.
  static Ints bytes(Number value) {
    const Ints byte = to_whole(minimum(value, Number(1)) * Number(255) + Number(0.5F));
    return select(value > Number(0), byte, Ints(0));
  }

  void write_colors(int pixel, const Vector3<Number>& color, std::uint32_t mask) const {
    alignas(64) std::array<std::uint32_t, lanes> packed;
    store(bytes(color.x()) | shift_left<8>(bytes(color.y())) | shift_left<16>(bytes(color.z())),
          packed.data());
    const Place block = place_of(pixel & ~63);
    const bool whole = block.x + 8 <= tile_.width && block.y + 8 <= tile_.height;
    if (lanes == 16 && whole && mask == 0xFFFFU) {
      Rgb8* row = tile_.color + (block.y + (pixel >> 3 & 7)) * tile_.stride + block.x;
      write_row(packed.data(), row);
      write_row(packed.data() + 8 % lanes, row + tile_.stride);
      return;
    }
    for (; mask != 0; mask &= mask - 1) {
      const int lane = std::countr_zero(mask);
      const auto [x, y] = place_of(pixel + lane);
      if (x >= tile_.width || y >= tile_.height) continue;
      tile_.color[y * tile_.stride + x] = unpacked(packed[static_cast<std::size_t>(lane)]);
    }
  }

  static Rgb8 unpacked(std::uint32_t color) {
    return {static_cast<std::uint8_t>(color), static_cast<std::uint8_t>(color >> 8U),
            static_cast<std::uint8_t>(color >> 16U)};
  }

  /// Eight pixels: four bytes at a time, of which the next pixel overwrites the last; but for the
  /// eighth, whose neighbour may be another thread's.
  static void write_row(const std::uint32_t* packed, Rgb8* row) {
    auto* bytes_of_row = reinterpret_cast<std::uint8_t*>(row);
    for (std::size_t i = 0; i < 7; ++i) std::memcpy(bytes_of_row + 3 * i, packed + i, 4);
    row[7] = unpacked(packed[7]);
  }

  const DrawJob& job_;
  const Shader& shader_;
  const Mesh& mesh_;
  const Tile& tile_;
  int blocks_shift_;
  ShadingScratch& scratch_;
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
inline constexpr ShadingKernels kernels_of = {may_discard<Shader>, &shade_tile<Shader>,
                                              &keep<Shader>};

template <class Shader>
const ShadingKernels& shading_kernels() {
  return kernels_of<Shader>;
}

}  // namespace rasterlab::RASTERLAB_SIMD

/// Compiles a shader for this file's instruction set. Outside all namespaces.
#define RASTERLAB_SHADER(Shader) \
  template const rasterlab::ShadingKernels& rasterlab::RASTERLAB_SIMD::shading_kernels<Shader>();
