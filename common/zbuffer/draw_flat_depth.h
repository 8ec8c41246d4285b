// Exercise 03.6: the lit mesh of 02.7, and what is nearer in front.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/mesh/mesh.h"
#include "common/zbuffer/depth_buffer.h"

namespace rasterlab {

/// Draws what draw_flat_faces() draws, every pixel with draw_point(): seen along z, so that a point
/// of the mesh has the depth −z, and what is outside [−1, 1] is not drawn. Faces turned away are
/// left out.
///
/// Source: B.mission, A.6.3.
void draw_flat_depth(Image<Rgb8>& image, DepthBuffer& depth, const Mesh& mesh);

}  // namespace rasterlab
