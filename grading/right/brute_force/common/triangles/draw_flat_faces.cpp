// A right answer written differently: every face fills the pixels that rasterize.h says it covers.
#include "common/triangles/draw_flat_faces.h"

#include "common/image/check.h"
#include "common/mesh/normals.h"
#include "common/triangles/face_corners.h"
#include "common/triangles/fill_spans.h"
#include "common/triangles/rasterize.h"

#include <algorithm>
#include <cmath>

namespace rasterlab {

float flat_intensity(const Eigen::Vector3f& normal) {
  const float intensity = -(normal.x() * 0 + normal.y() * 0 + normal.z() * -1);
  return std::isnan(intensity) || intensity < 0 ? 0 : intensity;
}

void draw_flat_faces(Image<Rgb8>& image, const Mesh& mesh) {
  const std::vector<Eigen::Vector3f> normals = face_normals(mesh);
  for (std::size_t i = 0; i < normals.size(); i++) {
    const Corners corners = face_corners(mesh, mesh.triangles[i], image.width(), image.height());
    const Color color = Color::Ones() * flat_intensity(normals[i]);
    if (color.x() == 0 || !within(corners, max_wide_coordinate)) continue;
    rasterize_wide_triangle(
        corners, image.width(), image.height(),
        [&](int x, int y, const Eigen::Vector3d&) { image(x, y) = to_rgb8(color); });
  }
}

}  // namespace rasterlab
