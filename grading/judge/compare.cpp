#include "grading/judge/compare.h"

#include "common/image/difference.h"

#include "grading/judge/segment.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <utility>

namespace rasterlab::grading {
namespace {

/// What a pixel of the actual picture is beside the expected one.
enum class Pixel { blank, right, missing, extra, different };

bool same_number(double expected, double actual, double tolerance) {
  if (std::isnan(expected) || std::isinf(expected))
    return std::isnan(expected) ? std::isnan(actual) : actual == expected;
  return std::fabs(actual - expected) <= tolerance * (1 + std::fabs(expected));
}

std::size_t pixel_count(const Record& record) {
  return static_cast<std::size_t>(record.width) * static_cast<std::size_t>(record.height);
}

std::vector<double> channels_at(const Record& record, std::size_t pixel) {
  const auto count = static_cast<std::size_t>(record.channels);
  std::vector<double> channels;
  for (std::size_t c = 0; c < count; ++c) {
    channels.push_back(record.kind == RecordKind::values ? record.numbers[pixel]
                                                         : record.bytes[pixel * count + c]);
  }
  return channels;
}

/// A pixel of the commonest value, which is the background.
std::size_t background_pixel(const Record& record) {
  if (record.kind == RecordKind::coverage) return 0;
  std::map<std::vector<double>, std::pair<std::size_t, std::size_t>>
      counts;  // how often, and where
  std::pair<std::size_t, std::size_t> commonest = {0, 0};
  for (std::size_t i = 0; i < pixel_count(record); ++i) {
    auto& [count, place] = counts[channels_at(record, i)];
    if (count++ == 0) place = i;
    if (count > commonest.first) commonest = {count, place};
  }
  return commonest.second;
}

bool same_pixel(const Record& expected, const Record& actual, std::size_t pixel) {
  const std::vector<double> a = channels_at(expected, pixel);
  const std::vector<double> b = channels_at(actual, pixel);
  for (std::size_t c = 0; c < a.size(); ++c) {
    const bool same = expected.kind == RecordKind::values
                          ? same_number(a[c], b[c], expected.tolerance)
                          : std::fabs(a[c] - b[c]) <= expected.tolerance;
    if (!same) return false;
  }
  return true;
}

Pixel compare_covered(const Record& expected, const Record& actual, std::size_t i) {
  const bool drawn = actual.bytes[i] != 0;
  switch (expected.demands[i]) {
    case Record::must:
      return drawn ? Pixel::right : Pixel::missing;
    case Record::must_not:
      return drawn ? Pixel::extra : Pixel::blank;
    default:
      return Pixel::blank;
  }
}

/// `background_at` is background_pixel(expected).
Pixel compare_pixel(const Record& expected, const Record& actual, std::size_t i,
                    std::size_t background_at) {
  if (expected.kind == RecordKind::coverage) return compare_covered(expected, actual, i);
  const std::vector<double> background = channels_at(expected, background_at);
  const bool wanted = channels_at(expected, i) != background;
  if (same_pixel(expected, actual, i)) return wanted ? Pixel::right : Pixel::blank;
  if (!wanted) return Pixel::extra;
  return channels_at(actual, i) == background ? Pixel::missing : Pixel::different;
}

bool is_picture(const Record& record) {
  return record.kind == RecordKind::picture || record.kind == RecordKind::values ||
         record.kind == RecordKind::coverage;
}

/// Whether a place in one picture is one in the other, with as much stored there. What a program
/// wrote may be anything: no pixel of it is looked up before this is known.
bool same_layout(const Record& a, const Record& b) {
  return a.kind == b.kind && a.width == b.width && a.height == b.height && a.channels == b.channels;
}

/// "12 pixels missing, 3 extra; the first wrong one is (4, 7): …".
struct PictureCount {
  std::size_t right = 0, missing = 0, extra = 0, different = 0;
  std::size_t first = std::numeric_limits<std::size_t>::max();

