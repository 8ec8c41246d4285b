#include "common/image/difference.h"

#include "common/image/convert.h"
#include "common/image/kind_of_wrong.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <type_traits>

namespace rasterlab {
namespace {

constexpr std::size_t pixels_shown = 8;

template <class Pixel>
auto channels_of(const Pixel& pixel) {
  if constexpr (std::is_arithmetic_v<Pixel>) {
    return std::array<double, 1>{static_cast<double>(pixel)};
  } else if constexpr (std::is_same_v<Pixel, Color>) {
    return std::array<double, 3>{pixel.x(), pixel.y(), pixel.z()};
  } else if constexpr (pixel_kind<Pixel>.channels == 3) {
    return std::array<double, 3>{double(pixel.r), double(pixel.g), double(pixel.b)};
  } else {
    return std::array<double, 4>{double(pixel.r), double(pixel.g), double(pixel.b),
                                 double(pixel.a)};
  }
}

double channel_difference(double a, double b) {
  if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
  const double difference = std::abs(a - b);
  return std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
}

template <class Pixel>
double pixel_difference(const Pixel& a, const Pixel& b) {
  const auto channels_a = channels_of(a);
  const auto channels_b = channels_of(b);
  double largest = 0;
  for (std::size_t i = 0; i < channels_a.size(); ++i) {
    largest = std::max(largest, channel_difference(channels_a[i], channels_b[i]));
  }
  return largest;
}

/// The difference to the most similar pixel of `image` within `radius` of (x, y).
template <class Pixel>
double nearest_difference(const Pixel& pixel, const Image<Pixel>& image, int x, int y, int radius) {
  double least = Tolerance::any_difference;
  for (int j = std::max(0, y - radius); j <= std::min(image.height() - 1, y + radius); ++j) {
    for (int i = std::max(0, x - radius); i <= std::min(image.width() - 1, x + radius); ++i) {
      least = std::min(least, pixel_difference(pixel, image.row(j)[i]));
    }
  }
  return least;
}

template <class Pixel>
std::string text_of(const Pixel& pixel) {
  std::ostringstream text;
  text.precision(std::numeric_limits<float>::max_digits10);
  const auto channels = channels_of(pixel);
  if (channels.size() > 1) text << "(";
  for (std::size_t i = 0; i < channels.size(); ++i) text << (i == 0 ? "" : ", ") << channels[i];
  if (channels.size() > 1) text << ")";
  return text.str();
}

template <class Pixel>
void compare_pixels(const Image<Pixel>& actual, const Image<Pixel>& expected, int radius,
                    Difference& result) {
  for (int y = 0; y < actual.height(); ++y) {
    for (int x = 0; x < actual.width(); ++x) {
      const Pixel& a = actual.row(y)[x];
      const Pixel& e = expected.row(y)[x];
      if (pixel_difference(a, e) == 0) continue;
      const double difference = std::max(nearest_difference(a, expected, x, y, radius),
                                         nearest_difference(e, actual, x, y, radius));
      if (difference == 0) continue;
      ++result.differing_pixels;
      result.largest = std::max(result.largest, difference);
      if (result.first.size() < pixels_shown)
        result.first.push_back({x, y, text_of(a), text_of(e)});
    }
  }
}

std::string size_text(const AnyImage& image) {
  return std::to_string(width_of(image)) + "x" + std::to_string(height_of(image));
}

bool same_size(const AnyImage& a, const AnyImage& b) {
  return width_of(a) == width_of(b) && height_of(a) == height_of(b);
}

/// The kind that holds both; floats have no alpha.
PixelKind kind_holding(const AnyImage& a, const AnyImage& b) {
  const Depth depth = std::max(kind_of(a).depth, kind_of(b).depth);
  const int channels = std::max(kind_of(a).channels, kind_of(b).channels);
  return {depth == Depth::floating ? std::min(channels, 3) : channels, depth};
}

/// Calls visit(a, b) with the two as images of one kind of pixel.
template <class Visit>
void visit_as_one_kind(const AnyImage& a, const AnyImage& b, Visit visit) {
  const PixelKind kind = kind_holding(a, b);
  if (kind_of(a) != kind || kind_of(b) != kind) {
    return visit_as_one_kind(convert(a, kind), convert(b, kind), visit);
  }
  std::visit(
      [&]<class Pixel>(const Image<Pixel>& pixels) { visit(pixels, std::get<Image<Pixel>>(b)); },
      a);
}

/// Shows a channel's difference as 64 to 255.
std::uint8_t amplified(double difference, double largest) {
  if (difference == 0) return 0;
  if (difference >= largest) return 255;
  return static_cast<std::uint8_t>(64 + 191 * difference / largest);
}

template <class Pixel>
Rgb8 amplified_pixel(const Pixel& a, const Pixel& b, double largest) {
  const auto channels_a = channels_of(a);
  const auto channels_b = channels_of(b);
  std::array<std::uint8_t, 4> shown{};
  for (std::size_t i = 0; i < channels_a.size(); ++i) {
    shown[i] = amplified(channel_difference(channels_a[i], channels_b[i]), largest);
  }
  if (channels_a.size() == 1) return {shown[0], shown[0], shown[0]};
  // A difference in alpha alone is seen as grey.
  return {std::max(shown[0], shown[3]), std::max(shown[1], shown[3]), std::max(shown[2], shown[3])};
}

/// The largest difference that is finite, so that one infinity does not darken all others.
template <class Pixel>
double largest_finite_difference(const Image<Pixel>& a, const Image<Pixel>& b) {
  double largest = 0;
  for (int y = 0; y < std::min(a.height(), b.height()); ++y) {
    for (int x = 0; x < std::min(a.width(), b.width()); ++x) {
      const double difference = pixel_difference(a.row(y)[x], b.row(y)[x]);
      if (std::isfinite(difference)) largest = std::max(largest, difference);
    }
  }
  return largest;
}

}  // namespace

Difference compare_images(const AnyImage& actual, const AnyImage& expected,
                          const Tolerance& tolerance) {
  Difference result;
  if (!same_size(actual, expected)) {
    result.matches = false;
    result.other_size = size_text(actual) + ", expected " + size_text(expected);
    result.kind_of_wrong = kind_of_wrong(actual, expected);
    return result;
  }
  visit_as_one_kind(actual, expected, [&](const auto& a, const auto& e) {
    result.all_pixels = a.pixels().size();
    const int side = std::max(a.width(), a.height());
    compare_pixels(a, e, std::min(tolerance.neighbor_radius, side), result);
  });
  result.matches =
      result.differing_pixels == 0 || (result.differing_pixels <= tolerance.total_pixels &&
                                       result.largest <= tolerance.max_difference);
  if (!result.matches) result.kind_of_wrong = kind_of_wrong(actual, expected);
  return result;
}

std::string describe(const Difference& difference) {
  std::ostringstream text;
  if (!difference.other_size.empty()) {
    text << "the size is " << difference.other_size << "\n";
  } else if (difference.differing_pixels == 0) {
    text << "no pixel differs\n";
  } else {
    text << difference.differing_pixels << " of " << difference.all_pixels
         << " pixels differ, the largest difference is " << difference.largest << "\n";
    for (const DifferingPixel& pixel : difference.first) {
      text << "  (" << pixel.x << ", " << pixel.y << ") is " << pixel.actual << ", expected "
           << pixel.expected << "\n";
    }
    if (difference.differing_pixels > difference.first.size()) text << "  ...\n";
  }
  if (!difference.kind_of_wrong.empty())
    text << "kind of wrong: " << difference.kind_of_wrong << "\n";
  return text.str();
}

Image<Rgb8> difference_picture(const AnyImage& actual, const AnyImage& expected) {
  Image<Rgb8> result(std::max(width_of(actual), width_of(expected)),
                     std::max(height_of(actual), height_of(expected)), {255, 0, 255});
  visit_as_one_kind(actual, expected, [&](const auto& a, const auto& e) {
    const double largest = largest_finite_difference(a, e);
    for (int y = 0; y < std::min(a.height(), e.height()); ++y) {
      for (int x = 0; x < std::min(a.width(), e.width()); ++x) {
        result.row(y)[x] = amplified_pixel(a.row(y)[x], e.row(y)[x], largest);
      }
    }
  });
  return result;
}

}  // namespace rasterlab
