#include "common/triangles/draw_flat_faces.h"

#include "common/triangles/face_corners.h"
#include "common/triangles/fill_spans.h"

namespace rasterlab {

float flat_intensity(const Eigen::Vector3f& normal) {
  return std::max(normal.z(), 0.0F);
}

void draw_flat_faces(Image<Rgb8>& image, const Mesh& mesh) {
  for (const Mesh::Triangle& face : mesh.triangles) {
    const Eigen::Vector3f a = mesh.positions[face[0]];
    const Eigen::Vector3f ab = mesh.positions[face[1]] - a, ac = mesh.positions[face[2]] - a;
    const float light = flat_intensity(ab.cross(ac).normalized());
    if (!(light > 0)) continue;
    const Corners corners = face_corners(mesh, face, image.width(), image.height());
    fill_spans(image, corners, to_rgb8(Color(light, light, light)));
  }
}

}  // namespace rasterlab
