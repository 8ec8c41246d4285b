// A right answer written differently: all faces are put into the window first, the ones that count
// drawn after.
#include "common/zbuffer/draw_flat_depth.h"

#include "common/image/check.h"
#include "common/mesh/normals.h"
#include "common/triangles/draw_flat_faces.h"
#include "common/triangles/face_corners.h"
#include "common/zbuffer/draw_depth_triangle.h"

#include <cmath>
#include <vector>

namespace rasterlab {

void draw_flat_depth(Image<Rgb8>& image, DepthBuffer& depth, const Mesh& mesh) {
  std::vector<std::array<DepthCorner, 3>> chosen;
  const std::vector<Eigen::Vector3f> normals = face_normals(mesh);
  for (std::size_t face = 0; face < normals.size(); ++face) {
    const Corners window = face_corners(mesh, mesh.triangles[face], image.width(), image.height());
    const float grey = flat_intensity(normals[face]);
    if (grey == 0 || std::isnan(grey) || !within(window, max_wide_coordinate)) continue;
    std::array<DepthCorner, 3>& corners = chosen.emplace_back();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      corners[i].position = window[i];
      corners[i].z = 0 - mesh.positions[mesh.triangles[face][i]].z();
      corners[i].color = Color(grey, grey, grey);
    }
  }
  for (const auto& corners : chosen) draw_depth_triangle(image, depth, corners);
}

}  // namespace rasterlab
