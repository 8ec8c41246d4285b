#include "07_shaders/any_mesh.h"

#include "common/engine/renderer.h"
#include "common/lighting/turned_light.h"
#include "common/lighting/vertex_normals.h"

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
  static Mesh with_normals(Mesh mesh) {
    if (mesh.normals.empty()) mesh.normals = vertex_normals(mesh);
    return mesh;
  }

  static std::optional<Texture> load(const Image<Rgb8>& image) {
    return image.empty() ? std::nullopt : std::optional<Texture>(image);
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

/// The engine with all it keeps from frame to frame.
struct Tiled {
  explicit Tiled(const Subject& subject)
      : prepared(subject), mesh(prepared.mesh()), renderer(options(subject)) {}

  static EngineOptions options(const Subject& subject) {
    EngineOptions options;
    options.threads = subject.threads;
    if (!subject.simd.empty()) options.simd = simd_target(subject.simd);
    return options;
  }

  /// The framebuffer, kept while frames have one size.
  Framebuffer& cleared(int width, int height) {
    if (!framebuffer || framebuffer->width() != width || framebuffer->height() != height) {
      framebuffer.emplace(width, height);
    }
    framebuffer->clear();
    return *framebuffer;
  }

  Prepared prepared;
  PreparedMesh mesh;
  Renderer renderer;
  std::optional<Framebuffer> framebuffer;
};

DrawFrame draw_tiled(const Subject& subject) {
  const auto tiled = std::make_shared<Tiled>(subject);
  return [tiled](const View& view, Frame& frame) {
    Framebuffer& target = tiled->cleared(frame.width(), frame.height());
    const auto draw = [&](const auto& shader) {
      return to_json(tiled->renderer.draw({.mesh = &tiled->mesh,
                                           .matrix = view.transforms.to_clip(),
                                           .cull = tiled->prepared.subject().cull,
                                           .mirrored = view.transforms.mirrored(),
                                           .shading = shading(shader)},
                                          target));
    };
    nlohmann::json counts = with_shader(shader_list, tiled->prepared.subject().shader,
                                        tiled->prepared.inputs(view), draw);
    frame.color = target.color();
    if (!frame.distance.empty()) frame.distance = target.distance(view.transforms.projection);
    if (!frame.ids.empty()) frame.ids = target.ids();
    return counts;
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
  for (const SimdTarget target : supported_simd_targets()) {
    options.simd_targets.push_back({std::string(name_of(target))});
  }
  return options;
}

}  // namespace rasterlab
