#include "data/planet.h"

#include "data/noise.h"

#include <algorithm>
#include <cmath>

namespace rasterlab {
namespace {

constexpr double sea_level = 0.52;

double continents(const Eigen::Vector3d& place) {
  const Eigen::Vector3d bent = place + 0.25 * Eigen::Vector3d(fractal_noise(2.1 * place, 3, 5),
                                                              fractal_noise(2.1 * place, 3, 6),
                                                              fractal_noise(2.1 * place, 3, 7));
  return fractal_noise(1.9 * bent, 6, 1);
}

double smooth_step(double from, double to, double value) {
  const double t = std::clamp((value - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

Color mix(const Color& a, const Color& b, double t) {
  return a + static_cast<float>(t) * (b - a);
}

}  // namespace

bool is_sea(const Eigen::Vector3d& place) {
  return continents(place) < sea_level;
}

double height_above_sea(const Eigen::Vector3d& place) {
  const double land = std::max(continents(place) - sea_level, 0.0) / (1 - sea_level);
  const double ridges = 1 - std::abs(2 * fractal_noise(5 * place, 5, 2) - 1);
  return land * (0.4 + 1.6 * ridges * ridges);
}

Color ground_color(const Eigen::Vector3d& place) {
  const double latitude = std::abs(place.y()) + 0.12 * (fractal_noise(4 * place, 4, 3) - 0.5);
  const double ice = smooth_step(0.93, 0.96, latitude);
  const Color ice_color(0.93F, 0.95F, 0.98F);
  if (is_sea(place)) {
    const double depth = smooth_step(0, 0.18, sea_level - continents(place));
    return mix(mix({0.10F, 0.42F, 0.58F}, {0.02F, 0.11F, 0.34F}, depth), ice_color, ice);
  }
  const double height = height_above_sea(place);
  const double dry =
      smooth_step(0.38, 0.62, fractal_noise(3 * place, 4, 4) + 0.25 * (0.45 - latitude));
  const Color low = mix({0.13F, 0.37F, 0.12F}, {0.72F, 0.60F, 0.34F}, dry);
  const Color mountains = mix(low, {0.43F, 0.35F, 0.28F}, smooth_step(0.15, 0.4, height));
  const Color snow =
      mix(mountains, ice_color, smooth_step(0.45, 0.6, height + 0.3 * latitude * latitude));
  return mix(snow, ice_color, ice);
}

Eigen::Vector3d ground_normal(const Eigen::Vector3d& place) {
  constexpr double step = 2e-3;
  constexpr double steepness = 0.22;
  Eigen::Vector3d slope;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d offset = step * Eigen::Vector3d::Unit(axis);
    slope[axis] = (height_above_sea((place + offset).normalized()) -
                   height_above_sea((place - offset).normalized())) /
                  (2 * step);
  }
  const Eigen::Vector3d along_ground = slope - slope.dot(place) * place;
  return (place - steepness * along_ground).normalized();
}

}  // namespace rasterlab
