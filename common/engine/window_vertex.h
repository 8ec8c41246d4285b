// Vertices to the window, as many at once as there are lanes; and the clipping of the few triangles
// that reach behind the near plane or far outside the picture.
#pragma once

#include "common/engine/clip_transform.h"
#include "common/engine/simd.h"

#include <algorithm>
#include <span>

namespace rasterlab::RASTERLAB_SIMD {

struct ClipPoints {
  Number x, y, z, w;
};

/// One row: in this order of operations, which the exercise code has too.
inline Number apply_row(const std::array<float, 4>& row, Number x, Number y, Number z) {
  return ((Number(row[0]) * x + Number(row[1]) * y) + Number(row[2]) * z) + Number(row[3]);
}

inline ClipPoints to_clip(const ClipTransform& transform, Number x, Number y, Number z) {
  return {apply_row(transform.row[0], x, y, z), apply_row(transform.row[1], x, y, z),
          apply_row(transform.row[2], x, y, z), apply_row(transform.row[3], x, y, z)};
}

struct WindowPoints {
  Ints x, y;     ///< in 1/256 pixel
  Truth direct;  ///< whether they can be used: in front of the near plane, and not too far outside
};

inline WindowPoints to_window(const ClipTransform& transform, const ClipPoints& clip) {
  const Number x = (clip.x / clip.w + Number(1)) * Number(transform.half_width) * Number(256);
  const Number y = (Number(1) - clip.y / clip.w) * Number(transform.half_height) * Number(256);
  const Number limit(static_cast<float>(max_window_coordinate));
  const Number reach_x = Number(transform.guard_x) * clip.w;
  const Number reach_y = Number(transform.guard_y) * clip.w;
  const Truth direct = clip.w > Number(0) && clip.z + clip.w >= Number(0) &&
                       magnitude(clip.x) <= reach_x && magnitude(clip.y) <= reach_y &&
                       magnitude(x) <= limit && magnitude(y) <= limit;  // infinities
  return {round_to_ints(x), round_to_ints(y), direct};
}

/// Depths of corners go no further beyond the far plane than this, so that what is mixed of three
/// stays finite. Nothing of a triangle is drawn so far there, and where it meets the far plane
/// changes by less than any rounding.
inline constexpr float farthest_depth = 0x1p126F;

/// (w − z) / 2w, to nearest.
inline Number reversed_depth(const ClipTransform& transform, Number x, Number y, Number z,
                             Number w) {
  const auto& row = transform.depth_row;
  const Doubles numerator = ((Doubles(row[0]) * to_doubles(x) + Doubles(row[1]) * to_doubles(y)) +
                             Doubles(row[2]) * to_doubles(z)) +
                            Doubles(row[3]);
  return maximum(Number(-farthest_depth), to_number(numerator / to_doubles(w)));
}

// ---------------------------------------------------------------------------------------------
// Clipping, one triangle at a time

/// A corner of what is left of a triangle, as exercise 04.9 has it before it rounds.
struct ClippedCorner {
  double x, y, z, w;  ///< clip space
  double depth;       ///< reversed depth's numerator
  double b1, b2;      ///< where in the triangle: weights of its corners 1 and 2

  /// (w − z) / 2w.
  float reversed_depth() const {
    return static_cast<float>(std::clamp<double>(depth / w, -farthest_depth, farthest_depth));
  }
};

struct ClippedPolygon {
  /// Of n corners a plane leaves at most n + ⌊n/2⌋, for each run of corners outside becomes two.
  /// Convex polygons have one run, and so 8 corners at the most after five planes; rounding may
  /// bend them, where coordinates are of very different size, and corners that are no numbers are
  /// outside of all planes: 3, 4, 6, 9, 13, 19.
  static constexpr int capacity = 19;
  int side = 0;  ///< of the whole triangle, as seen_side() says
  int size = 0;
  std::array<ClippedCorner, capacity> corner;

