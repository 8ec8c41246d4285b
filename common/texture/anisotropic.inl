// Exercise 06.4, fifth rung; the contract is in anisotropic.h.
#pragma once

#include "common/image/check.h"

namespace rasterlab {

template <class Number>
Vector3<Number> sample_anisotropic(const Texture& texture, Wrap wrap,
                                   const Footprint<Number>& footprint) {
  // <solution>
  constexpr int most_samples = 16;
  constexpr float slack = 1.0F / 64;
  const auto ellipse = footprint_ellipse(texture, footprint);
  const Number ratio = ellipse.longer / maximum(ellipse.shorter, Number(1));
  const Number wanted = Number(0) - round_down(Number(slack) - ratio);
  const Number count =
      minimum(maximum(wanted, Number(1)), Number(static_cast<float>(most_samples)));
  const Number width = maximum(Number(ellipse.longer / count), ellipse.shorter);
  const Number level = level_of_squared(texture, Number(width * width));
  Vector3<Number> sum = broadcast<Number>(Eigen::Vector3f::Zero());
  for (int i = 0; i < most_samples; ++i) {
    const Number index(static_cast<float>(i));
    const auto counts = index < count;
    if (!any(counts)) break;
    const Number offset = (index + Number(0.5F)) / count - Number(0.5F);
    const Vector2<Number> uv = footprint.uv + ellipse.axis * offset;
    sum += select(counts, trilinear_at(texture, wrap, uv, level),
                  broadcast<Number>(Eigen::Vector3f::Zero()));
  }
  return sum / count;
  // <starter> throw NotWritten("06.4", texture, wrap, footprint);
  // </solution>
}

}  // namespace rasterlab
