#include "04_projection/any_mesh.h"

#include "common/mesh/normals.h"
#include "common/projection/normal_matrix.h"
#include "common/projection/render.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace rasterlab {
namespace {

// Each face in one colour, as bright as it faces the viewer.
DrawCounts draw_facing(const Subject& subject, const std::vector<Eigen::Vector3f>& normals,
                       const View& view, Frame& frame) {
  const Color color = subject.color.value_or(Color::Constant(0.8F));
  const Eigen::Matrix3f to_camera = normal_matrix(view.transforms.model_view());
  return draw_mesh(subject.mesh, view.transforms, subject.cull, frame,
                   [&](std::uint32_t triangle, const TrianglePixel&) -> Color {
                     const float facing = transform_normal(to_camera, normals[triangle]).z();
                     return color * (0.15F + 0.85F * std::abs(facing));
                   });
}

}  // namespace

DrawFrame draw_any_mesh(const Subject& subject) {
  const bool has_colors = !subject.mesh.colors.empty() && !subject.color;
  return
      [&subject, has_colors, normals = face_normals(subject.mesh)](const View& view, Frame& frame) {
        clear(frame);
        return statistics(has_colors
                              ? render_nearest(subject.mesh, view.transforms, subject.cull, frame)
                              : draw_facing(subject, normals, view, frame));
      };
}

}  // namespace rasterlab
