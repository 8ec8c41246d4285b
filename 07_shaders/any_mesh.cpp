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

constexpr const char* unread_textures = "unread textures";
constexpr const char* unread_levels = "unread levels";
constexpr const char* unread_normals = "unread normals";

/// A texture that is made when it is first asked for. The subject outlives it.
class TextureOnDemand {
 public:
  /// No texture where the image is empty.
  TextureOnDemand(const Subject& subject, const Image<Rgb8>& image)
      : subject_(subject), image_(image) {
    if (!image.empty() && !subject.skips(unread_textures)) make();
  }

  SamplerInput input() {
    if (image_.empty()) return {};
    return SamplerInput([this] { return sampler(); });
  }

  bool skipped() const { return !image_.empty() && !texture_; }
  int levels_skipped() const { return texture_ ? texture_->levels_left_out() : 0; }

 private:
  Filter filter() const { return filter_named(subject_.filter); }

  void make() {
    texture_.emplace(image_, subject_.skips(unread_levels) ? levels_for(filter()) : MipLevels::all);
  }

  Sampler sampler() {
    if (!texture_) make();
    return {&*texture_, filter(), wrap_named(subject_.wrap)};
  }

  const Subject& subject_;
  const Image<Rgb8>& image_;
  std::optional<Texture> texture_;
};

/// What stays the same from frame to frame.
class Prepared {
 public:
  explicit Prepared(const Subject& subject)
      : subject_(subject),
        mesh_(needs_normals() ? with_normals(subject.mesh) : subject.mesh),
        texture_(subject, subject.texture),
        normal_map_(subject, subject.normal_map),
        specular_map_(subject, subject.specular_map) {
    // Whatever a shader lacks is said here, before anything is drawn; what it reads is made here.
    with_shader(shader_list, subject.shader, inputs({}), [](const auto&) { return true; });
  }

  const Mesh& mesh() const { return mesh_; }
  const Subject& subject() const { return subject_; }

  ShaderInputs inputs(const View& view) {
    const SamplerInput normal_map = normal_map_.input();
    return {.mesh = mesh_,
            .transforms = view.transforms,
            .light = view.light,
            .material = subject_.material,
            .color = subject_.color,
            .texture = texture_.input(),
            .normal_map = normal_map,
            .object_normal_map = normal_map,
            .specular_map = specular_map_.input()};
  }

  /// The counts of a frame, with what was not made for it.
  nlohmann::json with_skipped(nlohmann::json counts) const {
    int textures = 0;
    int levels = 0;
    for (const TextureOnDemand* texture : {&texture_, &normal_map_, &specular_map_}) {
      textures += texture->skipped() ? 1 : 0;
      levels += texture->levels_skipped();
    }
    counts["textures_skipped"] = textures;
    counts["levels_skipped"] = levels;
    counts["normals_skipped"] = mesh_.normals.empty() ? mesh_.positions.size() : 0;
    return counts;
  }

 private:
  bool needs_normals() const {
    return !subject_.skips(unread_normals) || reads_vertex_normals(shader_list, subject_.shader);
  }

  const Subject& subject_;
  Mesh mesh_;
  TextureOnDemand texture_;
  TextureOnDemand normal_map_;
  TextureOnDemand specular_map_;
};

DrawFrame draw_by_exercise(const Subject& subject) {
  const auto prepared = std::make_shared<Prepared>(subject);
  return [prepared](const View& view, Frame& frame) {
    clear(frame);
    return prepared->with_skipped(statistics(draw_by_name(
        prepared->subject().shader, prepared->inputs(view), prepared->subject().cull, frame)));
  };
}

DrawFrame draw_tiled(const Subject& subject) {
  const auto prepared = std::make_shared<Prepared>(subject);
  const auto drawing = std::make_shared<TiledDrawing>(subject, prepared->mesh());
  return [prepared, drawing](const View& view, Frame& frame) {
    const auto draw = [&](const auto& shader) {
      return prepared->with_skipped(drawing->draw(view, shading(shader), frame));
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
                           .mapped = true,
                           .skips = {{unread_textures}, {unread_levels}, {unread_normals}}};
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
