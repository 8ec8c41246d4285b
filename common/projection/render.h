// Exercise 04.8: a mesh of coloured vertices, three times: its edges, its faces in the order they
// come, and the nearest of them at every pixel.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/mesh/mesh.h"
#include "common/projection/draw_mesh.h"
#include "common/projection/frame.h"

namespace rasterlab {

/// Draws the three edges of every triangle, in one colour. What is behind the near plane is cut
/// off, not wrapped round.
void render_wireframe(const Mesh& mesh, const Transforms& transforms, const Color& color,
                      Image<Rgb8>& image);

/// Fills every triangle, in order, without regard to depth: what comes later covers what was there.
/// The vertices' colours are interpolated perspective-correctly; a mesh without colours is white.
void render_in_order(const Mesh& mesh, const Transforms& transforms, Image<Rgb8>& image);

/// The same, but at every pixel the nearest triangle stays, by NDC z in `frame.depth`; of two that
/// are equally near, the earlier. `frame.distance` and `frame.ids`, where they are asked for, tell
/// of the triangle that stays. An empty mesh, and triangles without area, draw nothing. Cost: the
/// vertex stage for each corner of each triangle, and a test of depth for each pixel it covers.
///
/// Source: C.2, C.3.
DrawCounts render_nearest(const Mesh& mesh, const Transforms& transforms, Cull cull, Frame& frame);

}  // namespace rasterlab
