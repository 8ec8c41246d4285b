// Which pixels a triangle covers, in 128-bit integers: the truth the fills of stage 02 are held to.
#pragma once

#include "common/image/image.h"

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Dense>

namespace rasterlab::oracle {

__extension__ using Int128 = __int128;

/// A point in units of 1/256 pixel.
struct GridPoint {
  Int128 x = 0;
  Int128 y = 0;
};
using GridTriangle = std::array<GridPoint, 3>;

/// Corners in pixels to units of 1/256 pixel, round-to-nearest-even, for coordinates of any size
/// below 2^60.
GridTriangle to_grid(const std::array<Eigen::Vector2d, 3>& corners);

/// Whether the centre of pixel (x, y) is covered: whether the centre, moved by an infinitely small
/// step to the right and an infinitely smaller one down, is strictly inside. That is the top-left
/// rule, said without edges.
bool covers(const GridTriangle& triangle, std::int64_t x, std::int64_t y);

/// How many of the triangles cover each pixel.
Image<std::uint16_t> coverage(const std::vector<GridTriangle>& triangles, int width, int height);

/// The exact barycentric weights of the centre of pixel (x, y), rounded once at the end, to a long
/// double.
std::array<long double, 3> weights(const GridTriangle& triangle, std::int64_t x, std::int64_t y);

}  // namespace rasterlab::oracle
