// A right answer written differently: for each pixel of a triangle the code that the format holds,
// in an integer where it is one; the formats told apart by a switch.
#include "common/triangles/rasterize.h"
#include "common/zbuffer/visibility.h"

#include <cmath>

namespace rasterlab {
namespace {

enum class Format { unorm_16, unorm_24, standard_float, reversed_float };

/// What is stored, larger being nearer in every format.
double stored(Format format, double near, double far, double inverse_distance) {
  if (format == Format::reversed_float) return float(near * inverse_distance);
  const double depth = far / (far - near) * (1 - near * inverse_distance);
  if (format == Format::standard_float) return -float(depth);
  const double largest = format == Format::unorm_16 ? 65535 : 16777215;
  return -std::floor(depth * largest + 0.5);
}

VisibleTriangles seen(const VisibilityScene& scene, Format format) {
  VisibleTriangles result(scene.width, scene.height, -1);
  Image<double> nearest(scene.width, scene.height, -1e300);
  std::int32_t index = 0;
  for (const VisibilityTriangle& triangle : scene.triangles) {
    const auto& d = triangle.distances;
    rasterize_triangle(triangle.corners, scene.width, scene.height,
                       [&](int x, int y, const Eigen::Vector3d& w) {
                         const double code = stored(format, double(scene.near), double(scene.far),
                                                    w[0] / d[0] + w[1] / d[1] + w[2] / d[2]);
                         if (code <= nearest(x, y)) return;
                         nearest(x, y) = code;
                         result(x, y) = index;
                       });
    ++index;
  }
  return result;
}

}  // namespace

VisibleTriangles seen_by_zbuffer_16(const VisibilityScene& scene) {
  return seen(scene, Format::unorm_16);
}

VisibleTriangles seen_by_zbuffer_24(const VisibilityScene& scene) {
  return seen(scene, Format::unorm_24);
}

VisibleTriangles seen_by_zbuffer_float(const VisibilityScene& scene) {
  return seen(scene, Format::standard_float);
}

VisibleTriangles seen_by_zbuffer_reversed(const VisibilityScene& scene) {
  return seen(scene, Format::reversed_float);
}

}  // namespace rasterlab
