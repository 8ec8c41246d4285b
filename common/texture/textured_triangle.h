// A triangle drawn by any rung of exercise 06.3's ladder.
#pragma once

#include "common/projection/clip.h"
#include "common/projection/frame.h"
#include "common/texture/perspective_weights.h"
#include "common/texture/sample.h"

#include <array>

#include <Eigen/Dense>

namespace rasterlab {

/// Draws one triangle, its corners in clip space with (u, v) at each, into `frame`: clipped, filled
/// row by row, smaller depth winning. `rung` says how (u, v) runs along a row. Only the sampler's
/// filters of level 0, nearest and bilinear, make sense here: the texture's derivatives, which the
/// others need, are given as zero.
void draw_textured_triangle(const ClipTriangle& corners,
                            const std::array<Eigen::Vector2f, 3>& texture_coordinates,
                            const Sampler& sampler, PerspectiveRung rung, Frame& frame);

}  // namespace rasterlab
