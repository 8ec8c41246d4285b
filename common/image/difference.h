// Whether two pictures are the same, where they are not, and what that looks like.
#pragma once

#include "common/image/any_image.h"

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace rasterlab {

/// How far a picture may be from the expected one: both limits hold, so that {2, 100} allows 100
/// pixels to differ, each by 2 at most. (The same two numbers as the `fuzzy` of
/// web-platform-tests.)
struct Tolerance {
  static constexpr double any_difference = std::numeric_limits<double>::infinity();
  static constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

  double max_difference = 0;  ///< the largest difference of a channel: of 255, 65535, or as floats
  std::size_t total_pixels = 0;  ///< how many pixels may differ
  /// A pixel counts as the same when its like is in the other picture at most so many pixels away
  /// in x and in y, and the other way round.
  int neighbor_radius = 0;
};

struct DifferingPixel {
  int x = 0;
  int y = 0;
  std::string actual;  ///< "(255, 0, 0)"
  std::string expected;
};

/// What a comparison found.
struct Difference {
  bool matches = true;
  std::string
      other_size;  ///< "40x30, expected 30x40" where the sizes differ; nothing else is told then
  std::size_t differing_pixels = 0;
  std::size_t all_pixels = 0;
  double largest = 0;  ///< of all channels of all pixels; infinite for NaN against a number
  std::vector<DifferingPixel> first;  ///< row by row from the top, at most 8
  std::string kind_of_wrong;          ///< "flipped in y"; empty where nothing fits: kind_of_wrong.h
};

/// Compares channel by channel. Pictures of different kinds are brought to one that holds both, as
/// convert.h says: grey to colour, 8 bit to 16, integers to floats. Equal infinities are equal, and
/// so is NaN to NaN. Costs time proportional to the pixels, a few times more when they differ.
Difference compare_images(const AnyImage& actual, const AnyImage& expected,
                          const Tolerance& tolerance = {});

/// A few lines for a person: how many pixels, how much, the first of them, the kind of wrong.
std::string describe(const Difference& difference);

/// Black where the pictures agree; where not, the channels' differences, amplified so that the
/// largest is 255 and the least can be seen (64). What only one of them covers is magenta.
Image<Rgb8> difference_picture(const AnyImage& actual, const AnyImage& expected);

}  // namespace rasterlab
