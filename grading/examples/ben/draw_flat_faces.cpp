#include "common/triangles/draw_flat_faces.h"

#include "common/mesh/normals.h"
#include "common/triangles/face_corners.h"
#include "common/triangles/fill_spans.h"

#include <cmath>

namespace rasterlab {

float flat_intensity(const Eigen::Vector3f& n) {
  return std::fabs(n.z());
}

void draw_flat_faces(Image<Rgb8>& image, const Mesh& mesh) {
  auto normals = face_normals(mesh);
  for (size_t f = 0; f < mesh.triangles.size(); f++) {
    float i = flat_intensity(normals[f]);
    fill_spans(image, face_corners(mesh, mesh.triangles[f], image.width(), image.height()),
               to_rgb8({i, i, i}));
  }
}

}  // namespace rasterlab