  void add(const ClippedCorner& c) { corner[static_cast<std::size_t>(size++)] = c; }
};

/// From a corner inside to one outside: so two triangles that share the side cut it alike.
inline ClippedCorner cut(const ClippedCorner& inside, const ClippedCorner& outside,
                         double inside_distance, double outside_distance) {
  const double t = inside_distance / (inside_distance - outside_distance);
  const auto mix = [t](double a, double b) { return a + t * (b - a); };
  return {mix(inside.x, outside.x),  mix(inside.y, outside.y),         mix(inside.z, outside.z),
          mix(inside.w, outside.w),  mix(inside.depth, outside.depth), mix(inside.b1, outside.b1),
          mix(inside.b2, outside.b2)};
}

/// Keeps what has distance ≥ 0, which not a number has not (Sutherland and Hodgman, "Reentrant
/// Polygon Clipping", CACM 1974).
template <class Distance>
ClippedPolygon clip_to_plane(const ClippedPolygon& polygon, Distance distance) {
  ClippedPolygon result;
  result.side = polygon.side;
  for (int i = 0; i < polygon.size; ++i) {
    const ClippedCorner& a = polygon.corner[static_cast<std::size_t>(i)];
    const ClippedCorner& b = polygon.corner[static_cast<std::size_t>((i + 1) % polygon.size)];
    const double da = distance(a);
    const double db = distance(b);
    if (da >= 0) result.add(a);
    if (da >= 0 && !(db >= 0)) result.add(cut(a, b, da, db));
    if (!(da >= 0) && db >= 0) result.add(cut(b, a, db, da));
  }
  return result;
}

/// Positions of a triangle's corners in object space.
using TrianglePositions = std::array<std::array<float, 3>, 3>;

inline ClippedCorner to_clipped_corner(const ClipTransform& transform,
                                       const std::array<float, 3>& p) {
  const auto row = [&](std::size_t r) {
    const auto& m = transform.row[r];
    return ((m[0] * p[0] + m[1] * p[1]) + m[2] * p[2]) + m[3];
  };
  const auto& d = transform.depth_row;
  const double depth = ((d[0] * p[0] + d[1] * p[1]) + d[2] * p[2]) + d[3];
  return {row(0), row(1), row(2), row(3), depth, 0, 0};
}

/// Which way round the corners go as they are seen, also behind the eye: 1 clockwise, −1
/// counter-clockwise, 0 where the eye is in their plane as nearly as doubles can say.
inline int seen_side(const ClippedCorner& a, const ClippedCorner& b, const ClippedCorner& c) {
  const auto minor = [](double p, double q, double r, double s) { return p * s - q * r; };
  const double determinant = a.x * minor(b.y, b.w, c.y, c.w) + a.y * minor(b.w, b.x, c.w, c.x) +
                             a.w * minor(b.x, b.y, c.x, c.y);
  return determinant > 0 ? -1 : determinant < 0 ? 1 : 0;
}

/// What of a triangle is in front of the near plane and within the guard band, far outside the
/// picture. Corners may be any floats.
inline ClippedPolygon clip_triangle(const ClipTransform& transform,
                                    const TrianglePositions& positions) {
  ClippedPolygon polygon;
  for (std::size_t i = 0; i < 3; ++i) {
    ClippedCorner corner = to_clipped_corner(transform, positions[i]);
    corner.b1 = i == 1 ? 1 : 0;
    corner.b2 = i == 2 ? 1 : 0;
    polygon.add(corner);
  }
  polygon.side = seen_side(polygon.corner[0], polygon.corner[1], polygon.corner[2]);
  const auto clip = [&](auto distance) { polygon = clip_to_plane(polygon, distance); };
  const double guard_x = transform.guard_x;
  const double guard_y = transform.guard_y;
  clip([](const ClippedCorner& c) { return c.z + c.w; });
  clip([=](const ClippedCorner& c) { return guard_x * c.w + c.x; });
  clip([=](const ClippedCorner& c) { return guard_x * c.w - c.x; });
  clip([=](const ClippedCorner& c) { return guard_y * c.w + c.y; });
  clip([=](const ClippedCorner& c) { return guard_y * c.w - c.y; });
  return polygon;
}

/// A window position in 1/256 pixel.
struct SnappedCorner {
  std::int32_t x, y;
};

/// Twice the area of (a, b, c): positive when c is to the right of the way from a to b, y down.
inline std::int64_t twice_area(const SnappedCorner& a, const SnappedCorner& b,
                               const SnappedCorner& c) {
  return static_cast<std::int64_t>(b.x - a.x) * (c.y - a.y) -
         static_cast<std::int64_t>(b.y - a.y) * (c.x - a.x);
}

/// Three corners of a clipped polygon in the window.
struct ClippedPart {
  std::array<const ClippedCorner*, 3> corner;
  std::array<SnappedCorner, 3> snapped;
  std::int64_t area;  ///< twice; positive when they go clockwise, y down