  std::size_t wrong() const { return missing + extra + different; }
};

PictureCount count_pixels(const Record& expected, const Record& actual) {
  PictureCount count;
  const std::size_t background = background_pixel(expected);
  for (std::size_t i = 0; i < pixel_count(expected); ++i) {
    const Pixel pixel = compare_pixel(expected, actual, i, background);
    count.right += pixel == Pixel::right;
    count.missing += pixel == Pixel::missing;
    count.extra += pixel == Pixel::extra;
    count.different += pixel == Pixel::different;
    if (pixel >= Pixel::missing) count.first = std::min(count.first, i);
  }
  return count;
}

std::string describe_pixel(const Record& record, std::size_t i) {
  std::ostringstream text;
  if (record.kind == RecordKind::coverage) return record.bytes[i] != 0 ? "drawn" : "not drawn";
  const std::vector<double> channels = channels_at(record, i);
  text.precision(record.kind == RecordKind::values ? 7 : 3);
  for (std::size_t c = 0; c < channels.size(); ++c) text << (c == 0 ? "(" : ", ") << channels[c];
  text << ")";
  return text.str();
}

std::string describe(const Record& expected, const Record& actual, const PictureCount& count) {
  std::ostringstream text;
  text << count.wrong() << " of " << pixel_count(expected) << " pixels are wrong:";
  const char* separator = " ";
  const auto part = [&](std::size_t number, const char* what) {
    if (number == 0) return;
    text << separator << number << ' ' << what;
    separator = ", ";
  };
  part(count.missing, "missing");
  part(count.extra, "extra");
  part(count.different, "of another value");
  const auto width = static_cast<std::size_t>(expected.width);
  text << ". First wrong pixel: (" << count.first % width << ", " << count.first / width << "), ";
  if (expected.kind == RecordKind::coverage) {
    text << (expected.demands[count.first] == Record::must ? "must be drawn" : "must not be drawn");
  } else {
    text << "expected " << describe_pixel(expected, count.first) << ", got "
         << describe_pixel(actual, count.first);
  }
  return text.str() + ".";
}

Comparison compare_pictures(const Record& expected, const Record& actual) {
  if (!same_layout(expected, actual)) {
    std::ostringstream text;
    text << "The picture is " << actual.width << "x" << actual.height << ", expected "
         << expected.width << "x" << expected.height << ".";
    return {.message = text.str()};
  }
  const PictureCount count = count_pixels(expected, actual);
  const std::size_t wanted = count.right + count.missing + count.different;
  if (count.wrong() <= static_cast<std::size_t>(expected.free_pixels))
    return {.right = true, .score = 1};
  const double score =
      wanted == 0 ? 0 : (double(count.right) - double(count.extra)) / double(wanted);
  return {.score = std::clamp(score, 0.0, 1.0), .message = describe(expected, actual, count)};
}

Comparison compare_numbers(const Record& expected, const Record& actual) {
  if (actual.numbers.size() != expected.numbers.size()) {
    return {.message = std::to_string(actual.numbers.size()) + " numbers, expected " +
                       std::to_string(expected.numbers.size()) + "."};
  }
  const std::size_t wrong = wrong_places(expected, actual);
  if (wrong == 0) return {.right = true, .score = 1};
  std::ostringstream text;
  text.precision(9);
  const auto size = expected.numbers.size();
  text << wrong << " of " << size << " numbers are wrong; ";
  for (std::size_t i = 0; i < size; ++i) {
    if (same_number(expected.numbers[i], actual.numbers[i], expected.tolerance)) continue;
    text << "number " << i + 1 << " is " << actual.numbers[i] << ", expected "
         << expected.numbers[i] << ".";
    break;
  }
  return {.score = double(size - wrong) / double(size), .message = text.str()};
}

Comparison compare_texts(const Record& expected, const Record& actual) {
  if (expected.text == actual.text) return {.right = true, .score = 1};
  return {.message = "Got \"" + actual.text.substr(0, 300) + "\", expected \"" +
                     expected.text.substr(0, 300) + "\"."};
}

Comparison compare_segments(const Record& expected, const Record& actual) {
  const std::string fault = segment_fault(actual.numbers, expected.ends);
  if (fault.empty()) return {.right = true, .score = 1};
  return {.score = segment_share(actual.numbers, expected.ends), .message = fault};
}

}  // namespace

Comparison compare(const Record& expected, const Record& actual) {
  if (actual.kind != expected.kind || actual.name != expected.name)
    return {.message = "This result is missing; the program wrote \"" + actual.name + "\" there."};
  if (is_picture(expected)) return compare_pictures(expected, actual);
  switch (expected.kind) {
    case RecordKind::numbers:
      return compare_numbers(expected, actual);
    case RecordKind::segment:
      return compare_segments(expected, actual);
    default:
      return compare_texts(expected, actual);
  }
}

std::size_t wrong_places(const Record& expected, const Record& other) {
  if (other.kind != expected.kind || other.name != expected.name) return 1;
  if (is_picture(expected)) {
    if (!same_layout(expected, other)) return 1;
    return count_pixels(expected, other).wrong();
  }
  if (expected.kind == RecordKind::numbers) {
    std::size_t wrong = 0;
    const std::size_t common = std::min(expected.numbers.size(), other.numbers.size());
    for (std::size_t i = 0; i < common; ++i)
      wrong += !same_number(expected.numbers[i], other.numbers[i], expected.tolerance);
    return wrong + std::max(expected.numbers.size(), other.numbers.size()) - common;
  }
  return compare(expected, other).right ? 0 : 1;
}

double likeness(const Record& expected, const Record& actual, const Record& other) {
  if (wrong_places(expected, other) == 0) return 0;
  if (actual.name != other.name || !same_layout(actual, other) ||
      actual.numbers.size() != other.numbers.size())
    return 0;
  if (expected.kind == RecordKind::text) return actual.text == other.text ? 1 : 0;
  if (expected.kind == RecordKind::segment) return actual.numbers == other.numbers ? 1 : 0;
  if (!same_layout(expected, other) ||
      (expected.kind == RecordKind::numbers && expected.numbers.size() != other.numbers.size()))
    return wrong_places(other, actual) == 0 ? 1 : 0;
  std::size_t alike = 0;
  std::size_t off = 0;
  const bool picture = is_picture(expected);
  const std::size_t background = picture ? background_pixel(expected) : 0;
  const std::size_t count = picture ? pixel_count(expected) : expected.numbers.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto differs = [&](const Record& record) {
      if (picture) return compare_pixel(expected, record, i, background) >= Pixel::missing;
      return !same_number(expected.numbers[i], record.numbers[i], expected.tolerance);
    };
    if (!differs(actual) && !differs(other)) continue;
    ++off;
    if (!differs(actual) || !differs(other)) continue;
    if (!picture) {
      alike += same_number(other.numbers[i], actual.numbers[i], expected.tolerance);
    } else if (expected.kind == RecordKind::coverage) {
      ++alike;
    } else {
      alike += same_pixel(other, actual, i);
    }
  }
  return off == 0 ? 0 : double(alike) / double(off);
}

