// Exercise 02.4, a rung: ask every pixel of the box around the triangle.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/triangles/fixed_point.h"

namespace rasterlab {

/// Every corner is the pixel it falls into. Of the pixels in the box around the corners that are
/// inside the image, those are drawn whose own column and row, as a point, have no weight below 0
/// in barycentric().
///
/// Known faults: points exactly on a side belong to both triangles that share it; corners on whole
/// pixels move the triangle by up to a pixel. Without area nothing is drawn. Corners to ±2^30;
/// throws CheckError beyond. Cost: the box.
///
/// Source: B.box.
void fill_bounding_box(Image<Rgb8>& image, const Corners& corners, const Rgb8& color);

}  // namespace rasterlab
