// A right answer written differently: the normal from the cross product at hand, the light's sign
// put into it.
#include "common/triangles/draw_flat_faces.h"

#include "common/triangles/face_corners.h"
#include "common/triangles/fill_spans.h"

namespace rasterlab {

float flat_intensity(const Eigen::Vector3f& normal) {
  return normal.z() > 0 ? normal.z() : 0.0F;
}

void draw_flat_faces(Image<Rgb8>& image, const Mesh& mesh) {
  for (const Mesh::Triangle& triangle : mesh.triangles) {
    const Eigen::Vector3d a = mesh.positions[triangle[0]].cast<double>();
    const Eigen::Vector3d b = mesh.positions[triangle[1]].cast<double>();
    const Eigen::Vector3d c = mesh.positions[triangle[2]].cast<double>();
    const Eigen::Vector3d across = (b - a).cross(c - a);
    const double length = across.norm();
    if (!(length > 0)) continue;
    const float grey = flat_intensity((across / length).cast<float>());
    const Corners corners = face_corners(mesh, triangle, image.width(), image.height());
    if (grey > 0 && within(corners, max_wide_coordinate)) {
      fill_spans(image, corners, to_rgb8({grey, grey, grey}));
    }
  }
}

}  // namespace rasterlab
