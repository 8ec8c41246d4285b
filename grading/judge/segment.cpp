#include "grading/judge/segment.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <sstream>

namespace rasterlab::grading {
namespace {

/// The segment with its major axis first: a pixel is (along, across).
struct Axes {
  std::int64_t length = 0;   ///< along the major axis, ≥ 0
  std::int64_t rise = 0;     ///< along the minor axis, signed
  std::int64_t forward = 1;  ///< +1 or −1 along the major axis
  bool steep = false;
  std::int64_t x0 = 0, y0 = 0;

  explicit Axes(const std::vector<double>& ends) {
    x0 = std::llround(ends.at(0)), y0 = std::llround(ends.at(1));
    const std::int64_t dx = std::llround(ends.at(2)) - x0;
    const std::int64_t dy = std::llround(ends.at(3)) - y0;
    steep = std::abs(dy) > std::abs(dx);
    length = std::max(std::abs(dx), std::abs(dy));
    rise = steep ? dx : dy;
    forward = (steep ? dy : dx) < 0 ? -1 : 1;
  }

  std::int64_t along(double x, double y) const {
    return forward * (steep ? std::llround(y) - y0 : std::llround(x) - x0);
  }
  std::int64_t across(double x, double y) const {
    return steep ? std::llround(x) - x0 : std::llround(y) - y0;
  }
  /// |across − along·rise/length| ≤ ½, in integers.
  bool near(std::int64_t along, std::int64_t across) const {
    return 2 * std::abs(across * length - along * rise) <= length;
  }
};

std::string pixel_text(double x, double y) {
  std::ostringstream text;
  text << "(" << x << ", " << y << ")";
  return text.str();
}

bool whole(double number) {
  return std::fabs(number) < 1e6 && number == std::floor(number);
}

/// The ends in the direction that the pixels go.
std::vector<double> directed(const std::vector<double>& pixels, const std::vector<double>& ends) {
  const bool backwards = ends.at(4) != 0 && pixels.size() >= 2 &&
                         !(pixels[0] == ends[0] && pixels[1] == ends[1]) &&
                         (pixels[0] == ends[2] && pixels[1] == ends[3]);
  if (!backwards) return ends;
  return {ends[2], ends[3], ends[0], ends[1], 0};
}

}  // namespace

std::string segment_fault(const std::vector<double>& pixels,
                          const std::vector<double>& given_ends) {
  const std::vector<double> ends = directed(pixels, given_ends);
  const Axes axes(ends);
  if (pixels.empty()) return "No pixel is drawn.";
  if (pixels.size() % 2 != 0 || !std::all_of(pixels.begin(), pixels.end(), whole))
    return "The pixels are not pairs of whole numbers.";
  const std::size_t count = pixels.size() / 2;
  if (pixels[0] != ends[0] || pixels[1] != ends[1]) {
    return "The first pixel is " + pixel_text(pixels[0], pixels[1]) + ", expected the first end " +
           pixel_text(ends[0], ends[1]) + ".";
  }
  for (std::size_t i = 0; i < count; ++i) {
    const double x = pixels[2 * i], y = pixels[2 * i + 1];
    const std::int64_t along = axes.along(x, y);
    const std::string pixel = pixel_text(x, y);
    if (along > axes.length) return "Pixel " + pixel + " lies beyond the second end.";
    if (along > static_cast<std::int64_t>(i)) return "There is a gap before pixel " + pixel + ".";
    if (along < static_cast<std::int64_t>(i))
      return "Pixel " + pixel + " does not step forward along the major axis.";
    if (!axes.near(along, axes.across(x, y)))
      return "Pixel " + pixel + " is more than ½ from the ideal segment.";
  }
  if (static_cast<std::int64_t>(count) != axes.length + 1)
    return "The last pixel is " + pixel_text(pixels[2 * count - 2], pixels[2 * count - 1]) +
           ", expected the second end " + pixel_text(ends[2], ends[3]) + ".";
  return "";
}

double segment_share(const std::vector<double>& pixels, const std::vector<double>& ends) {
  const Axes axes(directed(pixels, ends));
  std::map<std::int64_t, int> right;
  int wrong = 0;
  for (std::size_t i = 0; i + 1 < pixels.size(); i += 2) {
    if (!whole(pixels[i]) || !whole(pixels[i + 1])) return 0;
    const std::int64_t along = axes.along(pixels[i], pixels[i + 1]);
    const bool good = along >= 0 && along <= axes.length &&
                      axes.near(along, axes.across(pixels[i], pixels[i + 1])) && right[along] == 0;
    if (good) {
      right[along] = 1;
    } else {
      ++wrong;
    }
  }
  int hits = 0;
  for (const auto& [along, hit] : right) hits += hit;
  return std::clamp(double(hits - wrong) / double(axes.length + 1), 0.0, 1.0);
}

}  // namespace rasterlab::grading