std::string kind_of_wrong(const Record& expected, const Record& actual) {
  const Image<Rgb8> wanted = to_image(expected);
  const Image<Rgb8> got = to_image(actual);
  if (wanted.empty() || got.empty()) return "";
  return compare_images(AnyImage(got), AnyImage(wanted)).kind_of_wrong;
}

std::string character_grid(const Record& expected, const Record& actual) {
  if (!is_picture(expected) || !same_layout(expected, actual)) return "";
  int left = expected.width, right = -1, top = expected.height, bottom = -1;
  const std::size_t background = background_pixel(expected);
  const auto at = [&](int x, int y) {
    const auto width = static_cast<std::size_t>(expected.width);
    const std::size_t i = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
    return compare_pixel(expected, actual, i, background);
  };
  for (int y = 0; y < expected.height; ++y) {
    for (int x = 0; x < expected.width; ++x) {
      if (at(x, y) < Pixel::missing) continue;
      left = std::min(left, x), right = std::max(right, x);
      top = std::min(top, y), bottom = std::max(bottom, y);
    }
  }
  if (right < 0) return "";
  left = std::max(0, left - 2), top = std::max(0, top - 2);
  right = std::min({expected.width - 1, right + 2, left + 63});
  bottom = std::min({expected.height - 1, bottom + 2, top + 39});
  std::ostringstream grid;
  grid << "columns " << left << " to " << right << ", rows " << top << " to " << bottom << "\n";
  for (int y = top; y <= bottom; ++y) {
    for (int x = left; x <= right; ++x) grid << ".#?!x"[static_cast<int>(at(x, y))];
    grid << "\n";
  }
  return grid.str();
}

Image<Rgb8> to_image(const Record& record) {
  if (!is_picture(record) || pixel_count(record) == 0) return {};
  Image<Rgb8> image(record.width, record.height);
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double number : record.numbers) {
    if (!std::isfinite(number)) continue;
    low = std::min(low, number), high = std::max(high, number);
  }
  for (std::size_t i = 0; i < image.pixels().size(); ++i) {
    const auto grey = [&](double value) {
      const auto byte = static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0));
      return Rgb8{byte, byte, byte};
    };
    if (record.kind == RecordKind::values) {
      const double number = record.numbers[i];
      image.pixels()[i] =
          grey(std::isfinite(number) && high > low ? 255 * (high - number) / (high - low) : 0);
    } else if (record.kind == RecordKind::coverage) {
      image.pixels()[i] = grey(record.bytes[i] != 0 ? 255 : 0);
    } else if (record.channels == 3) {
      image.pixels()[i] = {record.bytes[3 * i], record.bytes[3 * i + 1], record.bytes[3 * i + 2]};
    } else {
      image.pixels()[i] = grey(record.bytes[i]);
    }
  }
  return image;
}

Image<Rgb8> difference_image(const Record& expected, const Record& actual) {
  if (!is_picture(expected) || !same_layout(expected, actual)) return {};
  Image<Rgb8> image(expected.width, expected.height);
  const std::size_t background = background_pixel(expected);
  static constexpr Rgb8 colors[] = {{0, 0, 0},
                                    {110, 110, 110},
                                    {255, 60, 60},
                                    {255, 220, 0},
                                    {255, 0, 255}};  // as Pixel has them
  for (std::size_t i = 0; i < image.pixels().size(); ++i)
    image.pixels()[i] =
        colors[static_cast<std::size_t>(compare_pixel(expected, actual, i, background))];
  return image;
}

}  // namespace rasterlab::grading
