#include "common/lines/line_steps.h"

#include "common/image/check.h"

#include <algorithm>
#include <cstdlib>

namespace rasterlab {

StepRange intersection(const StepRange& a, const StepRange& b) {
  return {std::max(a.first, b.first), std::min(a.last, b.last)};
}

LineSteps::LineSteps(const Point& p0, const Point& p1) : start_(p0) {
  if (std::max(p0.maxCoeff(), p1.maxCoeff()) > max_point_coordinate ||
      std::min(p0.minCoeff(), p1.minCoeff()) < -max_point_coordinate) {
    throw CheckError("an end of a segment is beyond ±2^30");
  }
  const Eigen::Matrix<std::int64_t, 2, 1> way = p1.cast<std::int64_t>() - p0.cast<std::int64_t>();
  major_axis_ = std::abs(way.y()) > std::abs(way.x()) ? 1 : 0;
  const int minor_axis = 1 - major_axis_;
  major_length_ = std::abs(way[major_axis_]);
  minor_length_ = std::abs(way[minor_axis]);
  major_direction_ = way[major_axis_] < 0 ? -1 : 1;
  minor_direction_ = way[minor_axis] < 0 ? -1 : 1;
}

// The minor coordinate of step k is off p0's by the whole part of k · minor / major + ½. Twice the
// products of two lengths of 2^31 take all 64 bits: hence unsigned.
Point LineSteps::at(std::int64_t k) const {
  std::int64_t offset = 0;
  if (major_length_ > 0) {
    const auto major = static_cast<std::uint64_t>(major_length_);
    const auto minor = static_cast<std::uint64_t>(minor_length_);
    offset = static_cast<std::int64_t>((2 * static_cast<std::uint64_t>(k) * minor + major) /
                                       (2 * major));
  }
  Point pixel;
  pixel[major_axis_] = static_cast<int>(start_[major_axis_] + k * major_direction_);
  pixel[1 - major_axis_] = static_cast<int>(start_[1 - major_axis_] + offset * minor_direction_);
  return pixel;
}

/// The first step whose minor coordinate is `offset` or more away from p0's; last() + 1 when none
/// is.
std::int64_t LineSteps::first_step_with_offset(std::int64_t offset) const {
  if (offset <= 0) return 0;
  if (offset > minor_length_) return major_length_ + 1;
  // k · minor / major + ½ ≥ offset, solved for k and rounded up.
  const auto above =
      static_cast<std::uint64_t>(2 * offset - 1) * static_cast<std::uint64_t>(major_length_);
  const auto below = 2 * static_cast<std::uint64_t>(minor_length_);
  return static_cast<std::int64_t>(above / below + (above % below != 0 ? 1 : 0));
}

StepRange LineSteps::along(int axis, std::int64_t low, std::int64_t high) const {
  const bool major = axis == major_axis_;
  const int direction = major ? major_direction_ : minor_direction_;
  // Bounds as offsets from p0 in the direction the segment goes.
  std::int64_t near = (low - start_[axis]) * direction;
  std::int64_t far = (high - start_[axis]) * direction;
  if (direction < 0) std::swap(near, far);
  if (far < near || far < 0) return {0, -1};
  if (major) return {std::max<std::int64_t>(near, 0), std::min(far, major_length_)};
  return {first_step_with_offset(near), first_step_with_offset(far + 1) - 1};
}

}  // namespace rasterlab
