// Exercise 06.3: how far along a triangle's sides a pixel is, once seen in perspective.
//
// On the screen, a pixel's barycentric weights change by the same amount from pixel to pixel. On
// the triangle they don't: its far end is squeezed into few pixels. What does change evenly is each
// weight divided by its corner's w, and the sum of those.
#pragma once

#include <span>

#include <Eigen/Dense>

namespace rasterlab {

/// The pixels of one row that a triangle covers, from left to right, and what is known of them.
struct PerspectiveRow {
  Eigen::Vector3d inverse_w;                 ///< 1/w of each corner's clip position, above 0
  std::span<const Eigen::Vector3d> weights;  ///< each pixel's weights on the screen (rasterize.h)
};

/// Gives each pixel of a row its weights on the triangle, with which any value given at the corners
/// is then mixed. Both sum to 1; `on_triangle` has one entry per pixel.
using PerspectiveRung = void (*)(const PerspectiveRow& row, std::span<Eigen::Vector3d> on_triangle);

/// First rung: none of it; weights on the screen are taken for those on the triangle. Right where
/// all w are equal. Elsewhere a texture bends along the triangle's diagonal.
void affine_weights(const PerspectiveRow& row, std::span<Eigen::Vector3d> on_triangle);

/// Second and third rung: exact at pixels 0, 16, 32 … (or 0, 8, 16 …) of the row and at its last,
/// and evenly spread in between: a division for 16 (8) pixels instead of for each. A row of one
/// pixel is exact. How 3D games of 1996 could afford it.
void weights_in_runs_of_16(const PerspectiveRow& row, std::span<Eigen::Vector3d> on_triangle);
void weights_in_runs_of_8(const PerspectiveRow& row, std::span<Eigen::Vector3d> on_triangle);

/// Last rung: exact_weights() of each pixel.
void perspective_weights(const PerspectiveRow& row, std::span<Eigen::Vector3d> on_triangle);

/// The weights on the triangle of one pixel: bᵢ = (λᵢ/wᵢ) / Σⱼ(λⱼ/wⱼ), λ being its weights on the
/// screen. Within a few units in the last place of a double, slivers and ratios of w of 10^5
/// included. Cost: one division. Source: C.5; Heckbert and Moreton, "Interpolation for Polygon
/// Texture Mapping and Shading", 1991.
Eigen::Vector3d exact_weights(const Eigen::Vector3d& on_screen, const Eigen::Vector3d& inverse_w);

}  // namespace rasterlab
