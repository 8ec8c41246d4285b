// A right answer written differently: pixel by pixel, in depth and grey, without
// draw_depth_triangle().
#include "common/zbuffer/draw_flat_depth.h"

#include "common/triangles/draw_flat_faces.h"
#include "common/triangles/face_corners.h"
#include "common/triangles/rasterize.h"
#include "common/zbuffer/draw_point.h"

namespace rasterlab {

void draw_flat_depth(Image<Rgb8>& image, DepthBuffer& depth, const Mesh& mesh) {
  for (const Mesh::Triangle& triangle : mesh.triangles) {
    const Eigen::Vector3f& a = mesh.positions[triangle[0]];
    const Eigen::Vector3f& b = mesh.positions[triangle[1]];
    const Eigen::Vector3f& c = mesh.positions[triangle[2]];
    const Eigen::Vector3d across = (b - a).cast<double>().cross((c - a).cast<double>());
    const float grey = flat_intensity(across.normalized().cast<float>());
    const Corners corners = face_corners(mesh, triangle, image.width(), image.height());
    if (!(grey > 0) || !within(corners, max_wide_coordinate)) continue;
    const Eigen::Vector3d z(-a.z(), -b.z(), -c.z());
    rasterize_wide_triangle(corners, image.width(), image.height(),
                            [&](int x, int y, const Eigen::Vector3d& weights) {
                              draw_point(image, depth, {x, y}, static_cast<float>(weights.dot(z)),
                                         Color::Constant(grey));
                            });
  }
}

}  // namespace rasterlab
