// The engine: draws prepared meshes into framebuffers, fast and exactly.
//
//   PreparedMesh prepared(mesh);
//   Framebuffer frame(1920, 1080);
//   Renderer renderer;
//   frame.clear();
//   renderer.draw({.mesh = &prepared, .matrix = projection * view, .shading = shading(shader)},
//                 frame);
//   write_image("picture.png", frame.color());
//
// How it works, and why it is exact, is in docs/engine.md.
#pragma once

#include "common/engine/engine_options.h"
#include "common/engine/framebuffer.h"
#include "common/engine/prepared_mesh.h"
#include "common/engine/shading.h"
#include "common/engine/statistics.h"
#include "common/mesh/cull.h"

#include <memory>

#include <Eigen/Dense>

namespace rasterlab {

/// One mesh to be drawn, from one point of view.
struct DrawCall {
  const PreparedMesh* mesh = nullptr;
  Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();  ///< object space to clip space
  Cull cull = Cull::none;
  bool mirrored = false;  ///< the matrix turns left into right: fronts go clockwise
  Shading shading = {};   ///< as shading(shader) gives it; by default only depth and ids are drawn
  Keep keep = Keep::everything;  ///< if less, the framebuffer must be cleared before the next one
};

class Renderer {
 public:
  explicit Renderer(const EngineOptions& options = {});
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Draws into `frame`, in front of and behind what is there. Nearer wins; at equal depth the
  /// triangle drawn earlier, or earlier in the mesh. One thread at a time may draw with a renderer.
  /// Returns what was done and what was skipped.
  ///
  /// Throws CheckError when there is no mesh, when the draw call before did not keep everything, or
  /// for more than 2^31 triangles since clear(); InputError when this machine can't run the SIMD
  /// target. What a shader throws, this throws; the framebuffer must be cleared then.
  Statistics draw(const DrawCall& call, Framebuffer& frame);

 private:
  class Threads;

  EngineOptions options_;
  std::unique_ptr<Threads> threads_;
};

}  // namespace rasterlab
