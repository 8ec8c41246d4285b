#include "tests/support/picture_text.h"

#include <algorithm>
#include <cstddef>

namespace rasterlab {
namespace {

char character_at(const PictureText& text, std::size_t x, std::size_t y) {
  return y < text.size() && x < text[y].size() ? text[y][x] : '.';
}

char overlay_character(char actual, char expected) {
  if (actual == expected) return actual;
  if (actual == '.') return '?';
  return expected == '.' ? '!' : 'x';
}

std::size_t width_of(const PictureText& text) {
  std::size_t width = 0;
  for (const std::string& row : text) width = std::max(width, row.size());
  return width;
}

std::string size_of(const PictureText& text) {
  return std::to_string(width_of(text)) + "x" + std::to_string(text.size());
}

}  // namespace

PictureText overlay(const PictureText& actual, const PictureText& expected) {
  const std::size_t width = std::max(width_of(actual), width_of(expected));
  PictureText result(std::max(actual.size(), expected.size()), std::string(width, '.'));
  for (std::size_t y = 0; y < result.size(); ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      result[y][x] = overlay_character(character_at(actual, x, y), character_at(expected, x, y));
    }
  }
  return result;
}

testing::AssertionResult same_picture(const PictureText& actual, const PictureText& expected) {
  if (actual == expected) return testing::AssertionSuccess();
  testing::AssertionResult failure = testing::AssertionFailure();
  failure << "pictures differ ('?' missing, '!' extra, 'x' drawn otherwise)";
  if (actual.size() != expected.size() || width_of(actual) != width_of(expected)) {
    failure << "; the size is " << size_of(actual) << ", expected " << size_of(expected);
  }
  for (const std::string& row : overlay(actual, expected)) failure << "\n  " << row;
  return failure;
}

}  // namespace rasterlab
