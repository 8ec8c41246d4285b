// From one kind of pixel to another.
#pragma once

#include "common/image/any_image.h"

namespace rasterlab {

/// The same picture in another kind of pixel; both are among AnyImage's.
/// - Between 8 bit, 16 bit and float, 255 of the one is 65535 of the other and 1 of the third; to
///   integers, values are rounded to nearest, those outside [0, 1] clamped, and NaN becomes 0. From
///   float to float every value is kept.
/// - Colour to grey is 0.299 r + 0.587 g + 0.114 b of the stored values (ITU-R BT.601), and exactly
/// r
///   where all three are equal.
/// - Grey to colour repeats the value; alpha that is not there is opaque; alpha is dropped without
///   blending.
template <class To, class From>
Image<To> convert(const Image<From>& image);

/// The same, of a kind known only at run time. Float has no alpha: {4, floating} gives {3,
/// floating}.
AnyImage convert(const AnyImage& image, PixelKind kind);

}  // namespace rasterlab
