#include "common/image/check.h"

#include <sstream>

#include <backward.hpp>

namespace rasterlab {

struct CheckError::Stack {
  backward::StackTrace trace;
};

CheckError::CheckError(const std::string& message) : std::logic_error(message) {
  auto stack = std::make_shared<Stack>();
  stack->trace.load_here(64);
  stack_ = std::move(stack);
}

std::string CheckError::call_stack() const {
  backward::Printer printer;
  printer.color_mode = backward::ColorMode::never;
  printer.snippet = false;
  std::ostringstream text;
  backward::StackTrace trace = stack_->trace;
  printer.print(trace, text);
  return text.str();
}

std::size_t checked_pixel_count(int width, int height) {
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (width < 0 || height < 0 || count > max_pixel_count) {
    throw CheckError("an image of " + std::to_string(width) + "x" + std::to_string(height) +
                     " pixels cannot be: sides are at least 0 and there are at most 2^28 pixels");
  }
  return count;
}

void throw_outside(int x, int y, int width, int height) {
  throw CheckError("pixel (" + std::to_string(x) + ", " + std::to_string(y) +
                   ") is outside the image of " + std::to_string(width) + "x" +
                   std::to_string(height) + " pixels");
}

}  // namespace rasterlab
