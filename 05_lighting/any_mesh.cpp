#include "05_lighting/any_mesh.h"

#include "common/lighting/light_vertices.h"
#include "common/lighting/shading.h"
#include "common/lighting/with_normals.h"
#include "common/projection/color_shaders.h"
#include "common/viewer/tiled_drawing.h"

#include <memory>
#include <vector>

namespace rasterlab {
namespace {

LitMesh lit_mesh(const Mesh& mesh, const Subject& subject, const View& view) {
  return {.mesh = mesh,
          .transforms = view.transforms,
          .light = view.light,
          .material = subject.material,
          .color = subject.color,
          .cull = subject.cull};
}

}  // namespace

DrawFrame draw_any_mesh(const Subject& subject) {
  return [mesh = with_normals(subject.mesh), &subject](const View& view, Frame& frame) {
    clear(frame);
    return statistics(shade_gouraud(lit_mesh(mesh, subject, view), frame));
  };
}

DrawFrame draw_any_mesh_tiled(const Subject& subject) {
  const auto mesh = std::make_shared<const Mesh>(with_normals(subject.mesh));
  const auto drawing = std::make_shared<TiledDrawing>(subject, *mesh);
  return [mesh, drawing, &subject](const View& view, Frame& frame) {
    const std::vector<Color> colors = light_vertices(lit_mesh(*mesh, subject, view));
    return drawing->draw(view, shading(VertexColorShader{colors}), frame);
  };
}

}  // namespace rasterlab
