// How far a picture's colours are from what they should be.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"

#include "bench/support/ladder.h"
#include "bench/support/oracle_number.h"

namespace rasterlab::bench {

/// A pixel's true colour, unrounded, as both oracles have it.
struct TrueColor {
  Vector3<OracleNumber<double>> by_double;
  Vector3<OracleNumber<Quad>> by_quad;

  static TrueColor black() {
    return {broadcast<OracleNumber<double>>(Color::Zero()),
            broadcast<OracleNumber<Quad>>(Color::Zero())};
  }
};

/// The five errors of pictures, each name beginning with `kind` ("model" or "implementation"):
/// the root of the mean square and the largest of a channel, in codes of 255; the share of pixels
/// of which a channel is off by more than one code; PSNR, infinite for pictures that are equal;
/// and SSIM of the luma, 1 for those (Wang, Bovik, Sheikh, Simoncelli, "Image quality assessment",
/// 2004: Gaussian windows of 11 × 11). Not a number where the oracles do not agree.
Errors picture_errors(const std::string& kind, const Image<TrueColor>& shown,
                      const Image<TrueColor>& truth);

/// The same of colours in [0, 1] that were computed in floats, or that stored codes stand for.
Errors picture_errors(const std::string& kind, const Image<Color>& shown,
                      const Image<TrueColor>& truth);

/// The same of a stored picture, where a stored picture is the truth.
Errors picture_errors(const std::string& kind, const Image<Rgb8>& shown, const Image<Rgb8>& truth);

Image<Color> to_colors(const Image<Rgb8>& picture);

}  // namespace rasterlab::bench
