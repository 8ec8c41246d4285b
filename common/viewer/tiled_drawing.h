// The engine as the viewer of a stage uses it: for --engine tiled.
#pragma once

#include "common/engine/renderer.h"
#include "common/viewer/viewer.h"

#include <optional>

#include <nlohmann/json.hpp>

namespace rasterlab {

/// The values of --simd: what this build is for and this machine can run, the best last.
Choices simd_choices();

/// The values of --without: what the engine skips, and what the stage does.
Choices skip_choices(const ViewerOptions& options);

/// Draws one mesh many times, and keeps from frame to frame what stays the same.
class TiledDrawing {
 public:
  /// `mesh` is the subject's, or one made of it, and outlives this.
  TiledDrawing(const Subject& subject, const Mesh& mesh);

  /// Draws a frame, over whatever was in it, by the shader that shading() (common/engine/shading.h)
  /// was given. Returns what was done and what was skipped.
  nlohmann::json draw(const View& view, const Shading& shading, Frame& frame);

 private:
  Framebuffer& cleared(int width, int height);

  Cull cull_;
  PreparedMesh mesh_;
  Renderer renderer_;
  std::optional<Framebuffer> framebuffer_;  ///< kept while frames have one size
};

}  // namespace rasterlab
