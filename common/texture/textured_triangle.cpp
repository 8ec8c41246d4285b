#include "common/texture/textured_triangle.h"

#include "common/projection/triangle_pixels.h"
#include "common/projection/vertex_stage.h"
#include "common/triangles/rasterize.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace rasterlab {
namespace {

/// What clipping has left of the triangle, or a part of it: three corners in the window.
struct Piece {
  std::array<Eigen::Vector2f, 3> window;
  Eigen::Vector3d depth;
  Eigen::Vector3d inverse_w;
  Eigen::Matrix<double, 2, 3> uv;  ///< a column for each corner
  std::function<bool(int x, int y)> has;
};

Piece make_piece(const ClipPiece& corners, const Eigen::Matrix<double, 2, 3>& triangle_uv,
                 const Frame& frame) {
  Piece piece;
  for (std::size_t i = 0; i < 3; ++i) {
    const ClipVertex& corner = *corners[i];
    const WindowPoint point = to_window(corner.position, frame.width(), frame.height());
    const auto column = static_cast<Eigen::Index>(i);
    piece.window[i] = point.position;
    piece.depth[column] = point.depth;
    piece.inverse_w[column] = 1.0 / corner.position.w();
    piece.uv.col(column) = triangle_uv * corner.weights.cast<double>();
  }
  return piece;
}

/// The pixels of one row, as they come from the rasterizer.
struct RowOfPixels {
  int y = -1;
  int first_x = 0;
  std::vector<Eigen::Vector3d> weights;
};

void draw_row(const Piece& piece, const RowOfPixels& row, const Sampler& sampler,
              PerspectiveRung rung, Frame& frame) {
  std::vector<Eigen::Vector3d> on_triangle(row.weights.size());
  rung({piece.inverse_w, row.weights}, on_triangle);
  for (std::size_t i = 0; i < row.weights.size(); ++i) {
    const int x = row.first_x + static_cast<int>(i);
    const auto depth = static_cast<float>(row.weights[i].dot(piece.depth));
    if (!piece.has(x, row.y)) continue;
    if (!frame.depth.test(x, row.y, depth)) continue;
    frame.depth.write(x, row.y, depth);
    const Eigen::Vector2f uv = (piece.uv * on_triangle[i]).cast<float>();
    const Footprint<float> footprint{uv, Eigen::Vector2f::Zero(), Eigen::Vector2f::Zero()};
    frame.color.row(row.y)[x] = to_rgb8(sample(sampler, footprint));
  }
}

void draw_piece(const Piece& piece, const Sampler& sampler, PerspectiveRung rung, Frame& frame) {
  if (!std::ranges::all_of(piece.window, in_raster_range)) return;  // as triangle_pixels.h has it
  RowOfPixels row;
  rasterize_triangle(piece.window, frame.width(), frame.height(),
                     [&](int x, int y, const Eigen::Vector3d& weights) {
                       if (y != row.y) {
                         draw_row(piece, row, sampler, rung, frame);
                         row = {y, x, {}};
                       }
                       row.weights.push_back(weights);
                     });
  draw_row(piece, row, sampler, rung, frame);
}

}  // namespace

void draw_textured_triangle(const ClipTriangle& corners,
                            const std::array<Eigen::Vector2f, 3>& texture_coordinates,
                            const Sampler& sampler, PerspectiveRung rung, Frame& frame) {
  Eigen::Matrix<double, 2, 3> uv;
  for (std::size_t i = 0; i < 3; ++i) {
    uv.col(static_cast<Eigen::Index>(i)) = texture_coordinates[i].cast<double>();
  }
  const ClipPolygon polygon = clip_homogeneous(corners, guard_band(frame.width(), frame.height()));
  const CutOutline outline(corners, polygon, frame.width(), frame.height());
  for (std::size_t i = 0; i + 2 < polygon.size(); ++i) {
    Piece piece = make_piece(piece_of(polygon, i + 1), uv, frame);
    piece.has = [&outline, i](int x, int y) { return outline.gives(x, y, i); };
    draw_piece(piece, sampler, rung, frame);
  }
}

}  // namespace rasterlab
