// What happens when a program breaks its own contract, as by reading a pixel outside an image.
#pragma once

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>

namespace rasterlab {

/// A broken contract. Holds the call stack of the place that broke it, which an executable writes
/// to `backtrace_log.txt` (common/stage).
class CheckError : public std::logic_error {
 public:
  explicit CheckError(const std::string& message);

  /// The call stack where the check failed, innermost last, with function names; one frame a line.
  std::string call_stack() const;

 private:
  struct Stack;
  std::shared_ptr<const Stack> stack_;
};

/// Bad input: a file, argument or record that is not what it should be. The message names it, the
/// place in it and what was expected.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What stands in a starter where an answer should be: `throw NotWritten("01.6", from, to);`.
class NotWritten : public std::logic_error {
 public:
  /// `given` are the parameters of the function, which a body that is not written would leave
  /// unused.
  template <class... Given>
  explicit NotWritten(const std::string& exercise, const Given&...)
      : std::logic_error("exercise " + exercise + " is not written yet"), exercise_(exercise) {}

  const std::string& exercise() const { return exercise_; }

 private:
  std::string exercise_;
};

/// No image holds more pixels: an absurd size in a file header is refused before anything is
/// allocated.
inline constexpr std::size_t max_pixel_count = std::size_t{1} << 28;

/// width · height. Throws CheckError when a side is negative or the product exceeds
/// `max_pixel_count`.
std::size_t checked_pixel_count(int width, int height);

/// Throws CheckError: "pixel (x, y) is outside the image of width x height pixels".
[[noreturn]] void throw_outside(int x, int y, int width, int height);

}  // namespace rasterlab
