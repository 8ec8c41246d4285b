// What a scene covers, by arithmetic that is exact where it counts: the judge when both sides
// disagree.
#pragma once

#include "common/image/image.h"

#include "bench/engine/scenes.h"

#include <cstdint>

namespace rasterlab::bench {

/// 255 where a triangle covers a pixel's centre, else 0. Vertices are projected in long double, a
/// thousand times finer than what could change how they round to 1/256 pixel; from there on all is
/// integers. Throws when a triangle reaches behind the eye: it doesn't clip.
Image<std::uint8_t> exact_coverage(const Scene& scene, int width, int height);

}  // namespace rasterlab::bench
