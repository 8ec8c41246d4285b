#include "06_texture/any_mesh.h"

#include "common/lighting/shading.h"
#include "common/lighting/with_normals.h"
#include "common/texture/textured_mesh.h"
#include "common/viewer/tiled_drawing.h"

#include "06_texture/shaders.h"

#include <memory>
#include <optional>

namespace rasterlab {
namespace {

constexpr const char* unread_levels = "unread levels";

/// What stays the same from frame to frame.
class Prepared {
 public:
  explicit Prepared(const Subject& subject) : subject_(subject), mesh_(with_normals(subject.mesh)) {
    if (subject.texture.empty()) return;
    require_texture_coordinates(mesh_);
    texture_.emplace(subject.texture, subject.skips(unread_levels)
                                          ? levels_for(filter_named(subject.filter))
                                          : MipLevels::all);
  }

  const Mesh& mesh() const { return mesh_; }

  LitMesh lit_mesh(const View& view) const {
    return {.mesh = mesh_,
            .transforms = view.transforms,
            .light = view.light,
            .material = subject_.material,
            .color = subject_.color,
            .cull = subject_.cull};
  }

  /// None where no texture was given.
  std::optional<Sampler> sampler() const {
    if (!texture_) return std::nullopt;
    return Sampler{&*texture_, filter_named(subject_.filter), wrap_named(subject_.wrap)};
  }

  /// The counts of a frame, with what was not made for it.
  nlohmann::json with_skipped(nlohmann::json counts) const {
    counts["levels_skipped"] = texture_ ? texture_->levels_left_out() : 0;
    return counts;
  }

 private:
  const Subject& subject_;
  Mesh mesh_;
  std::optional<Texture> texture_;
};

}  // namespace

DrawFrame draw_any_mesh(const Subject& subject) {
  const auto prepared = std::make_shared<const Prepared>(subject);
  return [prepared](const View& view, Frame& frame) {
    clear(frame);
    const LitMesh lit_mesh = prepared->lit_mesh(view);
    const std::optional<Sampler> sampler = prepared->sampler();
    return prepared->with_skipped(statistics(sampler ? draw_textured_mesh(lit_mesh, *sampler, frame)
                                                     : shade_phong(lit_mesh, frame)));
  };
}

DrawFrame draw_any_mesh_tiled(const Subject& subject) {
  const auto prepared = std::make_shared<const Prepared>(subject);
  const auto drawing = std::make_shared<TiledDrawing>(subject, prepared->mesh());
  return [prepared, drawing](const View& view, Frame& frame) {
    const LitMesh lit_mesh = prepared->lit_mesh(view);
    const SurfaceLighting lighting(lit_mesh);
    const std::optional<Sampler> sampler = prepared->sampler();
    return prepared->with_skipped(
        sampler ? drawing->draw(view, shading(LitTexture{lighting, *sampler}), frame)
                : drawing->draw(view, shading(LitColors{lighting}), frame));
  };
}

Choices texture_skips() {
  return {{unread_levels}};
}

}  // namespace rasterlab
