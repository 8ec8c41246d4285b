// Names the mistake behind a wrong picture by making the same mistake with the right one.
#include "common/image/kind_of_wrong.h"

#include "common/image/convert.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace rasterlab {
namespace {

/// A mistake that was tried, and how far the right picture with that mistake still is from the
/// wrong one, as a part of how far it is without.
struct Suspect {
  std::string name;
  double left = 1;
};

constexpr double left_at_most = 0.25;
constexpr int border = 2;  ///< not looked at for shifts: what has come in from outside is unknown

/// Both pictures in floats, 1 or 3 channels. What is infinite or NaN becomes one value beyond all
/// others.
struct Pair {
  cv::Mat actual;
  cv::Mat expected;
  float beyond = 0;     ///< stands for what is infinite or NaN
  bool clamped = true;  ///< stored as integers: nothing is above 1
};

cv::Mat in_floats(const AnyImage& image, int channels) {
  const AnyImage floats = convert(image, {channels, Depth::floating});
  return std::visit(
      [channels](const auto& pixels) -> cv::Mat {
        return cv::Mat(pixels.height(), pixels.width(), CV_32FC(channels),
                       const_cast<void*>(static_cast<const void*>(pixels.row(0))))  // NOLINT: read
            .clone();
      },
      floats);
}

/// Calls visit(value) for every channel of every pixel.
template <class Visit>
void for_each_value(const cv::Mat& picture, Visit visit) {
  for (int y = 0; y < picture.rows; ++y) {
    const float* row = picture.ptr<float>(y);
    for (int i = 0; i < picture.cols * picture.channels(); ++i) visit(row[i]);
  }
}

/// Calls visit(a, b) for the values of two pictures of one size.
template <class Visit>
void for_each_pair(const cv::Mat& a, const cv::Mat& b, Visit visit) {
  for (int y = 0; y < a.rows; ++y) {
    const float* row_a = a.ptr<float>(y);
    const float* row_b = b.ptr<float>(y);
    for (int i = 0; i < a.cols * a.channels(); ++i) visit(row_a[i], row_b[i]);
  }
}

/// Infinite, NaN, or too large to be squared.
bool is_out_of_reach(float value) {
  return !(std::abs(value) < 1e15F);
}

void replace_out_of_reach(cv::Mat& picture, float value) {
  for (int y = 0; y < picture.rows; ++y) {
    float* row = picture.ptr<float>(y);
    std::replace_if(row, row + picture.cols * picture.channels(), is_out_of_reach, value);
  }
}

Pair comparable_pair(const AnyImage& actual, const AnyImage& expected) {
  const int channels = kind_of(actual).channels == 1 && kind_of(expected).channels == 1 ? 1 : 3;
  Pair pair{.actual = in_floats(actual, channels), .expected = in_floats(expected, channels)};
  pair.clamped = kind_of(actual).depth != Depth::floating;
  float least = 0;
  float greatest = 0;
  for (const cv::Mat& picture : {pair.actual, pair.expected}) {
    for_each_value(picture, [&](float value) {
      if (is_out_of_reach(value)) return;
      least = std::min(least, value);
      greatest = std::max(greatest, value);
    });
  }
  pair.beyond = greatest + (greatest - least) / 4 + 1e-3F;
  replace_out_of_reach(pair.actual, pair.beyond);
  replace_out_of_reach(pair.expected, pair.beyond);
  return pair;
}

double distance(const cv::Mat& a, const cv::Mat& b) {
  return cv::norm(a, b, cv::NORM_L1);
}

bool is_one_color(const cv::Mat& picture) {
  cv::Mat channels[3];
  cv::split(picture, channels);
  return std::all_of(channels, channels + picture.channels(), [](const cv::Mat& channel) {
    double least = 0;
    double greatest = 0;
    cv::minMaxLoc(channel, &least, &greatest);
    return least == greatest;
  });
}

/// Tries mistakes and keeps the one that leaves least.
class Search {
 public:
  explicit Search(const Pair& pair)
      : pair_(pair),
        before_(std::min(distance(pair.actual, pair.expected), contrast(pair.actual))) {}

  /// A mistake that should give the actual picture. It has to come nearer to it than the right
  /// picture is, and than one colour would.
  void try_mistake(const std::string& name, const cv::Mat& mistaken) {
    if (mistaken.size() == pair_.actual.size() && before_ > 0) {
      suspect(name, distance(pair_.actual, mistaken) / before_);
    }
  }

  void suspect(const std::string& name, double left) {
    if (left < best_.left) best_ = {name, left};
  }

  std::string verdict() const { return best_.left <= left_at_most ? best_.name : std::string(); }

 private:
  static double contrast(const cv::Mat& picture) {
    const cv::Mat mean(picture.size(), picture.type(), cv::mean(picture));
    return distance(picture, mean);
  }

