#include "05_lighting/any_mesh.h"

#include "common/lighting/shading.h"
#include "common/lighting/vertex_normals.h"

#include <utility>

namespace rasterlab {

DrawFrame draw_any_mesh(const Subject& subject) {
  Mesh mesh = subject.mesh;
  if (mesh.normals.empty()) mesh.normals = vertex_normals(mesh);
  return [mesh = std::move(mesh), &subject](const View& view, Frame& frame) {
    clear(frame);
    return statistics(shade_gouraud({.mesh = mesh,
                                     .transforms = view.transforms,
                                     .light = view.light,
                                     .material = subject.material,
                                     .color = subject.color,
                                     .cull = subject.cull},
                                    frame));
  };
}

}  // namespace rasterlab
