// Exercise 02.4, a rung: barycentric weights by one matrix.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/triangles/fixed_point.h"

namespace rasterlab {

/// The matrix **C** for which **C** · (x, y, 1) are the barycentric weights of the point (x, y):
/// the inverse of the matrix whose columns are (xᵢ, yᵢ, 1). In `float`. Without area its entries
/// are not finite, or meaningless.
///
/// Source: C.2.2.
Eigen::Matrix3f barycentric_matrix(const Corners& corners);

/// Of the pixels in the box around the corners that are inside the image, those are drawn whose
/// centre (x + ½, y + ½) has no weight below 0 by barycentric_matrix().
///
/// Known faults: centres exactly on a side belong to both triangles that share it, or by rounding
/// to neither. Without area nothing, or anything in the box, is drawn. Corners to ±2^30. Cost: the
/// box.
///
/// Source: C.2.2.
void fill_barycentric_matrix(Image<Rgb8>& image, const Corners& corners, const Rgb8& color);

}  // namespace rasterlab