  int side() const { return area > 0 ? 1 : -1; }
};

/// The triangles that make up a clipped polygon, a fan, but those without area. Those not of the
/// polygon's side were turned over by snapping, and are not to be drawn: they lie on others, of
/// this triangle or of its neighbours (common/projection/cut_outline.h has the same rule).
struct ClippedParts {
  int side = 0;
  int size = 0;
  std::array<ClippedPart, ClippedPolygon::capacity - 2> part;

  std::span<const ClippedPart> all() const {
    return std::span(part).first(static_cast<std::size_t>(size));
  }
  bool any_turned_over() const {
    return std::any_of(all().begin(), all().end(),
                       [this](const ClippedPart& p) { return p.side() != side; });
  }
};

/// False when rounding, or a corner that is no number, left it nowhere.
inline bool snap(const ClipTransform& transform, const ClippedCorner& c, SnappedCorner& snapped) {
  const auto w = static_cast<float>(c.w);
  const float x = (static_cast<float>(c.x) / w + 1.0F) * transform.half_width * 256.0F;
  const float y = (1.0F - static_cast<float>(c.y) / w) * transform.half_height * 256.0F;
  constexpr auto limit = static_cast<float>(max_window_coordinate);
  if (!(w > 0 && x <= limit && x >= -limit && y <= limit && y >= -limit)) return false;
  // Adding and taking away 1.5 · 2^52 rounds a double to nearest, ties to even.
  constexpr double rounder = 0x1.8p52;
  const auto round = [](float a) {
    return static_cast<std::int32_t>((static_cast<double>(a) + rounder) - rounder);
  };
  snapped = {round(x), round(y)};
  return true;
}

/// They point to the polygon's corners.
inline ClippedParts parts_of(const ClipTransform& transform, const ClippedPolygon& polygon) {
  ClippedParts parts;
  double sum = 0;
  for (int i = 2; i < polygon.size; ++i) {
    ClippedPart& part = parts.part[static_cast<std::size_t>(parts.size)];
    part.corner = {&polygon.corner[0], &polygon.corner[static_cast<std::size_t>(i - 1)],
                   &polygon.corner[static_cast<std::size_t>(i)]};
    bool somewhere = true;
    for (std::size_t c = 0; c < 3; ++c) {
      somewhere = somewhere && snap(transform, *part.corner[c], part.snapped[c]);
    }
    if (!somewhere) continue;
    part.area = twice_area(part.snapped[0], part.snapped[1], part.snapped[2]);
    sum += static_cast<double>(part.area);
    if (part.area != 0) ++parts.size;
  }
  parts.side = polygon.side != 0 ? polygon.side : sum > 0 ? 1 : -1;
  return parts;
}

}  // namespace rasterlab::RASTERLAB_SIMD