  const Pair& pair_;
  double before_;
  Suspect best_;
};

// --- Turned over ---

cv::Mat flipped(const cv::Mat& picture, int code) {
  cv::Mat result;
  cv::flip(picture, result, code);
  return result;
}

cv::Mat transposed(const cv::Mat& picture) {
  cv::Mat result;
  cv::transpose(picture, result);
  return result;
}

void try_turned_over(const Pair& pair, Search& search) {
  search.try_mistake("flipped in y", flipped(pair.expected, 0));
  search.try_mistake("flipped in x", flipped(pair.expected, 1));
  search.try_mistake("flipped in x and y", flipped(pair.expected, -1));
  search.try_mistake("transposed", transposed(pair.expected));
}

void try_channels(const Pair& pair, Search& search) {
  if (pair.expected.channels() != 3) return;
  cv::Mat swapped;
  cv::cvtColor(pair.expected, swapped, cv::COLOR_RGB2BGR);
  search.try_mistake("red and blue swapped", swapped);
}

// --- Shifted ---

std::string length_name(int half_pixels) {
  return half_pixels == 1 ? "half a pixel" : "a pixel";
}

/// By one or two halves of a pixel in x, y or both.
std::string shift_name(int half_pixels_x, int half_pixels_y) {
  std::string name = "shifted by ";
  if (half_pixels_x != 0) {
    name += length_name(std::abs(half_pixels_x));
    name += half_pixels_x > 0 ? " to the right" : " to the left";
  }
  if (half_pixels_x != 0 && half_pixels_y != 0) name += " and ";
  if (half_pixels_y != 0) {
    name += length_name(std::abs(half_pixels_y));
    name += half_pixels_y > 0 ? " down" : " up";
  }
  return name;
}

/// The part of a picture at least `border` inside, seen through a window moved by (x, y).
cv::Mat inside(const cv::Mat& picture, int x = 0, int y = 0) {
  return picture({border + x, border + y, picture.cols - 2 * border, picture.rows - 2 * border});
}

bool has_inside(const Pair& pair) {
  return std::min(pair.actual.cols, pair.actual.rows) > 2 * border;
}

void try_whole_pixels(const Pair& pair, Search& search) {
  if (!has_inside(pair)) return;
  const double before = distance(inside(pair.actual), inside(pair.expected));
  if (before == 0) return;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      if (x == 0 && y == 0) continue;
      const double left = distance(inside(pair.actual), inside(pair.expected, -x, -y));
      search.suspect(shift_name(2 * x, 2 * y), left / before);
    }
  }
}

struct Shift {
  double x = 0;
  double y = 0;
  double left = 1;  ///< of the squared difference between the smoothed pictures
};

