// The other side: Mesa's llvmpipe, in this process, through OSMesa.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"

#include "bench/engine/scenes.h"

#include <memory>

namespace rasterlab::bench {

class Peer {
 public:
  /// Set LP_NUM_THREADS before. Workers are pinned to cores 0 … threads − 1.
  Peer(int width, int height, int threads);
  ~Peer();
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  void load_textures(const Image<Rgb8>& texture, const Image<Rgb8>& normal_map);
  /// Puts the mesh into buffers; forgets the one before.
  void load(const Scene& scene);
  /// Clears, draws, and waits until the picture is in memory.
  void draw(const Scene& scene, ShadingKind shading);

  Image<Rgb8> color() const;
  /// Where anything was drawn.
  Image<std::uint8_t> coverage() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace rasterlab::bench
