// A right answer written differently: the corners of the whole mesh taken to clip space first.
#include "common/projection/render.h"

#include "common/image/check.h"
#include "common/lines/draw_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace rasterlab {
namespace {

std::vector<Eigen::Vector4f> all_to_clip(const Mesh& mesh, const Transforms& transforms) {
  const Eigen::Matrix4f matrix = transforms.to_clip();
  std::vector<Eigen::Vector4f> clip;
  for (const Eigen::Vector3f& position : mesh.positions) clip.push_back(to_clip(matrix, position));
  return clip;
}

Color color_at(const Mesh& mesh, std::uint32_t vertex) {
  return mesh.colors.empty() ? Color(1, 1, 1) : mesh.colors[vertex];
}

int column_or_row(float coordinate, int size) {
  if (coordinate == static_cast<float>(size)) return size - 1;
  return static_cast<int>(std::floor(coordinate));
}

}  // namespace

void render_wireframe(const Mesh& mesh, const Transforms& transforms, const Color& color,
                      Image<Rgb8>& image) {
  const std::vector<Eigen::Vector4f> clip = all_to_clip(mesh, transforms);
  const int width = image.width(), height = image.height();
  for (const Mesh::Triangle& corners : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector4f &from = clip[corners[i]], &to = clip[corners[i == 2 ? 0 : i + 1]];
      const ClipPolygon left = clip_homogeneous({from, to, to}, guard_band(width, height));
      LineDiscrete ends;
      for (const ClipVertex& vertex : left) {
        const Eigen::Vector2f at = to_window(vertex.position, width, height).position;
        if (ends.size() == 2 || !in_raster_range(at)) break;
        ends.append({column_or_row(at.x(), width), column_or_row(at.y(), height)});
      }
      if (ends.size() == 2) draw_line(image, ends[0], ends[1], to_rgb8(color));
    }
  }
}

void render_in_order(const Mesh& mesh, const Transforms& transforms, Image<Rgb8>& image) {
  const std::vector<Eigen::Vector4f> clip = all_to_clip(mesh, transforms);
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::array<Color, 3> colors = {color_at(mesh, a), color_at(mesh, b), color_at(mesh, c)};
    const auto draw = [&](const TrianglePixel& pixel) {
      const Rgb8 stored = to_rgb8(interpolate(colors, pixel.weights));
      image(pixel.x, pixel.y) = stored;
    };
    for_each_pixel({clip[a], clip[b], clip[c]}, image.width(), image.height(), draw);
  }
}

DrawCounts render_nearest(const Mesh& mesh, const Transforms& transforms, Cull cull, Frame& frame) {
  const auto shade = [&](std::uint32_t triangle, const TrianglePixel& pixel) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return interpolate<Color>({color_at(mesh, a), color_at(mesh, b), color_at(mesh, c)},
                              pixel.weights);
  };
  return draw_mesh(mesh, transforms, cull, frame, shade);
}

}  // namespace rasterlab
