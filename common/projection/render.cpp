#include "common/projection/render.h"

namespace rasterlab {
namespace {

std::array<Color, 3> corner_colors(const Mesh& mesh, const Mesh::Triangle& triangle) {
  if (mesh.colors.empty()) return {Color::Ones(), Color::Ones(), Color::Ones()};
  return {mesh.colors[triangle[0]], mesh.colors[triangle[1]], mesh.colors[triangle[2]]};
}

}  // namespace

void render_in_order(const Mesh& mesh, const Transforms& transforms, Image<Rgb8>& image) {
  const Eigen::Matrix4f to_clip_space = transforms.to_clip();
  for (const Mesh::Triangle& triangle : mesh.triangles) {
    const std::array<Color, 3> colors = corner_colors(mesh, triangle);
    const ClipTriangle corners = {to_clip(to_clip_space, mesh.positions[triangle[0]]),
                                  to_clip(to_clip_space, mesh.positions[triangle[1]]),
                                  to_clip(to_clip_space, mesh.positions[triangle[2]])};
    for_each_pixel(corners, image.width(), image.height(), [&](const TrianglePixel& pixel) {
      image(pixel.x, pixel.y) = to_rgb8(interpolate(colors, pixel.weights));
    });
  }
}

DrawCounts render_nearest(const Mesh& mesh, const Transforms& transforms, Cull cull, Frame& frame) {
  return draw_mesh(
      mesh, transforms, cull, frame, [&](std::uint32_t triangle, const TrianglePixel& pixel) {
        return interpolate(corner_colors(mesh, mesh.triangles[triangle]), pixel.weights);
      });
}

}  // namespace rasterlab
