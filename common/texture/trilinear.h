// Exercise 06.4, fourth rung: no line between the levels.
#pragma once

#include "common/texture/bilinear.h"
#include "common/texture/footprint.h"

namespace rasterlab {

/// Blends bilinear samples of the two levels about a fractional level: `level` from 0 to the
/// texture's last.
template <class Number>
Vector3<Number> trilinear_at(const Texture& texture, Wrap wrap, const Vector2<Number>& uv,
                             const Number& level);

/// Linear in the level too. Cost: eight texels, four where the texture is magnified. What is seen
/// at a grazing angle is still blurred.
///
/// Source: Williams, "Pyramidal Parametrics", SIGGRAPH 1983.
template <class Number>
Vector3<Number> sample_trilinear(const Texture& texture, Wrap wrap,
                                 const Footprint<Number>& footprint) {
  return trilinear_at(texture, wrap, footprint.uv, mip_level(texture, footprint));
}

}  // namespace rasterlab

#include "common/texture/trilinear.inl"
