#include "04_projection/any_mesh.h"

#include "common/mesh/normals.h"
#include "common/projection/color_shaders.h"
#include "common/projection/normal_matrix.h"
#include "common/projection/render.h"
#include "common/viewer/tiled_drawing.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace rasterlab {
namespace {

bool in_vertex_colors(const Subject& subject) {
  return !subject.mesh.colors.empty() && !subject.color;
}

// Each face in one colour, as bright as it faces the viewer.
std::vector<Color> facing_colors(const Subject& subject,
                                 const std::vector<Eigen::Vector3f>& normals, const View& view) {
  const Color color = subject.color.value_or(Color::Constant(0.8F));
  const Eigen::Matrix3f to_camera = normal_matrix(view.transforms.model_view());
  std::vector<Color> colors;
  colors.reserve(normals.size());
  for (const Eigen::Vector3f& normal : normals) {
    const float facing = transform_normal(to_camera, normal).z();
    colors.emplace_back(color * (0.15F + 0.85F * std::abs(facing)));
  }
  return colors;
}

}  // namespace

DrawFrame draw_any_mesh(const Subject& subject) {
  if (in_vertex_colors(subject)) {
    return [&subject](const View& view, Frame& frame) {
      clear(frame);
      return statistics(render_nearest(subject.mesh, view.transforms, subject.cull, frame));
    };
  }
  return [&subject, normals = face_normals(subject.mesh)](const View& view, Frame& frame) {
    clear(frame);
    const std::vector<Color> colors = facing_colors(subject, normals, view);
    return statistics(
        draw_mesh(subject.mesh, view.transforms, subject.cull, frame,
                  [&](std::uint32_t triangle, const TrianglePixel&) { return colors[triangle]; }));
  };
}

DrawFrame draw_any_mesh_tiled(const Subject& subject) {
  const auto drawing = std::make_shared<TiledDrawing>(subject, subject.mesh);
  if (in_vertex_colors(subject)) {
    return [&subject, drawing](const View& view, Frame& frame) {
      return drawing->draw(view, shading(VertexColorShader{subject.mesh.colors}), frame);
    };
  }
  return [&subject, drawing, normals = face_normals(subject.mesh)](const View& view, Frame& frame) {
    const std::vector<Color> colors = facing_colors(subject, normals, view);
    return drawing->draw(view, shading(FaceColorShader{{colors}}), frame);
  };
}

}  // namespace rasterlab
