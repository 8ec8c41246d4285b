#include "common/mesh/text_lines.h"

#include "common/image/check.h"

#include <charconv>
#include <cstdlib>
#include <utility>

namespace rasterlab {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

std::string_view trim(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word.front() == '+' && word[1] != '-') word.remove_prefix(1);
  return word;
}

template <class Number>
std::optional<Number> parse(std::string_view word) {
  word = without_plus(word);
  Number value = 0;
  const char* const last = word.data() + word.size();
  const auto [end, error] = std::from_chars(word.data(), last, value);
  if (end != last || error == std::errc::invalid_argument) return std::nullopt;
  // from_chars leaves the value alone when it is out of range; strtod gives infinity or 0.
  if (error != std::errc()) {
    return static_cast<Number>(std::strtod(std::string(word).c_str(), nullptr));
  }
  return value;
}

}  // namespace

TextLines::TextLines(std::string_view text, std::string file, Continuation continuation)
    : text_(text), file_(std::move(file)), continuation_(continuation) {
  const std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text_.starts_with(byte_order_mark)) position_ = byte_order_mark.size();
}

bool TextLines::next() {
  while (position_ < text_.size()) {
    const std::size_t before = lines_taken_;
    std::string_view line = take_line();
    const bool continued = continuation_ == Continuation::backslash && join_continued(line);
    if (continued) line = joined_;
    rest_ = trim(line);
    line_ = before + 1;
    if (!rest_.empty()) return true;
  }
  rest_ = {};
  line_ = lines_taken_;
  return false;
}

/// The next line without its end and its comment.
std::string_view TextLines::take_line() {
  const std::size_t start = position_;
  const std::size_t end = std::min(text_.find_first_of("\r\n", start), text_.size());
  position_ = end + (text_.substr(end, 2) == "\r\n" ? 2 : 1);
  position_ = std::min(position_, text_.size());
  ++lines_taken_;
  const std::string_view line = text_.substr(start, end - start);
  return line.substr(0, line.find('#'));
}

/// Gathers in joined_ a line that ends with a backslash and those that continue it.
bool TextLines::join_continued(std::string_view line) {
  if (!trim(line).ends_with('\\')) return false;
  joined_.clear();
  while (trim(line).ends_with('\\')) {
    line = trim(line);
    joined_.append(line.substr(0, line.size() - 1)).push_back(' ');
    line = position_ < text_.size() ? take_line() : std::string_view();
  }
  joined_.append(line);
  return true;
}

std::string_view TextLines::take_word() {
  std::size_t end = 0;
  while (end < rest_.size() && !is_blank(rest_[end])) ++end;
  const std::string_view word = rest_.substr(0, end);
  while (end < rest_.size() && is_blank(rest_[end])) ++end;
  rest_.remove_prefix(end);
  return word;
}

std::optional<float> TextLines::take_float() {
  const std::string_view word = take_word();
  if (word.empty()) return std::nullopt;
  const std::optional<float> value = parse_float(word);
  if (!value) fail(quote(word) + " is not a number");
  return value;
}

std::optional<long long> TextLines::take_integer() {
  const std::string_view word = take_word();
  if (word.empty()) return std::nullopt;
  const std::optional<long long> value = parse_integer(word);
  if (!value) fail(quote(word) + " is not a whole number");
  return value;
}

float TextLines::require_float(std::string_view what) {
  const std::optional<float> value = take_float();
  if (!value) fail(std::string(what) + " expected");
  return *value;
}

long long TextLines::require_integer(std::string_view what) {
  const std::optional<long long> value = take_integer();
  if (!value) fail(std::string(what) + " expected");
  return *value;
}

void TextLines::fail(const std::string& problem) const {
  fail_at(line_, problem);
}

void TextLines::fail_at(std::size_t line, const std::string& problem) const {
  throw InputError(file_ + ":" + std::to_string(line) + ": " + problem);
}

std::string quote(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string text = "'";
  for (const char c : word.substr(0, longest)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (word.size() > longest ? "...'" : "'");
}

std::optional<float> parse_float(std::string_view word) {
  return parse<float>(word);
}

std::optional<double> parse_double(std::string_view word) {
  return parse<double>(word);
}

std::optional<long long> parse_integer(std::string_view word) {
  word = without_plus(word);
  long long value = 0;
  const char* const last = word.data() + word.size();
  const auto [end, error] = std::from_chars(word.data(), last, value);
  if (end != last || error != std::errc()) return std::nullopt;
  return value;
}

}  // namespace rasterlab
