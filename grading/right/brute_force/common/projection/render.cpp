// A right answer written differently: everything anew for each side and each pixel; the nearest
// without draw_mesh().
#include "common/projection/render.h"

#include "common/image/check.h"
#include "common/lines/draw_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace rasterlab {
namespace {

Eigen::Vector4f clip_corner(const Mesh& mesh, const Transforms& transforms, std::size_t triangle,
                            std::size_t corner) {
  return to_clip(transforms.to_clip(), mesh.positions[mesh.triangles[triangle][corner]]);
}

/// How far a corner is from the eye along the view axis.
float distance_of(const Mesh& mesh, const Transforms& transforms, std::size_t triangle,
                  std::size_t corner) {
  const Eigen::Vector3f& position = mesh.positions[mesh.triangles[triangle][corner]];
  return -(transforms.model_view() * position.homogeneous()).z();
}

Color mixed(const Mesh& mesh, std::size_t triangle, const CornerWeights<float>& weights) {
  if (mesh.colors.empty()) return Color::Ones();
  const Mesh::Triangle& corners = mesh.triangles[triangle];
  const Color a = mesh.colors[corners[0]];
  return a + weights.b1 * (mesh.colors[corners[1]] - a) +
         weights.b2 * (mesh.colors[corners[2]] - a);
}

}  // namespace

void render_wireframe(const Mesh& mesh, const Transforms& transforms, const Color& color,
                      Image<Rgb8>& image) {
  const float last_x = static_cast<float>(image.width()),
              last_y = static_cast<float>(image.height());
  for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector4f from = clip_corner(mesh, transforms, triangle, i);
      const Eigen::Vector4f to = clip_corner(mesh, transforms, triangle, (i + 1) % 3);
      const ClipPolygon ends =
          clip_homogeneous({from, to, to}, guard_band(image.width(), image.height()));
      if (ends.size() < 2) continue;
      std::vector<Point> pixels;
      for (std::size_t end = 0; end < 2; ++end) {
        Eigen::Vector2f at = to_window(ends[end].position, image.width(), image.height()).position;
        if (!in_raster_range(at)) break;
        if (at.x() == last_x) at.x() -= 1;
        if (at.y() == last_y) at.y() -= 1;
        pixels.emplace_back(int(std::floor(at.x())), int(std::floor(at.y())));
      }
      if (pixels.size() == 2) draw_line(image, pixels.front(), pixels.back(), to_rgb8(color));
    }
  }
}

void render_in_order(const Mesh& mesh, const Transforms& transforms, Image<Rgb8>& image) {
  for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    const ClipTriangle corners = {clip_corner(mesh, transforms, triangle, 0),
                                  clip_corner(mesh, transforms, triangle, 1),
                                  clip_corner(mesh, transforms, triangle, 2)};
    for_each_pixel(corners, image.width(), image.height(), [&](const TrianglePixel& pixel) {
      image(pixel.x, pixel.y) = to_rgb8(mixed(mesh, triangle, pixel.weights));
    });
  }
}

DrawCounts render_nearest(const Mesh& mesh, const Transforms& transforms, Cull cull, Frame& frame) {
  const TriangleOptions options = {.cull = cull, .mirrored = transforms.mirrored()};
  DrawCounts counts;
  for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    const ClipTriangle corners = {clip_corner(mesh, transforms, triangle, 0),
                                  clip_corner(mesh, transforms, triangle, 1),
                                  clip_corner(mesh, transforms, triangle, 2)};
    const auto visit = [&](const TrianglePixel& pixel) {
      if (!frame.depth.test(pixel.x, pixel.y, pixel.depth)) {
        ++counts.hidden;
        return;
      }
      frame.depth.write(pixel.x, pixel.y, pixel.depth);
      frame.color(pixel.x, pixel.y) = to_rgb8(mixed(mesh, triangle, pixel.weights));
      if (!frame.distance.empty()) {
        frame.distance(pixel.x, pixel.y) = interpolate<float>(
            {distance_of(mesh, transforms, triangle, 0), distance_of(mesh, transforms, triangle, 1),
             distance_of(mesh, transforms, triangle, 2)},
            pixel.weights);
      }
      if (!frame.ids.empty()) frame.ids(pixel.x, pixel.y) = static_cast<std::int32_t>(triangle);
    };
    for_each_pixel(corners, frame.width(), frame.height(), options, counts, visit);
  }
  return counts;
}

}  // namespace rasterlab
