// A right answer written differently: each pixel keeps the stored depth of what it shows, in one
// loop for all four.
#include "common/image/check.h"
#include "common/triangles/rasterize.h"
#include "common/zbuffer/visibility.h"

#include <cmath>

namespace rasterlab {
namespace {

enum class Format { bits_16, bits_24, floating, reversed };

double depth_at(const VisibilityScene& scene, float distance, Format format) {
  if (format == Format::reversed) return scene.near / distance;
  return scene.far / (scene.far - scene.near) * (1 - scene.near / distance);
}

float stored(double depth, Format format) {
  if (format == Format::bits_16) return static_cast<float>(std::nearbyint(depth * 65535.0));
  if (format == Format::bits_24) return static_cast<float>(std::nearbyint(depth * 16777215.0));
  return static_cast<float>(depth);
}

VisibleTriangles nearest(const VisibilityScene& scene, Format format) {
  VisibleTriangles seen(scene.width, scene.height, -1);
  Image<float> buffer(scene.width, scene.height);
  std::int32_t index = 0;
  for (const VisibilityTriangle& triangle : scene.triangles) {
    const auto at = [&](std::size_t i) {
      return double(float(depth_at(scene, triangle.distances[i], format)));
    };
    const double a = at(0), b = at(1), c = at(2);
    rasterize_triangle(triangle.corners, scene.width, scene.height,
                       [&](int x, int y, const Eigen::Vector3d& w) {
                         const float z = stored(w[0] * a + w[1] * b + w[2] * c, format);
                         const float there = buffer(x, y);
                         const bool nearer = format == Format::reversed ? z > there : z < there;
                         if (seen(x, y) == -1 || nearer) {
                           seen(x, y) = index;
                           buffer(x, y) = z;
                         }
                       });
    ++index;
  }
  return seen;
}

}  // namespace

VisibleTriangles seen_by_zbuffer_16(const VisibilityScene& scene) {
  return nearest(scene, Format::bits_16);
}

VisibleTriangles seen_by_zbuffer_24(const VisibilityScene& scene) {
  return nearest(scene, Format::bits_24);
}

VisibleTriangles seen_by_zbuffer_float(const VisibilityScene& scene) {
  return nearest(scene, Format::floating);
}

VisibleTriangles seen_by_zbuffer_reversed(const VisibilityScene& scene) {
  return nearest(scene, Format::reversed);
}

}  // namespace rasterlab
