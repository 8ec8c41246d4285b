// From a triangle in clip space to the pixels it covers, clipped, snapped and
// perspective-corrected: the one way in which stages 04 to 07 fill a triangle.
#pragma once

#include "common/mesh/cull.h"
#include "common/mesh/shader_types.h"
#include "common/projection/clip.h"
#include "common/projection/clip_piece.h"
#include "common/projection/cut_outline.h"
#include "common/triangles/rasterize.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include <Eigen/Dense>

namespace rasterlab {

/// A pixel whose centre a triangle covers.
struct TrianglePixel {
  int x;
  int y;
  float depth;  ///< NDC z, in [−1, 1]

  /// Perspective-correct weights of corners 1 and 2, and their exact derivatives per pixel to the
  /// right and per pixel down: for interpolate() of shader_types.h.
  CornerWeights<float> weights;
  CornerWeights<float> weights_dx;
  CornerWeights<float> weights_dy;

  bool front_facing;
};

/// What became of triangles.
struct TriangleCounts {
  std::int64_t triangles = 0;
  std::int64_t clipped = 0;    ///< cut at the near plane or the guard band
  std::int64_t outside = 0;    ///< nothing left of it in front of the near plane
  std::int64_t culled = 0;     ///< pieces turned the wrong way
  std::int64_t no_area = 0;    ///< pieces without area in the window, or turned over by snapping
  std::int64_t off_range = 0;  ///< pieces seen edge-on so closely that rounding left them nowhere
  std::int64_t pixels = 0;     ///< covered, nearer or not than what was there
};

/// How triangles are filled.
struct TriangleOptions {
  Cull cull = Cull::none;
  bool mirrored = false;  ///< the model's matrix is a mirror: fronts go clockwise
  ClipFunction clip = &clip_homogeneous;
};

/// Weights of a whole triangle's corners, at any point of a piece of it, from the point's weights
/// in the window.
class SpaceWeights {
 public:
  /// Of the piece with these corners.
  explicit SpaceWeights(const ClipPiece& piece) {
    for (int i = 0; i < 3; ++i) {
      const ClipVertex& vertex = *piece[static_cast<std::size_t>(i)];
      per_w_.col(i) = vertex.weights.cast<double>() / static_cast<double>(vertex.position.w());
    }
  }

  CornerWeights<float> at(const Eigen::Vector3d& window_weights) {
    const Eigen::Vector3d parts = per_w_ * window_weights;
    sum_ = parts.sum();
    weights_ = parts / sum_;
    return corners(weights_);
  }

  /// How fast the weights of the last at() change, from how fast the window's do.
  CornerWeights<float> derivative(const Eigen::Vector3d& window_derivative) const {
    const Eigen::Vector3d parts = per_w_ * window_derivative;
    return corners((parts - weights_ * parts.sum()) / sum_);
  }

 private:
  static CornerWeights<float> corners(const Eigen::Vector3d& all) {
    return {static_cast<float>(all[1]), static_cast<float>(all[2])};
  }

  Eigen::Matrix3d per_w_;
  Eigen::Vector3d weights_ = Eigen::Vector3d::Zero();
  double sum_ = 1;
};

/// for_each_pixel() for one piece, three corners in front of the eye. `side`: the only one that it
/// may show, as seen_side() has it, or 0 for either.
template <class Visit>
void for_each_pixel_of_piece(const ClipPiece& piece, int side, int width, int height,
                             const TriangleOptions& options, TriangleCounts& counts,
                             Visit&& visit) {
  const std::optional<PieceInWindow> seen = to_window(piece, width, height);
  if (!seen) {
    ++counts.off_range;
    return;
  }
  const std::array<Eigen::Vector2f, 3>& window = seen->position;
  const std::array<double, 3>& depth = seen->depth;
  const SnappedTriangle snapped = snap(window);
  const std::int64_t area = cross(snapped[0], snapped[1], snapped[2]);  // y down: clockwise is > 0
  const bool turned_over = side != 0 && (area > 0) != (side > 0);
  if (area == 0 || turned_over) {
    ++counts.no_area;
    return;
  }
  const bool front_facing = (area < 0) != options.mirrored;
  if (options.cull == (front_facing ? Cull::front : Cull::back)) {
    ++counts.culled;
    return;
  }
  const TriangleEdges edges = make_edges(snapped);
  const auto per_area = [&](auto step) -> Eigen::Vector3d {
    return Eigen::Vector3d(static_cast<double>(edges.edges[0].*step),
                           static_cast<double>(edges.edges[1].*step),
                           static_cast<double>(edges.edges[2].*step)) /
           static_cast<double>(edges.twice_area);
  };
  const Eigen::Vector3d dx = per_area(&EdgeFunction::step_x);
  const Eigen::Vector3d dy = per_area(&EdgeFunction::step_y);
  SpaceWeights weights(piece);
  rasterize_triangle(window, width, height, [&](int x, int y, const Eigen::Vector3d& in_window) {
    const auto z = static_cast<float>(
        depth[0] + (in_window[1] * (depth[1] - depth[0]) + in_window[2] * (depth[2] - depth[0])));
    if (!(z <= 1)) return;  // beyond the far plane
    TrianglePixel pixel{};
    pixel.x = x;
    pixel.y = y;
    pixel.depth = std::max(z, -1.0F);  // the near plane has cut already, up to rounding
    pixel.weights = weights.at(in_window);
    pixel.weights_dx = weights.derivative(dx);
    pixel.weights_dy = weights.derivative(dy);
    pixel.front_facing = front_facing;
    visit(pixel);
  });
}

/// Whether clipping has taken something away.
inline bool is_cut(const ClipPolygon& polygon, const ClipTriangle& triangle) {
  return !std::equal(polygon.begin(), polygon.end(), triangle.begin(), triangle.end(),
                     [](const ClipVertex& a, const Eigen::Vector4f& b) { return a.position == b; });
}

/// Calls `visit(const TrianglePixel&)` once for every pixel of a width × height picture that the
/// triangle, its corners in clip space, covers between the near and the far plane. Two triangles
/// that share an edge cover each pixel along it once, wherever their corners are; of what is
/// thinner than 1/256 pixel see cut_outline.h. Corners may be any floats. Of a pixel whose
/// depth is the far plane's up to rounding, of the largest depth at a corner of what is left of the
/// triangle, either may be said: the engine rounds differently. `counts` is added to.
template <class Visit>
void for_each_pixel(const ClipTriangle& triangle, int width, int height,
                    const TriangleOptions& options, TriangleCounts& counts, Visit&& visit) {
  ++counts.triangles;
  const ClipPolygon polygon = options.clip(triangle, guard_band(width, height));
  const int side = options.cull == Cull::none ? seen_side(triangle) : 0;
  std::optional<CutOutline> outline;
  if (polygon.empty()) {
    ++counts.outside;
  } else if (is_cut(polygon, triangle)) {
    ++counts.clipped;
    outline.emplace(triangle, polygon, width, height);
  }
  for (std::size_t i = 0; i + 2 < polygon.size(); ++i) {
    for_each_pixel_of_piece(piece_of(polygon, i + 1), side, width, height, options, counts,
                            [&](const TrianglePixel& pixel) {
                              if (outline && !outline->gives(pixel.x, pixel.y, i)) return;
                              ++counts.pixels;
                              visit(pixel);
                            });
  }
}

template <class Visit>
void for_each_pixel(const ClipTriangle& triangle, int width, int height, Visit&& visit) {
  TriangleCounts counts;
  for_each_pixel(triangle, width, height, {}, counts, visit);
}

}  // namespace rasterlab
