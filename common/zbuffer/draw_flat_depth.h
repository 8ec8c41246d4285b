// Exercise 03.6: the lit mesh of 02.7, and what is nearer in front.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/mesh/mesh.h"
#include "common/zbuffer/depth_buffer.h"

namespace rasterlab {

/// Draws what draw_flat_faces() draws, every pixel with draw_point(): seen along z, so that a point
/// of the mesh has the depth −z, and what is outside [−1, 1] is not drawn. Faces turned away are
/// left out, as are faces without area, and faces with a corner beyond ±2^30 pixels or not a
/// number. `depth` is as large as `image`; what it already holds hides what is behind. A right
/// answer is within 1 of 255 in every channel, and within 1e-6 in depth. Cost: one step per pixel
/// covered.
///
/// Source: B.mission, A.6.3.
void draw_flat_depth(Image<Rgb8>& image, DepthBuffer& depth, const Mesh& mesh);

}  // namespace rasterlab
