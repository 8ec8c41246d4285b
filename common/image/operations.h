// What one does to a whole picture: turn it over, change its size, change its kind of pixel.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"

#include <cstdint>
#include <utility>

namespace rasterlab {

/// The first column becomes the last.
template <class Pixel>
Image<Pixel> flipped_horizontally(const Image<Pixel>& image);

/// The top row becomes the bottom one.
template <class Pixel>
Image<Pixel> flipped_vertically(const Image<Pixel>& image);

/// Every pixel becomes a block of factor × factor. Throws CheckError for factor < 1.
template <class Pixel>
Image<Pixel> enlarged(const Image<Pixel>& image, int factor);

/// The picture at another size, larger or smaller: each pixel is the one its centre falls into,
/// none is mixed. Throws CheckError when a side is negative, or an empty picture is to become one
/// that is not.
template <class Pixel>
Image<Pixel> resized(const Image<Pixel>& image, int width, int height);

/// The same picture in another kind of pixel, each of files.h's AnyImage.
/// - Between 8 bit, 16 bit and float, 1 of the one is 255 of the other and 65535 of the third; to
/// integers, values are
///   rounded to nearest, those outside [0, 1] clamped and NaN becomes 0. float to float keeps every
///   value.
/// - Colour to grey is 0.299 r + 0.587 g + 0.114 b (ITU-R BT.601, of the stored values), and
/// exactly r where all are
///   equal.
/// - Grey to colour repeats the value; alpha that is not there is opaque; alpha is dropped without
/// blending.
template <class To, class From>
Image<To> convert(const Image<From>& image);

/// Shows numbers as grey: `black` and what is beyond it becomes 0, `white` and what is beyond it
/// 255, linear between; either may be the larger. NaN becomes 0. For a depth picture with near
/// things bright: grey_picture(depth, far, near).
Image<std::uint8_t> grey_picture(const Image<float>& values, float black, float white);

/// The least and the greatest of the values that are finite; {0, 0} where none is.
std::pair<float, float> finite_range(const Image<float>& values);

}  // namespace rasterlab
