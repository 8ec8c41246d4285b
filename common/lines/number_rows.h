// Text files of numbers, one record a line: how anyone can feed stages 01 to 03 (`--lines`,
// `--triangles`).
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Dense>

namespace rasterlab {

/// The numbers of one line of a file.
struct NumberRow {
  const std::filesystem::path& file;
  int line;  ///< counted from 1
  std::span<const double> numbers;

  /// Throws InputError "FILE:LINE: MESSAGE".
  [[noreturn]] void fail(const std::string& message) const;
};

/// What the lines of a file look like.
struct RowFormat {
  std::string description;          ///< for error messages: "x0 y0 x1 y1 [r g b [r g b]]"
  std::vector<std::size_t> counts;  ///< how many numbers a line may have
};

/// Calls `visit` for every line that has numbers, from the first to the last. Numbers are separated
/// by blanks; `#` starts a comment; empty lines and carriage returns do not count.
///
/// Throws InputError, naming file and line, for a field that is no finite number and for a line
/// with another count of numbers. Nothing has been visited when the file cannot be read.
void for_each_row(const std::filesystem::path& file, const RowFormat& format,
                  const std::function<void(const NumberRow&)>& visit);

/// Three numbers of a row as a colour of 0 … 255 a channel. Throws InputError for a number outside.
Eigen::Vector3f color_at(const NumberRow& row, std::size_t first);

}  // namespace rasterlab