cv::Mat shifted(const cv::Mat& picture, const Shift& shift) {
  const cv::Mat motion = (cv::Mat_<double>(2, 3) << 1, 0, shift.x, 0, 1, shift.y);
  cv::Mat result;
  cv::warpAffine(picture, result, motion, picture.size(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return result;
}

/// A part of a picture as one row of numbers.
cv::Mat as_row(const cv::Mat& picture) {
  return inside(picture).clone().reshape(1, 1);
}

/// One step of Lucas and Kanade's least squares (An Iterative Image Registration Technique, 1981,
/// eq. 5 in two dimensions).
void improve(Shift& shift, const cv::Mat& actual, const cv::Mat& expected) {
  const cv::Mat moved = shifted(expected, shift);
  cv::Mat slope_x;
  cv::Mat slope_y;
  cv::Sobel(moved, slope_x, CV_32F, 1, 0, 1, 0.5);
  cv::Sobel(moved, slope_y, CV_32F, 0, 1, 1, 0.5);
  const cv::Mat dx = as_row(slope_x);
  const cv::Mat dy = as_row(slope_y);
  const cv::Mat error = as_row(moved - actual);
  const double xx = dx.dot(dx);
  const double xy = dx.dot(dy);
  const double yy = dy.dot(dy);
  const double determinant = xx * yy - xy * xy;
  if (determinant <= 1e-9 * xx * yy) return;
  shift.x += (dx.dot(error) * yy - dy.dot(error) * xy) / determinant;
  shift.y += (dy.dot(error) * xx - dx.dot(error) * xy) / determinant;
}

/// By how much the one picture is the other shifted. Half a pixel changes which centres an edge
/// covers here and there; only the mean over all edges tells it, so both pictures are smoothed.
Shift estimated_shift(const Pair& pair) {
  cv::Mat actual;
  cv::Mat expected;
  cv::GaussianBlur(pair.actual, actual, {0, 0}, 1.5);
  cv::GaussianBlur(pair.expected, expected, {0, 0}, 1.5);
  Shift shift;
  for (int i = 0; i < 5; ++i) improve(shift, actual, expected);
  const auto squared_difference = [&](const cv::Mat& picture) {
    return cv::norm(inside(actual), inside(picture), cv::NORM_L2SQR);
  };
  const double before = squared_difference(expected);
  if (before > 0) shift.left = squared_difference(shifted(expected, shift)) / before;
  return shift;
}

/// The name of a shift by half a pixel, or by one in x and half of one in y; empty when the
/// pictures differ otherwise. Where a part too many was drawn, least squares would walk on toward
/// it: what is further than smoothing reaches is no shift.
std::string half_pixel_shift(const Pair& pair) {
  // Measured with random triangles: a shift leaves 0.05 to 0.5, a missing triangle 0.7 to 1.
  constexpr double most_left = 0.5;
  constexpr double exactness = 0.125;
  if (!has_inside(pair)) return {};
  const Shift shift = estimated_shift(pair);
  const int x = cvRound(2 * shift.x);
  const int y = cvRound(2 * shift.y);
  const double off = std::max(std::abs(shift.x - x / 2.0), std::abs(shift.y - y / 2.0));
  const int furthest = std::max(std::abs(x), std::abs(y));
  const bool shifted = shift.left <= most_left && off <= exactness;
  return shifted && furthest >= 1 && furthest <= 2 ? shift_name(x, y) : "";
}

// --- Other values in the right places ---

float median(std::vector<float>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

cv::Mat clamped(const Pair& pair, cv::Mat picture) {
  if (pair.clamped) cv::min(picture, 1, picture);
  return picture;
}

/// The background, which the top left corner shows, and what is beyond all values stay.
void try_reversed(const Pair& pair, Search& search) {
  const float background = pair.expected.at<float>(0, 0);
  const auto stays = [&](float a, float e) {
    return a == e && (e == background || e == pair.beyond);
  };
  std::vector<float> sums;
  for_each_pair(pair.actual, pair.expected, [&](float a, float e) {
    if (!stays(a, e)) sums.push_back(a + e);
  });
  if (sums.empty()) return;
  const float sum = median(sums);
  cv::Mat reversed = pair.expected.clone();
  for (int y = 0; y < reversed.rows; ++y) {
    float* row = reversed.ptr<float>(y);
    const float* actual = pair.actual.ptr<float>(y);
    for (int i = 0; i < reversed.cols * reversed.channels(); ++i) {
      if (!stays(actual[i], row[i])) row[i] = sum - row[i];
    }
  }
  search.try_mistake("depth reversed", reversed);
}

std::string in_short(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

void try_factor(const Pair& pair, Search& search) {
  double products = 0;
  double squares = 0;
  for_each_pair(pair.actual, pair.expected, [&](float a, float e) {
    if (pair.clamped && a >= 1) return;
    if (a == pair.beyond || e == pair.beyond) return;
    products += static_cast<double>(a) * e;
    squares += static_cast<double>(e) * e;
  });
  if (!(products > 0)) return;
  const double factor = products / squares;
  search.try_mistake((factor > 1 ? "too bright by a factor of " : "too dark by a factor of ") +
                         in_short(factor > 1 ? factor : 1 / factor),
                     clamped(pair, pair.expected * factor));
}

void try_gamma(const Pair& pair, Search& search) {
  std::vector<float> exponents;
  bool in_unit_range = true;
  for_each_pair(pair.actual, pair.expected, [&](float a, float e) {
    in_unit_range = in_unit_range && a >= 0 && a <= 1 && e >= 0 && e <= 1;
    if (a > 0 && a < 1 && e > 0 && e < 1) exponents.push_back(std::log(a) / std::log(e));
  });
  if (exponents.empty() || !in_unit_range) return;
  const float exponent = median(exponents);
  cv::Mat powers;
  cv::pow(pair.expected, exponent, powers);
  search.try_mistake("gamma applied (values to the power of " + in_short(exponent) + ")", powers);
}

}  // namespace

std::string kind_of_wrong(const AnyImage& actual, const AnyImage& expected) {
  if (width_of(actual) * height_of(actual) == 0 || width_of(expected) * height_of(expected) == 0) {
    return {};
  }
  const Pair pair = comparable_pair(actual, expected);
  if (is_one_color(pair.actual)) {
    return is_one_color(pair.expected) ? "" : "empty";
  }
  if (pair.actual.size() != pair.expected.size()) {
    const cv::Mat turned = transposed(pair.expected);
    const bool explained = turned.size() == pair.actual.size() &&
                           distance(pair.actual, turned) <= 1e-3 * cv::norm(turned, cv::NORM_L1);
    return explained ? "transposed" : "";
  }
  Search search(pair);
  try_turned_over(pair, search);
  try_channels(pair, search);
  try_whole_pixels(pair, search);
  try_factor(pair, search);
  try_gamma(pair, search);
  try_reversed(pair, search);
  return search.verdict().empty() ? half_pixel_shift(pair) : search.verdict();
}

}  // namespace rasterlab
