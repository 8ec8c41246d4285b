// How near and how far away a triangle's pixels may be.
#pragma once

#include "common/image/number.h"

#include <array>

namespace rasterlab {

/// Of some pixels of one triangle, or of one per lane: no depth is less than `far` or more than
/// `near`.
template <class Number>
struct DepthBounds {
  Number far, near;
};

/// Of a whole triangle's pixels, from its corners' depths: a pixel's is within 5 half units in the
/// last place of the largest of them.
template <class Number>
DepthBounds<Number> bounds_of(const std::array<Number, 3>& depth) {
  constexpr float margin = 1e-6F;
  const Number nearest = maximum(maximum(depth[0], depth[1]), depth[2]);
  const Number farthest = minimum(minimum(depth[0], depth[1]), depth[2]);
  return {farthest - nearest * Number(margin), nearest * Number(1 + margin)};
}

}  // namespace rasterlab
