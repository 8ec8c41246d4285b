// A made-up planet: how high its ground is and what colour it has, everywhere on the unit sphere.
#pragma once

#include "common/image/pixel.h"

#include <Eigen/Dense>

namespace rasterlab {

/// Where the planet's ground is above the sea, from 0 at sea level (and below) to about 1. `place`
/// is a unit vector.
double height_above_sea(const Eigen::Vector3d& place);

bool is_sea(const Eigen::Vector3d& place);

/// Sea by depth, land by height and latitude, ice around the poles (±y).
Color ground_color(const Eigen::Vector3d& place);

/// The unit normal of the ground, as mountains tilt it; in object space, as `place` is.
Eigen::Vector3d ground_normal(const Eigen::Vector3d& place);

}  // namespace rasterlab
