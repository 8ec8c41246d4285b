// The mistake behind a wrong picture, named.
#pragma once

#include "common/image/any_image.h"

#include <string>

namespace rasterlab {

/// Which well-known mistake turns `expected` into `actual`: "empty", "flipped in y", "flipped in
/// x", "flipped in x and y", "transposed", "red and blue swapped", "shifted by a pixel to the right
/// and down" (or by half a pixel) and the like, "too bright by a factor of 2", "gamma applied
/// (values to the power of 0.45)", "depth reversed". Each is made with `expected`; named is the one
/// that explains most of the difference, if that is at least three quarters; else nothing.
std::string kind_of_wrong(const AnyImage& actual, const AnyImage& expected);

}  // namespace rasterlab
