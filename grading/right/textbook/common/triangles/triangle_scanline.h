// A right answer written differently: along each side from row to row, the run it has in each
// widens the row.
#pragma once

#include "common/image/check.h"
#include "common/lines/line_all_octants.h"
#include "common/lines/line_interpolation.h"
#include "common/lines/line_steps.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <ostream>
#include <vector>

#include <Eigen/Dense>

namespace rasterlab {

/// The rows of a triangle from the top down, each with its leftmost and its rightmost pixel, both
/// included, and a value at either. Iterated down by begin()/end(), and up by rbegin()/rend().
///
/// Source: A.Q20, A.Q23.
template <class T>
class TriangleScanline {
 public:
  struct Row {
    int y;
    int left;
    int right;
    T left_value;
    T right_value;
  };

  explicit TriangleScanline(std::vector<Row> rows) : rows_(std::move(rows)) {}

  std::size_t size() const { return rows_.size(); }
  auto begin() const { return rows_.begin(); }
  auto end() const { return rows_.end(); }
  auto rbegin() const { return rows_.rbegin(); }
  auto rend() const { return rows_.rend(); }

 private:
  std::vector<Row> rows_;
};

/// Only rows first ≤ y ≤ last, as those an image has.
struct RowRange {
  int first = std::numeric_limits<int>::min();
  int last = std::numeric_limits<int>::max();
};

/// The scanline of a triangle whose corners are pixels with values. Its sides are the lines of
/// line_all_octants() from corner 0 to 1, 1 to 2 and 2 to 0; a pixel of a side has the value (1 −
/// α) a + α b of the side's ends, α being its weight in LineInterpolation. Every row that a side
/// crosses has the leftmost and the rightmost pixel of all three sides there, with their values.
///
/// Free: where several sides have the leftmost or rightmost pixel, the value of any of them; and,
/// in the sides, what bresenham_first_octant() leaves free.
///
/// Corners in any order; repeated or collinear ones give the rows of a line or of one pixel.
/// Coordinates to ±2^30. `rows` limits the result. Cost: rows, whatever their length. T has T + T
/// and float · T.
///
/// Example: (15,12) with 0, (2,17) with 1, (6,3) with 2 has 15 rows; the first, y = 3, is 6 … 6
/// with the value 2, and y = 12 is 3 … 15 with the value 0 on the right.
///
/// Source: A.Q21, A.Q22.
template <class T>
TriangleScanline<T> make_triangle_scanline(const std::array<Point, 3>& corners,
                                           const std::array<T, 3>& values,
                                           const RowRange& rows = {}) {
  using Row = typename TriangleScanline<T>::Row;
  std::map<int, Row> found;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const LineSteps side(corners[i], corners[j]);
    const StepRange wanted = side.in_rows(rows.first, rows.last);
    StepRange run{wanted.first, wanted.first};
    for (; run.first <= wanted.last; run.first = run.last + 1) {
      const int y = side.at(run.first).y();
      run.last = side.in_rows(y, y).last;
      const LineDiscrete ends = {side.at(run.first), side.at(run.last)};
      const LineInterpolation alpha(ends, corners[i], corners[j]);
      for (std::size_t k = 0; k < ends.size(); ++k) {
        const int x = ends[k].x();
        const auto a = static_cast<float>(alpha[k]);
        const T value = (1 - a) * values[i] + a * values[j];
        Row& row = found.try_emplace(y, Row{y, x, x, value, value}).first->second;
        if (x < row.left) row.left = x, row.left_value = value;
        if (x > row.right) row.right = x, row.right_value = value;
      }
    }
  }
  std::vector<Row> result;
  for (const auto& [y, row] : found) result.push_back(row);
  return TriangleScanline<T>(std::move(result));
}

/// A value as text: a number as it is, a colour as "(r g b)".
inline void write_value(std::ostream& out, float value) {
  out << value;
}
inline void write_value(std::ostream& out, const Eigen::Vector3f& value) {
  out << '(' << value.x() << ' ' << value.y() << ' ' << value.z() << ')';
}

/// Writes one row a line, from the top: "y=12: 3 [1.3502] to 15 [0]".
template <class T>
std::ostream& operator<<(std::ostream& out, const TriangleScanline<T>& scanline) {
  for (const auto& row : scanline) {
    out << "y=" << row.y << ": " << row.left << " [";
    write_value(out, row.left_value);
    out << "] to " << row.right << " [";
    write_value(out, row.right_value);
    out << "]\n";
  }
  return out;
}

}  // namespace rasterlab
