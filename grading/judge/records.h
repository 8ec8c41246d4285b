// What a probe writes and the judge reads: named results of one exercise on one scene.
//
// The file: the line "RASTERLAB RESULT 1", then per record one header line and its bytes, then the
// line "end". Numbers are native doubles, floats and bytes: a result is judged on the machine that
// made it.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace rasterlab::grading {

enum class RecordKind { picture, values, coverage, segment, numbers, text };

/// One result. How it is compared stands in the record of the reference answer; what a student's
/// program writes there is not looked at.
struct Record {
  std::string name;  ///< what it is, for a person: "the pixels of (3, 4)–(9, 6)"
  RecordKind kind = RecordKind::text;

  /// picture: bytes, `channels` a pixel; coverage: one byte a pixel, 0 or 1. values: in `numbers`.
  int width = 0;
  int height = 0;
  int channels = 1;
  std::vector<std::uint8_t> bytes = {};

  /// coverage: what each pixel may be.
  enum Demand : std::uint8_t { must_not = 0, may = 1, must = 2 };
  std::vector<std::uint8_t> demands = {};

  /// numbers and values: what was computed. segment: x, y of each pixel in order.
  std::vector<double> numbers = {};
  /// segment: x0, y0, x1, y1, and 1 where the pixels may also come from the second end to the
  /// first.
  std::vector<double> ends = {};

  std::string text = {};

  /// picture: how far a channel may be off. numbers, values: absolute tolerance, plus the same
  /// share of the expected number.
  double tolerance = 0;
  /// picture: how many pixels may differ by more.
  int free_pixels = 0;
};

/// Collects records and writes them.
class Results {
 public:
  void picture(const std::string& name, const Image<Rgb8>& image, int max_difference = 0,
               int free_pixels = 0);
  void picture(const std::string& name, const Image<std::uint8_t>& image, int max_difference = 0,
               int free_pixels = 0);
  /// A picture of numbers, as depths; not-a-number and infinities must agree exactly.
  void values(const std::string& name, const Image<float>& image, double tolerance,
              int free_pixels = 0);
  /// Pixels drawn, where the contract leaves freedom: `demands` holds a Record::Demand per pixel.
  void coverage(const std::string& name, const Image<std::uint8_t>& drawn,
                const Image<std::uint8_t>& demands);
  /// The pixels of a discrete segment in order; any answer the contract of the segments allows is
  /// right.
  void segment(const std::string& name, const std::vector<Eigen::Vector2i>& pixels,
               Eigen::Vector2i from, Eigen::Vector2i to, bool either_direction = false);
  void numbers(const std::string& name, const std::vector<double>& numbers, double tolerance = 0);
  void number(const std::string& name, double number, double tolerance = 0);
  void text(const std::string& name, const std::string& text);

  void write(const std::filesystem::path& path) const;

 private:
  std::vector<Record> records_;
};

/// Reads a result file strictly. Throws InputError for anything else: no regular file, larger than
/// 64 MiB, a header that is off, bytes missing, bytes left over.
std::vector<Record> read_results(const std::filesystem::path& path);

}  // namespace rasterlab::grading
