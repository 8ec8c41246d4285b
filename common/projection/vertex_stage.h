// Exercise 04.7: what happens to a vertex on its way to the window.
#pragma once

#include <Eigen/Dense>

namespace rasterlab {

/// A vertex in the window: pixels, origin at the picture's top left corner, y down; and its depth,
/// NDC z.
struct WindowPoint {
  Eigen::Vector2f position;
  float depth;
};

/// matrix · (x, y, z, 1), each component ((m₀·x + m₁·y) + m₂·z) + m₃ in single precision: the order
/// of the operations is part of the contract, because the engine does the same and must cover the
/// same pixels. With projection · view · model it takes a mesh's position to clip space.
/// Cost: 12 multiplications and additions.
Eigen::Vector4f to_clip(const Eigen::Matrix4f& matrix, const Eigen::Vector3f& position);

/// From clip space to the window: divided by w, once, then x = (x/w + 1) · (width/2), y = (1 − y/w)
/// · (height/2), depth = z/w, again in single precision and this order. For w ≠ 0; what is behind
/// the eye (w ≤ 0) must have been clipped away before. Width and height need not be equal, nor
/// even. Cost: three divisions.
///
/// Source: A.Q30. That course puts NDC (−1, −1) at the top left; here y is up in NDC and turned
/// over on the way.
WindowPoint to_window(const Eigen::Vector4f& clip, int width, int height);

}  // namespace rasterlab
