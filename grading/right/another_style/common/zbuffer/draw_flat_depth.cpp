// A right answer written differently: the pixels of each face straight from rasterize.h.
#include "common/zbuffer/draw_flat_depth.h"

#include "common/image/check.h"
#include "common/mesh/normals.h"
#include "common/triangles/draw_flat_faces.h"
#include "common/triangles/face_corners.h"
#include "common/triangles/rasterize.h"
#include "common/zbuffer/draw_depth_triangle.h"
#include "common/zbuffer/draw_point.h"

#include <array>

namespace rasterlab {

void draw_flat_depth(Image<Rgb8>& image, DepthBuffer& depth, const Mesh& mesh) {
  for (const Mesh::Triangle& face : mesh.triangles) {
    const auto& [a, b, c] =
        std::array{mesh.positions[face[0]], mesh.positions[face[1]], mesh.positions[face[2]]};
    const Eigen::Vector3f normal =
        (b - a).cast<double>().cross((c - a).cast<double>()).stableNormalized().cast<float>();
    const float grey = flat_intensity(normal);
    const Corners window = face_corners(mesh, face, image.width(), image.height());
    if (!(grey > 0) || !within(window, max_wide_coordinate)) continue;
    const Eigen::Vector3d depths(-a.z(), -b.z(), -c.z());
    rasterize_wide_triangle(
        window, image.width(), image.height(), [&](int x, int y, const Eigen::Vector3d& weights) {
          draw_point(image, depth, {x, y}, float(weights.dot(depths)), Color::Constant(grey));
        });
  }
}

}  // namespace rasterlab
