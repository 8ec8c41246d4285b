// Exercise 04.1: scale, shear, rotate and move in the plane, all by one kind of matrix.
//
// A figure's point (x, y) is written (x, y, 1), a direction (x, y, 0). A 3 × 3 matrix then moves
// points but not directions, and one matrix after another is their product: `(A * B) * p` applies B
// first. The frame is the course's, x right and y up; the stage turns it over when it draws.
// Any finite numbers will do; a factor of 0 presses the plane onto a line, from which nothing leads
// back. Cost: constant.
//
// Source: B.transforms; Foley, van Dam, Feiner, Hughes, "Computer Graphics", section 5.3.
#pragma once

#include <Eigen/Dense>

namespace rasterlab {

/// (x, y) → (sx · x, sy · y).
Eigen::Matrix3f scale_2d(float sx, float sy);

/// (x, y) → (x + x_per_y · y, y + y_per_x · x).
Eigen::Matrix3f shear_2d(float x_per_y, float y_per_x);

/// Counter-clockwise about the origin, by an angle in radians.
Eigen::Matrix3f rotate_2d(float angle);

/// (x, y) → (x + dx, y + dy). Directions stay as they are.
Eigen::Matrix3f translate_2d(float dx, float dy);

/// Counter-clockwise about a point, which stays where it is: there, turn, and back.
Eigen::Matrix3f rotate_about_2d(const Eigen::Vector2f& center, float angle);

/// A point and a direction in homogeneous coordinates.
inline Eigen::Vector3f point_2d(float x, float y) {
  return {x, y, 1};
}
inline Eigen::Vector3f direction_2d(float x, float y) {
  return {x, y, 0};
}

/// Where in the plane (x, y, w) is: (x/w, y/w), for any w but 0. With w = 0 it is a point at
/// infinity, the limit of (x/w, y/w) as w goes to 0: nowhere in the plane, but all lines of that
/// direction meet in it. Then each coordinate that is not 0 is an infinity of its sign, and one
/// that is 0 stays 0.
Eigen::Vector2f to_plane(const Eigen::Vector3f& homogeneous);

}  // namespace rasterlab
