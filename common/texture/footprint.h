// What part of a texture one pixel sees, and how far down the levels that is.
#pragma once

#include "common/image/number.h"
#include "common/texture/texture.h"

namespace rasterlab {

/// Where a pixel's centre lies in the texture, and how that changes from pixel to pixel. The
/// derivatives are exact, from the triangle's plane, not differences of neighbouring pixels.
template <class Number>
struct Footprint {
  Vector2<Number> uv;
  Vector2<Number> dx;  ///< ∂(u, v)/∂x, per pixel to the right
  Vector2<Number> dy;  ///< ∂(u, v)/∂y, per pixel down
};

/// A step in the texture, from (u, v) to texels of level 0.
template <class Number>
Vector2<Number> to_texels(const Texture& texture, const Vector2<Number>& step) {
  return {step.x() * Number(static_cast<float>(texture.width())),
          step.y() * Number(static_cast<float>(texture.height()))};
}

template <class Number>
Number squared_length(const Vector2<Number>& vector) {
  return fused_multiply_add(vector.x(), vector.x(), Number(vector.y() * vector.y()));
}

/// The level whose texels are `texels` of level 0 wide, given the square of that: fractional,
/// within the texture's levels. Up to one texel and NaN: level 0.
template <class Number>
Number level_of_squared(const Texture& texture, const Number& squared_texels) {
  if (!any(squared_texels > Number(1))) return Number(0);
  const Number level = Number(0.5F) * log_2(maximum(squared_texels, Number(1)));
  return minimum(level, Number(static_cast<float>(texture.level_count() - 1)));
}

/// The level for a footprint of any direction: that of the longer of its two steps (OpenGL 4.6
/// core, 8.14.1, with exact derivatives). A constant (u, v) gives level 0.
template <class Number>
Number mip_level(const Texture& texture, const Footprint<Number>& footprint) {
  const Number across = squared_length(to_texels(texture, footprint.dx));
  const Number down = squared_length(to_texels(texture, footprint.dy));
  return level_of_squared(texture, maximum(across, down));
}

}  // namespace rasterlab
