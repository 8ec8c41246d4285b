#include "common/viewer/tiled_drawing.h"

#include <string>

namespace rasterlab {
namespace {

EngineOptions options_of(const Subject& subject) {
  EngineOptions options;
  options.threads = subject.threads;
  options.skip = skips_without(subject.without);
  if (!subject.simd.empty()) options.simd = simd_target(subject.simd);
  return options;
}

}  // namespace

Choices simd_choices() {
  Choices choices;
  for (const SimdTarget target : supported_simd_targets()) {
    choices.push_back({std::string(name_of(target))});
  }
  return choices;
}

Choices skip_choices(const ViewerOptions& options) {
  Choices choices;
  for (const NamedSkip& one : named_skips) choices.push_back({one.name});
  choices.insert(choices.end(), options.skips.begin(), options.skips.end());
  return choices;
}

TiledDrawing::TiledDrawing(const Subject& subject, const Mesh& mesh)
    : cull_(subject.cull), mesh_(mesh), renderer_(options_of(subject)) {}

Framebuffer& TiledDrawing::cleared(int width, int height) {
  if (!framebuffer_ || framebuffer_->width() != width || framebuffer_->height() != height) {
    framebuffer_.emplace(width, height);
  }
  framebuffer_->clear();
  return *framebuffer_;
}

nlohmann::json TiledDrawing::draw(const View& view, const Shading& shading, Frame& frame) {
  Framebuffer& target = cleared(frame.width(), frame.height());
  const bool picture_only = frame.distance.empty() && frame.ids.empty();
  const Statistics counts = renderer_.draw({.mesh = &mesh_,
                                            .matrix = view.transforms.to_clip(),
                                            .cull = cull_,
                                            .mirrored = view.transforms.mirrored(),
                                            .shading = shading,
                                            .keep = picture_only ? Keep::color : Keep::everything},
                                           target);
  frame.color = target.color();
  if (!frame.distance.empty()) frame.distance = target.distance(view.transforms.projection);
  if (!frame.ids.empty()) frame.ids = target.ids();
  return to_json(counts);
}

}  // namespace rasterlab
