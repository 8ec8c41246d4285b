// What is the same for all pixels of a triangle, made once.
#pragma once

#include <cstdint>

namespace rasterlab {

/// A function of a triangle's index that calls `make(triangle)` when it is first asked for that
/// triangle, and gives what it made until another is asked for: for draw_mesh(), whose pixels come
/// triangle by triangle.
template <class Value, class Make>
auto once_a_triangle(const Make& make) {
  return [make, value = Value{},
          of = std::int64_t{-1}](std::uint32_t triangle) mutable -> const Value& {
    if (of != triangle) {
      value = make(triangle);
      of = triangle;
    }
    return value;
  };
}

}  // namespace rasterlab
