#include "common/triangles/draw_flat_faces.h"

#include "common/image/check.h"
#include "common/mesh/normals.h"
#include "common/triangles/face_corners.h"
#include "common/triangles/fill_spans.h"

#include <algorithm>

namespace rasterlab {

float flat_intensity(const Eigen::Vector3f& normal) {
  // <solution>
  const Eigen::Vector3f light(0, 0, -1);
  return std::max(-normal.dot(light), 0.0F);
  // <starter> throw NotWritten("02.7", normal);
  // </solution>
}

void draw_flat_faces(Image<Rgb8>& image, const Mesh& mesh) {
  // <solution>
  const std::vector<Eigen::Vector3f> normals = face_normals(mesh);
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
    const float intensity = flat_intensity(normals[face]);
    const Corners corners = face_corners(mesh, mesh.triangles[face], image.width(), image.height());
    if (!(intensity > 0) || !within(corners, max_wide_coordinate)) continue;
    fill_spans(image, corners, to_rgb8(Color::Constant(intensity)));
  }
  // <starter> throw NotWritten("02.7", image, mesh);
  // </solution>
}

}  // namespace rasterlab
