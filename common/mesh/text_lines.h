// Going through a text file line by line and word by word, and saying where in it something is
// wrong.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace rasterlab {

/// The records of a text file: lines with something on them. A comment, from `#` to the end of its
/// line, is not seen; lines end with LF, CRLF or CR.
class TextLines {
 public:
  enum class Continuation { none, backslash };

  /// `text` must outlive the object. `file` names it in messages. With Continuation::backslash a
  /// line that ends with `\` goes on in the next.
  TextLines(std::string_view text, std::string file,
            Continuation continuation = Continuation::none);

  /// Goes to the next record, the first at first. False at the end of the file.
  bool next();

  /// The words of the record that were not taken yet.
  std::string_view rest() const { return rest_; }

  /// The next word of the record; empty at its end.
  std::string_view take_word();

  /// The next word as a number; nothing at the end of the record. Throws where the word is no
  /// number.
  std::optional<float> take_float();
  std::optional<long long> take_integer();

  /// The next word as a number. Throws where there is none; `what` says what was expected.
  float require_float(std::string_view what);
  long long require_integer(std::string_view what);

  /// Number of the record's line, from 1; of one continued, of its first line.
  std::size_t line() const { return line_; }

  /// Bytes of the text after this record.
  std::size_t bytes_left() const { return text_.size() - position_; }

  /// Throws InputError "FILE:LINE: problem".
  [[noreturn]] void fail(const std::string& problem) const;
  [[noreturn]] void fail_at(std::size_t line, const std::string& problem) const;

 private:
  std::string_view take_line();
  bool join_continued(std::string_view line);

  std::string_view text_;
  std::string file_;
  Continuation continuation_;
  std::size_t position_ = 0;
  std::size_t lines_taken_ = 0;
  std::size_t line_ = 0;
  std::string_view rest_;
  std::string joined_;
};

/// A word of a file for a message: in quotes, not too long, without control characters.
std::string quote(std::string_view word);

/// The whole of `word` as a number: "1", "+1.5", ".5", "1e-3", "inf". Too large is infinite, too
/// small 0.
std::optional<float> parse_float(std::string_view word);
std::optional<double> parse_double(std::string_view word);
std::optional<long long> parse_integer(std::string_view word);

}  // namespace rasterlab
