// What clipping leaves of a triangle, snapped: round which pixels its outline goes, counted by
// crossings and not by dividing it into triangles.
#pragma once

#include "common/projection/clip.h"
#include "common/projection/vertex_stage.h"
#include "common/triangles/edge_function.h"

#include <cmath>
#include <optional>
#include <vector>

namespace rasterlab {

using SnappedOutline = std::vector<SnappedPoint>;

/// Nothing where a corner is not in front of the eye or out of the raster's range.
inline std::optional<SnappedOutline> snapped_outline(const ClipTriangle& triangle, int width,
                                                     int height) {
  SnappedOutline outline;
  for (const ClipVertex& corner : clip_homogeneous(triangle, guard_band(width, height))) {
    const Eigen::Vector2f at = to_window(corner.position, width, height).position;
    const bool somewhere = corner.position.w() > 0 && std::abs(at.x()) <= max_coordinate &&
                           std::abs(at.y()) <= max_coordinate;
    if (!somewhere) return std::nullopt;
    outline.emplace_back(snap(at.x()), snap(at.y()));
  }
  return outline;
}

/// How often the outline goes clockwise round the centre of pixel (x, y): what crosses the row to
/// the left of it, going up, less what goes down. A centre on an edge counts as a little to the
/// right of it, and less below it, which is the top-left rule.
inline int winding(const SnappedOutline& outline, int x, int y) {
  const SnappedPoint center(256 * x + 128, 256 * y + 128);
  int count = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const SnappedPoint& a = outline[i];
    const SnappedPoint& b = outline[(i + 1) % outline.size()];
    const bool a_above = a.y() <= center.y();
    const bool b_above = b.y() <= center.y();
    if (a_above == b_above) continue;
    const std::int64_t right_of_it = cross(a, b, center);
    if (b_above && right_of_it >= 0) ++count;
    if (a_above && right_of_it <= 0) --count;
  }
  return count;
}

/// 1 where the corners go clockwise as seen, y down, −1 where counter-clockwise, 0 edge-on.
inline int exact_side(const ClipTriangle& triangle) {
  __extension__ using Wide = __float128;  // products of three floats are exact
  const auto at = [&](std::size_t corner, Eigen::Index axis) {
    return static_cast<Wide>(triangle[corner][axis]);
  };
  const auto minor = [&](Eigen::Index i, Eigen::Index j) {
    return at(1, i) * at(2, j) - at(1, j) * at(2, i);
  };
  const Wide determinant = at(0, 0) * minor(1, 3) + at(0, 1) * minor(3, 0) + at(0, 3) * minor(0, 1);
  return determinant < 0 ? 1 : determinant > 0 ? -1 : 0;
}

}  // namespace rasterlab
