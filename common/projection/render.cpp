#include "common/projection/render.h"

#include "common/image/check.h"
#include "common/lines/draw_line.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rasterlab {
// <solution>
namespace {

std::array<Color, 3> corner_colors(const Mesh& mesh, const Mesh::Triangle& triangle) {
  if (mesh.colors.empty()) return {Color::Ones(), Color::Ones(), Color::Ones()};
  return {mesh.colors[triangle[0]], mesh.colors[triangle[1]], mesh.colors[triangle[2]]};
}

ClipTriangle clip_corners(const Eigen::Matrix4f& matrix, const Mesh& mesh,
                          const Mesh::Triangle& triangle) {
  return {to_clip(matrix, mesh.positions[triangle[0]]),
          to_clip(matrix, mesh.positions[triangle[1]]),
          to_clip(matrix, mesh.positions[triangle[2]])};
}

// The pixel a point of the window falls into; the window's right and bottom edges are its last
// pixels'.
Point pixel_of(const WindowPoint& point, const Image<Rgb8>& image) {
  const auto index = [](float coordinate, int side) {
    return static_cast<int>(std::floor(coordinate)) -
           (coordinate == static_cast<float>(side) ? 1 : 0);
  };
  return {index(point.position.x(), image.width()), index(point.position.y(), image.height())};
}

// Draws what of an edge is in front of the near plane: a segment is clipped as a triangle two of
// whose corners are the same, whose first two corners are then the segment's ends.
void render_edge(const Eigen::Vector4f& a, const Eigen::Vector4f& b, const Rgb8& color,
                 Image<Rgb8>& image) {
  const ClipPolygon ends = clip_homogeneous({a, b, b}, guard_band(image.width(), image.height()));
  if (ends.size() < 2) return;
  std::array<Point, 2> pixels;
  for (std::size_t i = 0; i < 2; ++i) {
    const WindowPoint point = to_window(ends[i].position, image.width(), image.height());
    if (!in_raster_range(point.position)) return;
    pixels[i] = pixel_of(point, image);
  }
  draw_line(image, pixels[0], pixels[1], color);
}

}  // namespace
// </solution>

void render_wireframe(const Mesh& mesh, const Transforms& transforms, const Color& color,
                      Image<Rgb8>& image) {
  // <solution>
  const Eigen::Matrix4f to_clip_space = transforms.to_clip();
  const Rgb8 stored = to_rgb8(color);
  for (const Mesh::Triangle& triangle : mesh.triangles) {
    const ClipTriangle corners = clip_corners(to_clip_space, mesh, triangle);
    for (std::size_t i = 0; i < 3; ++i) {
      render_edge(corners[i], corners[(i + 1) % 3], stored, image);
    }
  }
  // <starter> throw NotWritten("04.8", mesh, transforms, color, image);
  // </solution>
}

void render_in_order(const Mesh& mesh, const Transforms& transforms, Image<Rgb8>& image) {
  // <solution>
  const Eigen::Matrix4f to_clip_space = transforms.to_clip();
  for (const Mesh::Triangle& triangle : mesh.triangles) {
    const std::array<Color, 3> colors = corner_colors(mesh, triangle);
    const ClipTriangle corners = clip_corners(to_clip_space, mesh, triangle);
    for_each_pixel(corners, image.width(), image.height(), [&](const TrianglePixel& pixel) {
      image(pixel.x, pixel.y) = to_rgb8(interpolate(colors, pixel.weights));
    });
  }
  // <starter> throw NotWritten("04.8", mesh, transforms, image);
  // </solution>
}

DrawCounts render_nearest(const Mesh& mesh, const Transforms& transforms, Cull cull, Frame& frame) {
  // <solution>
  return draw_mesh(
      mesh, transforms, cull, frame, [&](std::uint32_t triangle, const TrianglePixel& pixel) {
        return interpolate(corner_colors(mesh, mesh.triangles[triangle]), pixel.weights);
      });
  // <starter> throw NotWritten("04.8", mesh, transforms, cull, frame);
  // </solution>
}

}  // namespace rasterlab
