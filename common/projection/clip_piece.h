// The triangles that what clipping has left of a triangle consists of.
#pragma once

#include "common/projection/clip.h"
#include "common/projection/vertex_stage.h"
#include "common/triangles/fixed_point.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include <Eigen/Dense>

namespace rasterlab {

using ClipPiece = std::array<const ClipVertex*, 3>;

/// A polygon of n corners is a fan of n − 2 pieces about its first one; this is the one that begins
/// with corner `first`, from 1 to n − 2.
inline ClipPiece piece_of(const ClipPolygon& polygon, std::size_t first) {
  return {&polygon[0], &polygon[first], &polygon[first + 1]};
}

/// Where a piece is seen.
struct PieceInWindow {
  std::array<Eigen::Vector2f, 3> position;  ///< in pixels
  std::array<double, 3> depth;              ///< NDC z
};

/// Whether a point of the window is where rasterize_triangle() takes it; NaN is not.
inline bool in_raster_range(const Eigen::Vector2f& window) {
  return std::abs(window.x()) <= max_coordinate && std::abs(window.y()) <= max_coordinate;
}

/// Nothing where rounding has left a corner behind the eye or too far outside.
inline std::optional<PieceInWindow> to_window(const ClipPiece& piece, int width, int height) {
  PieceInWindow seen;
  for (std::size_t i = 0; i < 3; ++i) {
    const WindowPoint point = to_window(piece[i]->position, width, height);
    if (!(piece[i]->position.w() > 0) || !in_raster_range(point.position)) return std::nullopt;
    seen.position[i] = point.position;
    seen.depth[i] = point.depth;
  }
  return seen;
}

}  // namespace rasterlab
