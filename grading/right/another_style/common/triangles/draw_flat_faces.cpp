// A right answer written differently: the normal by a cross product of its own, the face by the box
// of its corners.
#include "common/triangles/draw_flat_faces.h"

#include "common/image/check.h"
#include "common/mesh/normals.h"
#include "common/triangles/face_corners.h"
#include "common/triangles/fill_spans.h"

#include <algorithm>

namespace rasterlab {

float flat_intensity(const Eigen::Vector3f& normal) {
  return normal.z() > 0 ? normal.z() : 0.0F;
}

void draw_flat_faces(Image<Rgb8>& image, const Mesh& mesh) {
  for (const Mesh::Triangle& face : mesh.triangles) {
    const Eigen::Vector3d a = mesh.positions[face[0]].cast<double>();
    const Eigen::Vector3d b = mesh.positions[face[1]].cast<double>();
    const Eigen::Vector3d c = mesh.positions[face[2]].cast<double>();
    const Eigen::Vector3d normal = (b - a).cross(c - a).stableNormalized();
    const float grey = flat_intensity(normal.cast<float>());
    const Corners corners = face_corners(mesh, face, image.width(), image.height());
    if (grey > 0 && within(corners, max_wide_coordinate))
      fill_spans(image, corners, to_rgb8(Color(grey, grey, grey)));
  }
}

}  // namespace rasterlab
