// Exercise 01.4: a segment as the pixels that stand for it.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <iosfwd>
#include <vector>

#include <Eigen/Dense>

namespace rasterlab {

/// A pixel by its column and row; x right, y down. Need not lie inside any image.
using Point = Eigen::Vector2i;

/// Coordinates that segments may have, inclusive. Differences of two then need 33 bits: compute
/// them in 64.
inline constexpr int max_point_coordinate = 1 << 30;

/// An ordered sequence of pixels. Anything may be appended: neighbours, repetitions, jumps.
///
/// Iterated from the first pixel to the last by begin()/end(), and back by rbegin()/rend().
///
/// Source: A.Q9.
class LineDiscrete {
 public:
  LineDiscrete() = default;
  LineDiscrete(std::initializer_list<Point> pixels) : pixels_(pixels) {}

  /// Puts a pixel after the last.
  void append(const Point& pixel);

  std::size_t size() const { return pixels_.size(); }
  bool empty() const { return pixels_.empty(); }

  /// The pixel at `index`, 0 being the first. Throws CheckError where there is none.
  const Point& operator[](std::size_t index) const;

  auto begin() const { return pixels_.begin(); }
  auto end() const { return pixels_.end(); }
  auto rbegin() const { return pixels_.rbegin(); }
  auto rend() const { return pixels_.rend(); }

  friend bool operator==(const LineDiscrete&, const LineDiscrete&) = default;

 private:
  std::vector<Point> pixels_;
};

/// Writes the pixels in order, without spaces or a line's end: "(5,5)(6,6)(7,6)"; nothing for an
/// empty line.
std::ostream& operator<<(std::ostream& out, const LineDiscrete& line);

}  // namespace rasterlab
