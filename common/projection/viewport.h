// Exercise 04.2: from NDC to pixels, by a matrix made of simpler ones.
#pragma once

#include <Eigen/Dense>

namespace rasterlab {

/// Moves points by `offset`; directions stay as they are.
Eigen::Matrix4f translation(const Eigen::Vector3f& offset);

/// Multiplies x, y and z by the components of `factors`.
Eigen::Matrix4f scaling(const Eigen::Vector3f& factors);

/// Takes NDC to a rectangle of the window: (−1, +1), the top left corner, to (x, y) and (+1, −1),
/// the bottom right one, to (x + width, y + height). All four are in pixels, y down: so a picture's
/// own viewport is viewport(0, 0, width, height), and the point that lands on the centre of pixel
/// (i, j) lands on (i + ½, j + ½). NDC y is up, hence y is turned over. z stays: the depth buffer
/// holds NDC's. A rectangle without width or height presses all onto a line. Cost: constant, once a
/// picture.
///
/// Source: B.viewport. The slide keeps y up and turns the finished picture over; it maps z to [0,
/// 255].
Eigen::Matrix4f viewport(float x, float y, float width, float height);

}  // namespace rasterlab
