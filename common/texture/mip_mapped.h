// Exercise 06.4, third rung: the smaller copy that fits the pixel.
#pragma once

#include "common/texture/bilinear.h"
#include "common/texture/footprint.h"

namespace rasterlab {

/// Bilinear in the level nearest to the footprint's: whatever a pixel sees has been averaged
/// beforehand. Cost: four texels. Where one level gives way to the next a line shows; what is seen
/// at a grazing angle is blurred, since a level is as coarse along the footprint as across it.
///
/// Source: Williams, "Pyramidal Parametrics", SIGGRAPH 1983.
template <class Number>
Vector3<Number> sample_mip_mapped(const Texture& texture, Wrap wrap,
                                  const Footprint<Number>& footprint);

}  // namespace rasterlab

#include "common/texture/mip_mapped.inl"
