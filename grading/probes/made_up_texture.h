// Textures and ways to wrap them, as the probes of stage 06 use them.
#pragma once

#include "common/texture/wrap.h"

#include "grading/probes/probe.h"

#include <string>

namespace rasterlab::grading {

inline constexpr Wrap wraps[] = {Wrap::repeat, Wrap::clamp, Wrap::mirror};
inline const std::string wrap_names[] = {"repeated", "clamped", "mirrored"};

/// Texels of any colour, so that a wrong one shows; no side is a power of two.
inline Image<Rgb8> texels(SceneInputs& scene) {
  Image<Rgb8> image{scene.whole(9, 14), scene.whole(5, 8)};
  for (Rgb8& texel : image.pixels()) texel = to_rgb8(scene.color());
  return image;
}

}  // namespace rasterlab::grading
