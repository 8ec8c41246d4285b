// The rungs of exercise 02.4, worst first.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/triangles/fixed_point.h"

#include <array>

namespace rasterlab {

using FillTriangle = void (*)(Image<Rgb8>& image, const Corners& corners, const Rgb8& color);

/// A way to fill triangles.
struct FillRung {
  const char* name;
  FillTriangle fill;
  const char* known_fault;
};

extern const std::array<FillRung, 6> fill_ladder;

}  // namespace rasterlab
