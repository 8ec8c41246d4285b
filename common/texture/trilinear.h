// Exercise 06.4, fourth rung: no line between the levels.
#pragma once

#include "common/texture/bilinear.h"
#include "common/texture/footprint.h"

namespace rasterlab {

/// Blends bilinear samples of the two levels about a fractional level: `level` from 0 to the
/// texture's last.
template <class Number>
Vector3<Number> trilinear_at(const Texture& texture, Wrap wrap, const Vector2<Number>& uv,
                             const Number& level) {
  const Number finer = round_down(level);
  const Number part = level - finer;
  const Vector3<Number> fine = bilinear_in_level(texture, wrap, uv, finer);
  if (!any(part > Number(0))) return fine;
  const Number coarser =
      minimum(finer + Number(1), Number(static_cast<float>(texture.level_count() - 1)));
  return blend(fine, bilinear_in_level(texture, wrap, uv, coarser), part);
}

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
