#include "06_texture/any_mesh.h"

#include "common/lighting/shading.h"
#include "common/lighting/vertex_normals.h"
#include "common/texture/textured_mesh.h"

#include <memory>
#include <utility>

namespace rasterlab {

DrawFrame draw_any_mesh(const Subject& subject) {
  Mesh mesh = subject.mesh;
  if (mesh.normals.empty()) mesh.normals = vertex_normals(mesh);
  std::shared_ptr<const Texture> texture;
  if (!subject.texture.empty()) {
    require_texture_coordinates(mesh);
    texture = std::make_shared<Texture>(subject.texture);
  }
  return [mesh = std::move(mesh), texture, &subject](const View& view, Frame& frame) {
    clear(frame);
    const LitMesh lit_mesh = {.mesh = mesh,
                              .transforms = view.transforms,
                              .light = view.light,
                              .material = subject.material,
                              .color = subject.color,
                              .cull = subject.cull};
    if (!texture) return statistics(shade_phong(lit_mesh, frame));
    const Sampler sampler = {.texture = texture.get(),
                             .filter = filter_named(subject.filter),
                             .wrap = wrap_named(subject.wrap)};
    return statistics(draw_textured_mesh(lit_mesh, sampler, frame));
  };
}

}  // namespace rasterlab
