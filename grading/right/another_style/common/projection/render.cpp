// A right answer written differently: each triangle as a small object that knows its corners and
// colours.
#include "common/projection/render.h"

#include "common/image/check.h"
#include "common/lines/draw_line.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rasterlab {
namespace {

struct Drawn {
  ClipTriangle clip;
  std::array<Color, 3> colors = {Color::Ones(), Color::Ones(), Color::Ones()};

  Drawn(const Mesh& mesh, const Eigen::Matrix4f& matrix, std::size_t index) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t vertex = mesh.triangles[index][i];
      clip[i] = to_clip(matrix, mesh.positions[vertex]);
      if (!mesh.colors.empty()) colors[i] = mesh.colors[vertex];
    }
  }
};

int pixel_at(float coordinate, int side) {
  const int whole = static_cast<int>(std::floor(coordinate));
  return coordinate == static_cast<float>(side) ? whole - 1 : whole;
}

}  // namespace

void render_wireframe(const Mesh& mesh, const Transforms& transforms, const Color& color,
                      Image<Rgb8>& image) {
  const Eigen::Matrix4f matrix = transforms.to_clip();
  const Eigen::Vector2f guard = guard_band(image.width(), image.height());
  for (std::size_t index = 0; index < mesh.triangles.size(); ++index) {
    const Drawn drawn(mesh, matrix, index);
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector4f &a = drawn.clip[i], &b = drawn.clip[(i + 1) % 3];
      const ClipPolygon polygon = clip_homogeneous({a, b, b}, guard);
      if (polygon.size() < 2) continue;
      const WindowPoint from = to_window(polygon[0].position, image.width(), image.height());
      const WindowPoint to = to_window(polygon[1].position, image.width(), image.height());
      if (!in_raster_range(from.position) || !in_raster_range(to.position)) continue;
      const auto pixel = [&](const WindowPoint& point) {
        return Point(pixel_at(point.position.x(), image.width()),
                     pixel_at(point.position.y(), image.height()));
      };
      draw_line(image, pixel(from), pixel(to), to_rgb8(color));
    }
  }
}

void render_in_order(const Mesh& mesh, const Transforms& transforms, Image<Rgb8>& image) {
  const Eigen::Matrix4f matrix = transforms.to_clip();
  for (std::size_t index = 0; index < mesh.triangles.size(); ++index) {
    const Drawn drawn(mesh, matrix, index);
    for_each_pixel(drawn.clip, image.width(), image.height(), [&](const TrianglePixel& pixel) {
      const float first = 1 - pixel.weights.b1 - pixel.weights.b2;
      image(pixel.x, pixel.y) =
          to_rgb8(first * drawn.colors[0] + pixel.weights.b1 * drawn.colors[1] +
                  pixel.weights.b2 * drawn.colors[2]);
    });
  }
}

DrawCounts render_nearest(const Mesh& mesh, const Transforms& transforms, Cull cull, Frame& frame) {
  const Eigen::Matrix4f matrix = transforms.to_clip();
  return draw_mesh(mesh, transforms, cull, frame,
                   [&](std::uint32_t index, const TrianglePixel& pixel) {
                     return interpolate(Drawn(mesh, matrix, index).colors, pixel.weights);
                   });
}

}  // namespace rasterlab
