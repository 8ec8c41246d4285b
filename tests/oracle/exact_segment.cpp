#include "tests/oracle/exact_segment.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <sstream>

namespace rasterlab::oracle {
namespace {

__extension__ using Int128 = __int128;

template <class... Parts>
std::string joined(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

std::string text(const Eigen::Vector2i& pixel) {
  return joined("(", pixel.x(), ",", pixel.y(), ")");
}

}  // namespace

ExactSegment::ExactSegment(const Eigen::Vector2i& p0, const Eigen::Vector2i& p1)
    : start_(p0.cast<std::int64_t>()), way_(p1.cast<std::int64_t>() - p0.cast<std::int64_t>()) {
  major_axis_ = std::abs(way_.x()) >= std::abs(way_.y()) ? 0 : 1;
  major_ = std::abs(way_[major_axis_]);
}

bool ExactSegment::is_near(const Eigen::Vector2i& pixel) const {
  const Vector off = pixel.cast<std::int64_t>() - start_;
  if (major_ == 0) return off.isZero();
  const std::int64_t along = way_[major_axis_] < 0 ? -off[major_axis_] : off[major_axis_];
  const Int128 cross = Int128{way_.x()} * off.y() - Int128{way_.y()} * off.x();
  return along >= 0 && along <= major_ && 2 * (cross < 0 ? -cross : cross) <= major_;
}

long double ExactSegment::distance(const Eigen::Vector2i& pixel) const {
  const Vector off = pixel.cast<std::int64_t>() - start_;
  if (major_ == 0) return static_cast<long double>(off.cwiseAbs().maxCoeff());
  const Int128 cross = Int128{way_.x()} * off.y() - Int128{way_.y()} * off.x();
  return static_cast<long double>(cross < 0 ? -cross : cross) / static_cast<long double>(major_);
}

bool ExactSegment::has_ties() const {
  // Step k is half a row off where 2 k · minor is an odd multiple of the steps.
  const std::int64_t minor = std::abs(way_[1 - major_axis_]);
  return major_ != 0 && major_ / std::gcd(major_, minor) % 2 == 0;
}

std::string line_mistake(const std::vector<Eigen::Vector2i>& pixels, const Eigen::Vector2i& p0,
                         const Eigen::Vector2i& p1, bool either_way) {
  const ExactSegment segment(p0, p1);
  const std::string which = joined("the line from ", text(p0), " to ", text(p1), ": ");
  if (pixels.empty()) return joined(which, "it has no pixels");
  const bool turned = either_way && pixels.front() == p1;
  const Eigen::Vector2i& first = turned ? p1 : p0;
  const Eigen::Vector2i& last = turned ? p0 : p1;
  if (pixels.front() != first)
    return joined(which, "it begins at ", text(pixels.front()), ", not at ", text(first));
  if (pixels.back() != last)
    return joined(which, "it ends at ", text(pixels.back()), ", not at ", text(last));
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (!segment.is_near(pixels[i])) {
      return joined(which, "pixel ", text(pixels[i]),
                    " is more than half a pixel from the ideal segment");
    }
    if (i == 0) continue;
    const Eigen::Vector2i step = (pixels[i] - pixels[i - 1]).cwiseAbs();
    if (step.isZero()) return joined(which, "pixel ", text(pixels[i]), " comes twice");
    if (step.maxCoeff() > 1)
      return joined(which, "a gap between ", text(pixels[i - 1]), " and ", text(pixels[i]));
  }
  const auto expected = static_cast<std::size_t>(segment.steps()) + 1;
  if (pixels.size() != expected) {
    return joined(which, "it has ", pixels.size(), " pixels, not one for each of ", expected,
                  (segment.major_axis() == 0 ? " columns" : " rows"));
  }
  return "";
}

std::string drawing_mistake(const Image<std::uint8_t>& drawn, const Eigen::Vector2i& p0,
                            const Eigen::Vector2i& p1) {
  const ExactSegment segment(p0, p1);
  const std::string which = joined("the line from ", text(p0), " to ", text(p1), ": ");
  const int axis = segment.major_axis();
  const int majors = axis == 0 ? drawn.width() : drawn.height();
  const int minors = axis == 0 ? drawn.height() : drawn.width();
  for (int major = 0; major < majors; ++major) {
    const auto pixel_at = [&](int minor) {
      return axis == 0 ? Eigen::Vector2i(major, minor) : Eigen::Vector2i(minor, major);
    };
    int found = 0;
    int near = 0;
    for (int minor = 0; minor < minors; ++minor) {
      const Eigen::Vector2i pixel = pixel_at(minor);
      const bool is_near = segment.is_near(pixel);
      near += is_near ? 1 : 0;
      if (drawn(pixel.x(), pixel.y()) == 0) continue;
      ++found;
      if (!is_near) return joined(which, "pixel ", text(pixel), " does not belong to it");
    }
    const bool tie_with_outside =
        near == 1 && (segment.is_near(pixel_at(-1)) || segment.is_near(pixel_at(minors)));
    if (found > 1) return joined(which, "two pixels in ", (axis == 0 ? "column " : "row "), major);
    if (near > 0 && found == 0 && !tie_with_outside) {
      return joined(which, "no pixel in ", (axis == 0 ? "column " : "row "), major);
    }
  }
  return "";
}

}  // namespace rasterlab::oracle
