// One student's result against the reference's: how much of it is right, and what is wrong in
// words.
#pragma once

#include "grading/judge/records.h"

#include <string>

namespace rasterlab::grading {

/// What comparing one record gave.
struct Comparison {
  bool right = false;
  double score =
      0;  ///< 0…1; for pictures the share of drawn pixels that are right, less the wrong ones
  std::string message = {};  ///< what is wrong first, in words; empty when right
};

/// Compares by the rule the expected record carries. The actual record must be of the same kind and
/// size.
Comparison compare(const Record& expected, const Record& actual);

/// How much two answers err alike, 0…1: of all places where at least one of them is not as
/// expected, the share where both say the same. 0 when `other` is right everywhere.
double likeness(const Record& expected, const Record& actual, const Record& other);

/// How many places of the record `other` has wrong (pixels, numbers, or 1 for a text).
std::size_t wrong_places(const Record& expected, const Record& other);

/// What the whole picture looks like, as "flipped in y"; empty where nothing fits or the record is
/// no picture.
std::string kind_of_wrong(const Record& expected, const Record& actual);

/// A small picture as text: `#` right, `?` missing, `!` extra, `x` drawn differently, `.` nothing.
/// Empty for what is no picture or is larger than 64 × 64 around its wrong pixels.
std::string character_grid(const Record& expected, const Record& actual);

/// The record as a picture to look at; empty for what is none.
Image<Rgb8> to_image(const Record& record);

/// Where the two differ: red missing, yellow extra, magenta different, grey the same.
Image<Rgb8> difference_image(const Record& expected, const Record& actual);

}  // namespace rasterlab::grading
