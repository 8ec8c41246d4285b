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

/// The triangle, in the mesh, whose geometry is asked for; corner 0 is the one with the lowest
/// vertex index.
struct CornerOrder {
  std::array<std::uint32_t, 3> vertex;
  int first;  ///< which of the mesh's corners is corner 0
};

inline CornerOrder corner_order(const Mesh& mesh, std::uint32_t triangle) {
  const Mesh::Triangle& t = mesh.triangles[triangle];
  const int first = t[1] < t[0] && t[1] <= t[2] ? 1 : t[2] < t[0] && t[2] < t[1] ? 2 : 0;
  const auto at = [&](int i) { return t[static_cast<std::size_t>((first + i) % 3)]; };
  return {{at(0), at(1), at(2)}, first};
}

/// Writes the geometry of a triangle with the given corners, relative to a tile's first pixel.
inline void write_geometry(const std::array<SnappedCorner, 3>& c, const std::array<float, 3>& w,
                           int left, int top, bool mirrored, double* geometry) {
  const auto dx = [&](int a, int b) { return static_cast<double>(c[b].x - c[a].x); };
  const auto dy = [&](int a, int b) { return static_cast<double>(c[b].y - c[a].y); };
  const double px = left * 256.0 + 128;
  const double py = top * 256.0 + 128;
  const double signed_area = dx(0, 1) * dy(0, 2) - dy(0, 1) * dx(0, 2);
  const double side = signed_area < 0 ? -1 : 1;
  // Edge 1 runs from corner 2 to 0, edge 2 from 0 to 1.
  geometry[field::edge1] = side * (dx(2, 0) * (py - c[2].y) - dy(2, 0) * (px - c[2].x));
  geometry[field::edge2] = side * (dx(0, 1) * (py - c[0].y) - dy(0, 1) * (px - c[0].x));
  geometry[field::step1_x] = side * -256 * dy(2, 0);
  geometry[field::step1_y] = side * 256 * dx(2, 0);
  geometry[field::step2_x] = side * -256 * dy(0, 1);
  geometry[field::step2_y] = side * 256 * dx(0, 1);
  geometry[field::area] = side * signed_area;
  geometry[field::ratio1] = static_cast<double>(w[0]) / w[1];
  geometry[field::ratio2] = static_cast<double>(w[0]) / w[2];
  geometry[field::front] = (signed_area < 0) != mirrored ? 1 : 0;
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
    scratch_.clipped.clear();
    scratch_.geometry.resize(scratch_.key.size() * field::size);
    scratch_.varyings.resize(scratch_.key.size() * varying_stride);
    for (std::size_t i = 0; i < scratch_.key.size(); ++i) set_up(i);
    statistics_.triangles_shaded += scratch_.key.size();
  }

  void set_up(std::size_t place) {
    const std::uint32_t triangle = triangle_of(scratch_.key[place]);
    const CornerOrder order = corner_order(mesh_, triangle);
    std::array<SnappedCorner, 3> corners;
    std::array<float, 3> w;
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector3f& p = mesh_.positions[order.vertex[i]];
      const ClipPoints clip = to_clip(job_.transform, p.x(), p.y(), p.z());
      const WindowPoints window = to_window(job_.transform, clip);
      if (!all(window.direct)) {
        scratch_.clipped.push_back(static_cast<std::uint32_t>(place));
        return;
      }
      corners[i] = {hn::GetLane(window.x.v), hn::GetLane(window.y.v)};
      w[i] = hn::GetLane(clip.w.v);
    }
    write_geometry(corners, w, tile_.left, tile_.top, job_.mirrored,
                   scratch_.geometry.data() + place * field::size);
    write_varyings(corner_varyings(triangle, order.first), place);
  }

  using Corners = std::array<std::array<float, static_cast<std::size_t>(varying_count) + 1>, 3>;

  Corners corner_varyings(std::uint32_t triangle, int first) const {
    Corners corners;
    for (int i = 0; i < 3; ++i) {
      const Varyings<float> value = shader_.vertex(mesh_, triangle, (first + i) % 3);
      const float* from = numbers<Shader::template Varyings, float>(value);
      std::copy_n(from, varying_count, corners[static_cast<std::size_t>(i)].data());
    }
    return corners;
  }

  /// Per number: its value at corner 0, and how much it differs at corners 1 and 2.
  void write_varyings(const Corners& corners, std::size_t place) {
    float* to = scratch_.varyings.data() + place * varying_stride;
    for (std::size_t i = 0; i < static_cast<std::size_t>(varying_count); ++i) {
      to[3 * i] = corners[0][i];
      to[3 * i + 1] = corners[1][i] - corners[0][i];
      to[3 * i + 2] = corners[2][i] - corners[0][i];
    }
  }

  // -------------------------------------------------------------------------------------------
  // Triangles that were clipped: their pixels belong to one of the parts

  void resolve_clipped_pixels() {
    for (const std::uint32_t place : scratch_.clipped) {
      const std::uint32_t triangle = triangle_of(scratch_.key[place]);
      const CornerOrder order = corner_order(mesh_, triangle);
      TrianglePositions positions;
      for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector3f& p = mesh_.positions[order.vertex[i]];
        positions[i] = {p.x(), p.y(), p.z()};
      }
      const ClippedPolygon polygon = clip_triangle(job_.transform, positions);
      const Corners corners = corner_varyings(triangle, order.first);
      for_each_part(job_.transform, polygon, [&](const ClippedPart& part) {
        add_part(part, corners, static_cast<std::int32_t>(place));
      });
    }
  }

  void add_part(const ClippedPart& part, const Corners& corners, std::int32_t whole) {
    if (twice_area(part.snapped[0], part.snapped[1], part.snapped[2]) == 0) return;
    const std::size_t place = scratch_.geometry.size() / field::size;
    scratch_.geometry.resize((place + 1) * field::size);
    scratch_.varyings.resize((place + 1) * varying_stride);
    std::array<float, 3> w;
    Corners values;
    for (std::size_t c = 0; c < 3; ++c) {
      const ClippedCorner& corner = *part.corner[c];
      w[c] = corner.w;
      for (std::size_t i = 0; i < static_cast<std::size_t>(varying_count); ++i) {
        const double a0 = corners[0][i];
        values[c][i] = static_cast<float>(
            a0 + (corner.b1 * (corners[1][i] - a0) + corner.b2 * (corners[2][i] - a0)));
      }
    }
    double* geometry = scratch_.geometry.data() + place * field::size;
    write_geometry(part.snapped, w, tile_.left, tile_.top, job_.mirrored, geometry);
    write_varyings(values, place);
    for (std::size_t pixel = 0; pixel < scratch_.slot.size(); ++pixel) {
      if (scratch_.slot[pixel] == whole && covers(geometry, static_cast<int>(pixel))) {
        scratch_.slot[pixel] = static_cast<std::int32_t>(place);
      }
    }
  }

  /// Boundaries included: the depth pass has decided already that the pixel is this triangle's.
  bool covers(const double* geometry, int pixel) const {
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
    const int block = pixel / 64;
    const int per_row = tile_.blocks_per_row();
    return {block % per_row * 8 + pixel % 8, block / per_row * 8 + pixel % 64 / 8};
  }

  // -------------------------------------------------------------------------------------------
  // Shading

  /// The same field of each lane's triangle; of a single one when all lanes show the same.
  template <bool uniform>
  Doubles geometry(Ints slot, int name) const {
    if constexpr (uniform) {
      const auto place = static_cast<std::size_t>(hn::GetLane(slot.v));
      return Doubles(scratch_.geometry[place * field::size + static_cast<std::size_t>(name)]);
    } else {
      return gather_doubles(scratch_.geometry.data() + name, slot * Ints(field::size));
    }
  }
  template <bool uniform>
  Number varying(Ints slot, int name) const {
    if constexpr (uniform) {
      const auto place = static_cast<std::size_t>(hn::GetLane(slot.v));
      return Number(scratch_.varyings[place * varying_stride + static_cast<std::size_t>(name)]);
    } else {
      return gather_numbers(scratch_.varyings.data() + name, slot * Ints(varying_stride));
    }
  }

  template <bool uniform>
  Point<Number> surface_point(int pixel, Ints slot) const {
    const int block = pixel / 64;
    const Ints in_block = iota(pixel % 64);
    const Doubles x = to_doubles((in_block & Ints(7)) + Ints(place_of(block * 64).x));
    const Doubles y = to_doubles(shift_right<3>(in_block) + Ints(place_of(block * 64).y));
    const auto get = [&](int name) { return geometry<uniform>(slot, name); };
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
    interpolate<uniform>(slot, {to_number(b1), to_number(b2)}, derivative(step1_x, step2_x),
                         derivative(step1_y, step2_y), point);
    point.front_facing = to_number(get(field::front)) > Number(0);
    return point;
  }

  template <bool uniform>
  void interpolate(Ints slot, CornerWeights<Number> value, CornerWeights<Number> dx,
                   CornerWeights<Number> dy, Point<Number>& point) const {
    if constexpr (varying_count > 0) {
      for (int i = 0; i < varying_count; ++i) {
        const Number at_0 = varying<uniform>(slot, 3 * i);
        const Number to_1 = varying<uniform>(slot, 3 * i + 1);
        const Number to_2 = varying<uniform>(slot, 3 * i + 2);
        numbers<Shader::template Varyings, Number>(point.value)[i] =
            at_0 + (value.b1 * to_1 + value.b2 * to_2);
        numbers<Shader::template Varyings, Number>(point.dx)[i] = dx.b1 * to_1 + dx.b2 * to_2;
        numbers<Shader::template Varyings, Number>(point.dy)[i] = dy.b1 * to_1 + dy.b2 * to_2;
      }
    }
  }

  /// Colours, and what is discarded, of as many pixels as there are lanes.
  template <bool uniform>
  Fragment<Number> fragments(int pixel, Ints slot, Truth wanted) const {
    const Point<Number> point = surface_point<uniform>(pixel, slot);
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

  void shade_pixels() {
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
    for (; mask != 0; mask &= mask - 1) {
      const int lane = std::countr_zero(mask);
      const auto [x, y] = place_of(pixel + lane);
      if (x >= tile_.width || y >= tile_.height) continue;
      const std::uint32_t value = packed[static_cast<std::size_t>(lane)];
      tile_.color[y * tile_.stride + x] = {static_cast<std::uint8_t>(value),
                                           static_cast<std::uint8_t>(value >> 8U),
                                           static_cast<std::uint8_t>(value >> 16U)};
    }
  }

  const DrawJob& job_;
  const Shader& shader_;
  const Mesh& mesh_;
  const Tile& tile_;
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
