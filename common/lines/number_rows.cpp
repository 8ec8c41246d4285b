#include "common/lines/number_rows.h"

#include "common/image/bytes.h"
#include "common/image/check.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

namespace rasterlab {
namespace {

/// A field as it may be shown in a message: short, and on one line.
std::string shown(std::string_view field) {
  std::string text(field.substr(0, 20));
  for (char& letter : text) {
    if (static_cast<unsigned char>(letter) < 0x20 || static_cast<unsigned char>(letter) > 0x7E)
      letter = '?';
  }
  return "'" + text + (field.size() > 20 ? "...'" : "'");
}

/// The number a field stands for; NaN where it is none.
double number_in(std::string_view field) {
  if (field.starts_with('+')) field.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), number);
  if (error != std::errc() || end != field.data() + field.size()) return std::nan("");
  return number;
}

constexpr std::string_view blanks = " \t\r\v\f";

/// Replaces `numbers` by those of `text`. Throws InputError by way of `row`.
void split_numbers(std::string_view text, const NumberRow& row, const std::string& description,
                   std::vector<double>& numbers) {
  numbers.clear();
  text = text.substr(0, text.find('#'));
  for (std::size_t begin = text.find_first_not_of(blanks); begin != std::string_view::npos;
       begin = text.find_first_not_of(blanks)) {
    text.remove_prefix(begin);
    const std::string_view field = text.substr(0, text.find_first_of(blanks));
    numbers.push_back(number_in(field));
    if (!std::isfinite(numbers.back())) {
      row.fail("expected a number, found " + shown(field) + " (a line is " + description + ")");
    }
    text.remove_prefix(field.size());
  }
}

}  // namespace

void NumberRow::fail(const std::string& message) const {
  throw InputError(file.string() + ":" + std::to_string(line) + ": " + message);
}

void for_each_row(const std::filesystem::path& file, const RowFormat& format,
                  const std::function<void(const NumberRow&)>& visit) {
  const std::string bytes = read_file(file);
  std::string_view rest = bytes;
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
  std::vector<double> numbers;
  for (int line = 1; !rest.empty(); ++line) {
    const std::string_view text = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(text.size() + 1, rest.size()));
    split_numbers(text, {file, line, {}}, format.description, numbers);
    if (numbers.empty()) continue;
    const NumberRow row{file, line, numbers};
    if (std::find(format.counts.begin(), format.counts.end(), numbers.size()) ==
        format.counts.end()) {
      row.fail("expected " + format.description + ", found " + std::to_string(numbers.size()) +
               (numbers.size() == 1 ? " number" : " numbers"));
    }
    visit(row);
  }
}

Eigen::Vector3f color_at(const NumberRow& row, std::size_t first) {
  Eigen::Vector3f color;
  for (std::size_t i = 0; i < 3; ++i) {
    const double value = row.numbers[first + i];
    if (value < 0 || value > 255)
      row.fail("expected colours from 0 to 255, found " + shown(std::to_string(value)));
    color[static_cast<int>(i)] = static_cast<float>(value / 255);
  }
  return color;
}

}  // namespace rasterlab
