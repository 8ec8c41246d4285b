// Exercise 04.3: the simplest perspective there is: one number in the last row of a matrix.
#pragma once

#include <Eigen/Dense>

namespace rasterlab {

/// Projects as seen from (0, 0, distance), looking along −z: points of the plane z = 0 stay where
/// they are, nearer ones move outward and farther ones inward. The matrix is the identity but for
/// −1/distance in its last row, so that w = 1 − z/distance; after the division x' = x / w, y' = y /
/// w, z' = z / w. z' still grows toward the eye: this is the course's frame, in which the larger z
/// is nearer, and the stage turns it over for its depth buffer. What has z ≥ distance is not in
/// front of the eye (w ≤ 0).
///
/// An infinite distance gives the identity: the orthographic projection. Throws CheckError for a
/// distance that is not positive. Cost: constant, once a picture.
///
/// Source: B.projection, with distance 2.
Eigen::Matrix4f central_projection(float distance);

}  // namespace rasterlab
