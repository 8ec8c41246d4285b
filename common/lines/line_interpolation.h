// Exercise 01.9: how far along the segment each pixel is.
#pragma once

#include "common/lines/line_discrete.h"

#include <cstddef>
#include <iosfwd>
#include <vector>

namespace rasterlab {

/// A weight α for every pixel of a line: 0 at its start p0, 1 at its end p1, and in between
///
///   α_k = ‖p_k − p_0‖ / ‖p_1 − p_0‖.
///
/// Distances are Euclidean, in double precision; a right answer is within 1e-12. p0 = p1 gives 0.
/// Coordinates to ±2^30.
///
/// Source: A.Q17.
class LineInterpolation {
 public:
  /// Of a whole line: p0 is its first pixel, p1 its last. An empty line has no weights.
  explicit LineInterpolation(const LineDiscrete& line);

  /// Of some pixels of the line from p0 to p1.
  LineInterpolation(const LineDiscrete& pixels, const Point& p0, const Point& p1);

  std::size_t size() const { return weights_.size(); }

  /// The weight of the pixel at `index`. Throws CheckError where there is none.
  double operator[](std::size_t index) const;

 private:
  std::vector<double> weights_;
};

/// Writes the weights in order with a space between, as "0 0.25 0.5 1": at most six digits each.
std::ostream& operator<<(std::ostream& out, const LineInterpolation& interpolation);

}  // namespace rasterlab
