#include "common/zbuffer/draw_flat_depth.h"

#include "common/image/check.h"
#include "common/mesh/normals.h"
#include "common/triangles/draw_flat_faces.h"
#include "common/triangles/face_corners.h"
#include "common/zbuffer/draw_depth_triangle.h"

namespace rasterlab {

void draw_flat_depth(Image<Rgb8>& image, DepthBuffer& depth, const Mesh& mesh) {
  // <solution>
  const std::vector<Eigen::Vector3f> normals = face_normals(mesh);
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
    const float intensity = flat_intensity(normals[face]);
    const Corners window = face_corners(mesh, mesh.triangles[face], image.width(), image.height());
    if (!(intensity > 0) || !within(window, max_wide_coordinate)) continue;
    std::array<DepthCorner, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const float z = -mesh.positions[mesh.triangles[face][i]].z();
      corners[i] = {window[i], z, Color::Constant(intensity)};
    }
    draw_depth_triangle(image, depth, corners);
  }
  // <starter> throw NotWritten("03.6", image, depth, mesh);
  // </solution>
}

}  // namespace rasterlab
