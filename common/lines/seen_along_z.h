// The simplest camera: x and y as they are, z left out. What stages 01 to 03 see meshes with.
#pragma once

#include <Eigen/Dense>

namespace rasterlab {

/// Where a point of the cube [−1, 1]³ is in the window of a width × height image: x = −1 at the
/// left edge, 0, and x = 1 at the right edge, `width`; y = 1 at the top edge, 0, and y = −1 at the
/// bottom, `height`. In pixels; z does not matter.
inline Eigen::Vector2f seen_along_z(const Eigen::Vector3f& point, int width, int height) {
  return {(point.x() + 1) * 0.5F * static_cast<float>(width),
          (1 - point.y()) * 0.5F * static_cast<float>(height)};
}

}  // namespace rasterlab
