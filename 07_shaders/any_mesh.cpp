#include "07_shaders/any_mesh.h"

#include "common/lighting/turned_light.h"
#include "common/lighting/with_normals.h"
#include "common/viewer/tiled_drawing.h"

#include "07_shaders/draw_by_name.h"
#include "07_shaders/shader_list.h"

#include <memory>
#include <optional>
#include <utility>

namespace rasterlab {
namespace {

/// What stays the same from frame to frame.
class Prepared {
 public:
  explicit Prepared(const Subject& subject)
      : subject_(subject),
        mesh_(with_normals(subject.mesh)),
        texture_(load(subject.texture)),
        normal_map_(load(subject.normal_map)),
        specular_map_(load(subject.specular_map)) {
    // Whatever a shader lacks is said here, before anything is drawn.
    with_shader(shader_list, subject.shader, inputs({}), [](const auto&) { return true; });
  }

  const Mesh& mesh() const { return mesh_; }
  const Subject& subject() const { return subject_; }

  ShaderInputs inputs(const View& view) const {
    return {.mesh = mesh_,
            .transforms = view.transforms,
            .light = view.light,
            .material = subject_.material,
            .color = subject_.color,
            .texture = sampler(texture_),
            .normal_map = sampler(normal_map_),
            .object_normal_map = sampler(normal_map_),
            .specular_map = sampler(specular_map_)};
  }

 private:
  std::optional<Texture> load(const Image<Rgb8>& image) const {
    if (image.empty()) return std::nullopt;
    return Texture(image, levels_for(filter_named(subject_.filter)));
  }

  std::optional<Sampler> sampler(const std::optional<Texture>& texture) const {
    if (!texture) return std::nullopt;
    return Sampler{&*texture, filter_named(subject_.filter), wrap_named(subject_.wrap)};
  }

  const Subject& subject_;
  Mesh mesh_;
  std::optional<Texture> texture_;
  std::optional<Texture> normal_map_;
  std::optional<Texture> specular_map_;
};

DrawFrame draw_by_exercise(const Subject& subject) {
  const auto prepared = std::make_shared<Prepared>(subject);
  return [prepared](const View& view, Frame& frame) {
    clear(frame);
    return statistics(draw_by_name(prepared->subject().shader, prepared->inputs(view),
                                   prepared->subject().cull, frame));
  };
}

DrawFrame draw_tiled(const Subject& subject) {
  const auto prepared = std::make_shared<Prepared>(subject);
  const auto drawing = std::make_shared<TiledDrawing>(subject, prepared->mesh());
  return [prepared, drawing](const View& view, Frame& frame) {
    const auto draw = [&](const auto& shader) {
      return drawing->draw(view, shading(shader), frame);
    };
    return with_shader(shader_list, prepared->subject().shader, prepared->inputs(view), draw);
  };
}

}  // namespace

ViewerOptions viewer_options() {
  ViewerOptions options = {.exercise = &draw_by_exercise,
                           .tiled = &draw_tiled,
                           .tiled_by_default = true,
                           .turn_light = &turned_light,
                           .textured = true,
                           .mapped = true};
  for (const auto& [name, description] : shader_names(shader_list)) {
    options.shaders.push_back({name, description});
  }
  options.shaders = with_default(options.shaders, "phong");
  for (const FilterRung& rung : filter_ladder()) {
    options.filters.push_back({rung.name, rung.known_fault});
  }
  options.filters = with_default(options.filters, "trilinear");
  for (const NamedWrap& mode : wrap_modes()) options.wraps.push_back({mode.name, mode.description});
  return options;
}

}  // namespace rasterlab
