// Whether pixels stand for a segment, in 128-bit integers: what the lines of stage 01 are held to.
// It accepts every right answer: where two pixels are equally near, either.
#pragma once

#include "common/image/image.h"

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Dense>

namespace rasterlab::oracle {

/// The ideal segment between the centres of two pixels.
class ExactSegment {
 public:
  ExactSegment(const Eigen::Vector2i& p0, const Eigen::Vector2i& p1);

  /// How many steps it goes along its major axis.
  std::int64_t steps() const { return major_; }

  /// Whether the pixel is at most half a pixel from the segment along the minor axis, and not
  /// beyond its ends along the major one.
  bool is_near(const Eigen::Vector2i& pixel) const;

  /// Its distance from the segment along the minor axis.
  long double distance(const Eigen::Vector2i& pixel) const;

  /// Whether two pixels are equally near at some step, so that right answers may differ.
  bool has_ties() const;

  /// 0 where the segment is not steep (|dx| ≥ |dy|), else 1.
  int major_axis() const { return major_axis_; }

 private:
  using Vector = Eigen::Matrix<std::int64_t, 2, 1>;

  Vector start_;
  Vector way_;
  int major_axis_ = 0;
  std::int64_t major_ = 0;
};

/// What is wrong with a sequence of pixels from p0 to p1, in words; empty when nothing is. Right
/// is: the first pixel is p0 and the last p1 (or the other way round, if `either_way`), neighbours
/// touch at a side or a corner, and there is one pixel, a near one, for every step.
std::string line_mistake(const std::vector<Eigen::Vector2i>& pixels, const Eigen::Vector2i& p0,
                         const Eigen::Vector2i& p1, bool either_way = false);

/// What is wrong with the pixels of an image that are not 0, in words; empty when nothing is. Right
/// is: every pixel is near, and each column (row, where steep) that the segment crosses inside the
/// image has one, unless its nearest pixel is outside.
std::string drawing_mistake(const Image<std::uint8_t>& drawn, const Eigen::Vector2i& p0,
                            const Eigen::Vector2i& p1);

}  // namespace rasterlab::oracle
