#include "bench/engine_ladders/skips.h"

#include "common/engine/renderer.h"

#include "bench/engine/bench_shaders.h"

#include <memory>
#include <vector>

namespace rasterlab::bench {
namespace {

constexpr int width = 1920;
constexpr int height = 1080;

/// A scene, and the engine that draws it with some skips, on one thread.
class SkippingDrawing {
 public:
  SkippingDrawing(std::shared_ptr<const Scene> scene, std::shared_ptr<const PreparedMesh> mesh,
                  const Skips& skips)
      : scene_(std::move(scene)),
        mesh_(std::move(mesh)),
        shader_{{.eye = scene_->eye}},
        renderer_({.threads = 1, .skip = skips}),
        frame_(width, height) {}

  const Framebuffer& draw(Keep keep) {
    frame_.clear();
    renderer_.draw({.mesh = mesh_.get(),
                    .matrix = scene_->matrix,
                    .cull = Cull::back,
                    .shading = shading(shader_),
                    .keep = keep},
                   frame_);
    return frame_;
  }

 private:
  std::shared_ptr<const Scene> scene_;
  std::shared_ptr<const PreparedMesh> mesh_;
  PhongShader shader_;
  Renderer renderer_;
  Framebuffer frame_;
};

struct Picture {
  Image<Rgb8> color;
  Image<std::int32_t> ids;
  Image<float> depth;

  /// The colours of what is measured, the rest of what is drawn once more with it kept.
  explicit Picture(SkippingDrawing& drawing) : color(drawing.draw(Keep::color).color()) {
    const Framebuffer& all = drawing.draw(Keep::everything);
    ids = all.ids();
    depth = all.depth();
  }
};

/// Pixels of a million that are not the same, in colour, triangle or depth.
Errors difference(const Picture& a, const Picture& b) {
  double different = 0;
  for (std::size_t i = 0; i < a.color.pixels().size(); ++i) {
    const bool same = a.color.pixels()[i] == b.color.pixels()[i] &&
                      a.ids.pixels()[i] == b.ids.pixels()[i] &&
                      a.depth.pixels()[i] == b.depth.pixels()[i];
    different += same ? 0 : 1;
  }
  return {{"different pixels per million",
           1e6 * different / static_cast<double>(a.color.pixels().size())}};
}

}  // namespace

std::vector<SceneEntry> skip_scenes() {
  std::vector<SceneEntry> chosen;
  for (const SceneEntry& entry : scenes()) {
    if (entry.name == "planet" || entry.name == "sphere 1M" || entry.name == "tori far to near") {
      chosen.push_back(entry);
    }
  }
  chosen.push_back({"tori around the eye", &tori_around_the_eye});
  return chosen;
}

TimedLadder skip_ladder(const SceneEntry& entry) {
  const auto scene = std::make_shared<const Scene>(entry.make({width, height}));
  const auto mesh = std::make_shared<const PreparedMesh>(scene->mesh);
  TimedLadder ladder{.name = "skipping, " + entry.name,
                     .stage = "engine",
                     .unit = "pixel of the picture",
                     .units = width * height,
                     .error = "different pixels per million",
                     .rungs = {}};
  SkippingDrawing plain(scene, mesh, no_skips());
  const Picture truth(plain);
  const auto add = [&](const std::string& rung, const Skips& skips) {
    const auto drawing = std::make_shared<SkippingDrawing>(scene, mesh, skips);
    ladder.rungs.push_back({.name = rung,
                            .fault = "none",
                            .work = [drawing] { drawing->draw(Keep::color); },
                            .errors = difference(Picture(*drawing), truth)});
  };
  add("nothing skipped", no_skips());
  for (const NamedSkip& one : named_skips) {
    Skips skips;
    skips.*one.skip = false;
    add(std::string("all but ") + one.name, skips);
  }
  add("all", Skips());
  return ladder;
}

}  // namespace rasterlab::bench
