// The rendering loop of stages 04 and 05: every triangle of a mesh, every pixel it covers, the
// nearest one kept.
#pragma once

#include "common/mesh/mesh.h"
#include "common/projection/frame.h"
#include "common/projection/triangle_pixels.h"
#include "common/projection/vertex_stage.h"

#include <array>
#include <cstdint>

#include <Eigen/Dense>
#include <nlohmann/json_fwd.hpp>

namespace rasterlab {

/// From object to world to camera to clip space.
struct Transforms {
  Eigen::Matrix4f model = Eigen::Matrix4f::Identity();
  Eigen::Matrix4f view = Eigen::Matrix4f::Identity();
  Eigen::Matrix4f projection = Eigen::Matrix4f::Identity();

  /// The products, multiplied in double precision, rounded once.
  Eigen::Matrix4f model_view() const {
    return (view.cast<double>() * model.cast<double>()).cast<float>();
  }
  Eigen::Matrix4f to_clip() const {
    return (projection.cast<double>() * view.cast<double>() * model.cast<double>()).cast<float>();
  }

  /// Whether the way to camera space turns left into right, and so counter-clockwise into
  /// clockwise.
  bool mirrored() const {
    return model_view().topLeftCorner<3, 3>().cast<double>().determinant() < 0;
  }
};

/// What became of a mesh's triangles and of the pixels they cover.
struct DrawCounts : TriangleCounts {
  std::int64_t hidden = 0;     ///< pixels covered, but behind what was there or as far
  std::int64_t discarded = 0;  ///< pixels that shading refused
};

/// As --stats shows them.
nlohmann::json statistics(const DrawCounts& counts);

/// a0 + (b1 (a1 − a0) + b2 (a2 − a0)): a corner value at a pixel; where all are equal, exactly
/// that.
template <class Value>
Value interpolate(const std::array<Value, 3>& corners, const CornerWeights<float>& weights) {
  return corners[0] +
         (weights.b1 * (corners[1] - corners[0]) + weights.b2 * (corners[2] - corners[0]));
}

/// Draws every triangle of the mesh, in order, into `frame`, smaller depth winning and the earlier
/// triangle where equal. `shade(triangle, pixel)`, of the triangle's index and a TrianglePixel,
/// gives the Color of each pixel that is nearer than what was there, or a Fragment, which leaves
/// the pixel as it was where it is discarded.
template <class Shade>
DrawCounts draw_mesh(const Mesh& mesh, const Transforms& transforms, Cull cull, Frame& frame,
                     Shade&& shade) {
  const Eigen::Matrix4f to_clip_space = transforms.to_clip();
  const Eigen::RowVector4f view_axis = -transforms.model_view().row(2);
  const TriangleOptions options = {.cull = cull, .mirrored = transforms.mirrored()};
  DrawCounts counts;
  for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    ClipTriangle corners;
    std::array<float, 3> distances;
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector3f& position = mesh.positions[mesh.triangles[triangle][i]];
      corners[i] = to_clip(to_clip_space, position);
      distances[i] = view_axis * position.homogeneous();
    }
    for_each_pixel(corners, frame.width(), frame.height(), options, counts,
                   [&](const TrianglePixel& pixel) {
                     if (!frame.depth.test(pixel.x, pixel.y, pixel.depth)) {
                       ++counts.hidden;
                       return;
                     }
                     const Fragment<float> fragment = to_fragment(shade(triangle, pixel));
                     if (fragment.discarded) {
                       ++counts.discarded;
                       return;
                     }
                     frame.depth.write(pixel.x, pixel.y, pixel.depth);
                     frame.color.row(pixel.y)[pixel.x] = to_rgb8(fragment.color);
                     if (!frame.distance.empty()) {
                       frame.distance.row(pixel.y)[pixel.x] = interpolate(distances, pixel.weights);
                     }
                     if (!frame.ids.empty()) {
                       frame.ids.row(pixel.y)[pixel.x] = static_cast<std::int32_t>(triangle);
                     }
                   });
  }
  return counts;
}

}  // namespace rasterlab
