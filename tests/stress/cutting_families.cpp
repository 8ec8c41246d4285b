// What clipping leaves of triangles with coordinates of any size, in exact rationals: sums of
// floats as far apart as 10⁻³⁸ and 10³⁸ fit no float of fixed length.
#include "common/projection/clip.h"

#include "tests/stress/family.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#ifndef __clang__
// g++ 12 takes the small-integer storage inside cpp_int for uninitialized.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <boost/multiprecision/cpp_int.hpp>

namespace rasterlab::stress {
namespace {

using Rational = boost::multiprecision::cpp_rational;

constexpr std::size_t per_pair = 16;
/// Times the largest number that goes in. Each of five planes rounds a few times, by half a unit in
/// the last place, 2⁻²⁴, and hands on what the plane before was off by.
constexpr double roundings = 32 * 0x1p-24;
/// Where floats underflow they are off by as much whatever their size.
constexpr double underflow = 64 * 0x1p-149;

/// Four corners, of which the first two belong to both triangles.
struct Pair {
  std::array<ClipTriangle, 2> triangles;

  explicit Pair(const Numbers& n) {
    std::array<Eigen::Vector4f, 4> corner;
    for (std::size_t i = 0; i < per_pair; ++i) {
      corner[i / 4][static_cast<Eigen::Index>(i % 4)] = static_cast<float>(n[i]);
    }
    triangles = {ClipTriangle{corner[0], corner[1], corner[2]}, {corner[1], corner[0], corner[3]}};
  }

  /// Whether no sum or product that clipping makes of it can overflow.
  bool stays_finite() const {
    return std::all_of(triangles.begin(), triangles.end(), [](const ClipTriangle& triangle) {
      return std::all_of(triangle.begin(), triangle.end(), [](const Eigen::Vector4f& p) {
        return p.allFinite() && p.cwiseAbs().maxCoeff() <= 0x1p100F;
      });
    });
  }
};

/// Four corners of numbers that are alike in size, or not at all.
Numbers cuts(Random& random) {
  Numbers numbers;
  const double spread = random.pick({0, 1, 8, 30});
  for (std::size_t i = 0; i < per_pair; ++i) {
    const double reach = i % 4 < 2 ? random.pick({1, 1000}) : 1;
    const double size = std::pow(10, random.number(-spread, spread));
    numbers.push_back(random.chance(0.05) ? random.pick({0, -0.0, 0x1p-149, -0x1p-149})
                                          : random.number(-reach, reach) * size);
  }
  return numbers;
}

double largest_of(const ClipTriangle& triangle, Eigen::Index k) {
  return std::max({std::abs(triangle[0][k]), std::abs(triangle[1][k]), std::abs(triangle[2][k])});
}

/// How far component `k` of a corner is from what its weights make of the triangle's corners.
double off_its_weights(const ClipTriangle& triangle, const ClipVertex& vertex, Eigen::Index k) {
  Rational mixed = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    mixed += Rational(vertex.weights[static_cast<Eigen::Index>(i)]) * Rational(triangle[i][k]);
  }
  return std::abs(static_cast<double>(mixed - Rational(vertex.position[k])));
}

/// How far a corner is beyond z ≥ −w or the guard band, as a part of what rounding may do.
double beyond_planes(const ClipTriangle& triangle, const ClipVertex& vertex,
                     const Eigen::Vector2f& guard) {
  const double w_allowed = roundings * largest_of(triangle, 3) + underflow;
  const auto beyond = [&](float guard_of_w, Eigen::Index k, int sign) {
    const Rational distance =
        Rational(guard_of_w) * Rational(vertex.position.w()) + sign * Rational(vertex.position[k]);
    const double allowed = guard_of_w * w_allowed + roundings * largest_of(triangle, k) + underflow;
    return -static_cast<double>(distance) / allowed;
  };
  return std::max({beyond(1, 2, 1), beyond(guard.x(), 0, 1), beyond(guard.x(), 0, -1),
                   beyond(guard.y(), 1, 1), beyond(guard.y(), 1, -1)});
}

void check_corners(const ClipTriangle& triangle, const ClipPolygon& polygon,
                   const Eigen::Vector2f& guard, Verdict& verdict) {
  for (const ClipVertex& vertex : polygon) {
    for (Eigen::Index k = 0; k < 4; ++k) {
      verdict.expect_error(off_its_weights(triangle, vertex, k),
                           roundings * largest_of(triangle, k) + underflow, [&] {
                             return "component " + std::to_string(k) +
                                    " of a corner is not what its weights make of the triangle's";
                           });
    }
    verdict.expect_error(std::max(0.0, beyond_planes(triangle, vertex, guard)), 1,
                         [] { return "a corner is beyond a plane"; });
  }
}

using Bits = std::array<std::uint32_t, 4>;

/// Where its corners are, to the last bit but for the sign of a 0, sorted.
std::vector<Bits> places_of(const ClipPolygon& polygon) {
  std::vector<Bits> places;
  for (const ClipVertex& vertex : polygon) {
    const Eigen::Vector4f unsigned_zeros = vertex.position + Eigen::Vector4f::Zero();
    Bits bits;
    std::memcpy(bits.data(), unsigned_zeros.data(), sizeof bits);
    places.push_back(bits);
  }
  std::sort(places.begin(), places.end());
  return places;
}

/// What is left of the shared edge alone, as a triangle without area, is among the corners of both
/// triangles.
void check_shared_corners(const Pair& pair, const std::array<ClipPolygon, 2>& polygons,
                          const Eigen::Vector2f& guard, Verdict& verdict) {
  const ClipTriangle& first = pair.triangles[0];
  std::vector<Bits> edge = places_of(clip_homogeneous({first[0], first[1], first[1]}, guard));
  edge.erase(std::unique(edge.begin(), edge.end()), edge.end());
  for (const ClipPolygon& polygon : polygons) {
    const std::vector<Bits> places = places_of(polygon);
    verdict.expect(std::includes(places.begin(), places.end(), edge.begin(), edge.end()),
                   [] { return "the edge that two triangles share is cut in different places"; });
  }
}

void check_cuts(const Numbers& numbers, Verdict& verdict) {
  static const Eigen::Vector2f guard = guard_band(64, 48);
  const Pair pair(numbers);
  if (!pair.stays_finite()) return;
  std::array<ClipPolygon, 2> polygons;
  for (std::size_t i = 0; i < 2; ++i) {
    polygons[i] = clip_homogeneous(pair.triangles[i], guard);
    check_corners(pair.triangles[i], polygons[i], guard, verdict);
  }
  check_shared_corners(pair, polygons, guard, verdict);
}

}  // namespace

std::vector<Family> cutting_families() {
  return {
      many_at_once("cuts",
                   "a corner that clipping leaves is, in exact rationals and but for rounding, "
                   "what its weights make of the triangle's corners and beyond no plane, and two "
                   "triangles that share an edge have the same bits along it",
                   per_pair, 8, cuts, check_cuts)};
}

}  // namespace rasterlab::stress
