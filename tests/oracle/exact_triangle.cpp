#include "tests/oracle/exact_triangle.h"

#include <algorithm>
#include <cmath>

namespace rasterlab::oracle {
namespace {

Int128 cross(const GridPoint& a, const GridPoint& b, const GridPoint& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

int sign(Int128 value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

// On which side of the line from a to b the point p + (ε, ε²) lies, for ε → 0: never on it unless a
// = b.
int side(const GridPoint& a, const GridPoint& b, const GridPoint& p) {
  if (const int exact = sign(cross(a, b, p))) return exact;
  if (const int moved_right = sign(a.y - b.y)) return moved_right;
  return sign(b.x - a.x);
}

GridPoint center(std::int64_t x, std::int64_t y) {
  return {Int128{x} * 256 + 128, Int128{y} * 256 + 128};
}

Int128 to_grid(double pixels) {
  const double floor = std::floor(pixels);
  const double rest =
      (pixels - floor) * 256;  // exact: scaling by a power of two what a subtraction left exact
  const double below = std::floor(rest);
  Int128 units = Int128{static_cast<std::int64_t>(floor)} * 256 + static_cast<std::int64_t>(below);
  const double over = rest - below;
  if (over > 0.5 || (over == 0.5 && units % 2 != 0)) ++units;
  return units;
}

}  // namespace

GridTriangle to_grid(const std::array<Eigen::Vector2d, 3>& corners) {
  GridTriangle triangle;
  for (std::size_t i = 0; i < 3; ++i)
    triangle[i] = {to_grid(corners[i].x()), to_grid(corners[i].y())};
  return triangle;
}

bool covers(const GridTriangle& triangle, std::int64_t x, std::int64_t y) {
  const auto& [a, b, c] = triangle;
  if (cross(a, b, c) == 0) return false;
  const GridPoint p = center(x, y);
  const int first = side(a, b, p);
  return first == side(b, c, p) && first == side(c, a, p);
}

Image<std::uint16_t> coverage(const std::vector<GridTriangle>& triangles, int width, int height) {
  Image<std::uint16_t> count(width, height, 0);
  for (const GridTriangle& triangle : triangles) {
    const auto& [a, b, c] = triangle;
    const auto pixel = [](Int128 units, int size) {
      return static_cast<int>(std::clamp<Int128>(units / 256, 0, size));
    };
    const int left = pixel(std::min({a.x, b.x, c.x}) - 256, width);
    const int right = pixel(std::max({a.x, b.x, c.x}) + 256, width);
    const int top = pixel(std::min({a.y, b.y, c.y}) - 256, height);
    const int bottom = pixel(std::max({a.y, b.y, c.y}) + 256, height);
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x)
        count(x, y) = static_cast<std::uint16_t>(count(x, y) + covers(triangle, x, y));
    }
  }
  return count;
}

std::array<long double, 3> weights(const GridTriangle& triangle, std::int64_t x, std::int64_t y) {
  const auto& [a, b, c] = triangle;
  const GridPoint p = center(x, y);
  const auto area = static_cast<long double>(cross(a, b, c));
  return {static_cast<long double>(cross(b, c, p)) / area,
          static_cast<long double>(cross(c, a, p)) / area,
          static_cast<long double>(cross(a, b, p)) / area};
}

}  // namespace rasterlab::oracle
