// Exercise 02.7, first part: every face in a colour of its own.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/mesh/mesh.h"

#include <cstdint>

namespace rasterlab {

/// Fills the triangles of a mesh seen along z (seen_along_z()) in the order of the mesh, each in a
/// random colour that depends on `seed` and on the face's index alone: the same seed gives the same
/// picture. Both sides of a face are drawn, and later faces cover earlier ones. Exact coverage:
/// every pixel inside the outline is drawn.
///
/// Free: how colours are drawn from the seed. Another seed gives other colours. Faces with a corner
/// beyond ±2^30 pixels, or not a number, are left out; faces without area cover nothing. Cost: the
/// pixels covered.
///
/// Source: B.head.
void draw_random_faces(Image<Rgb8>& image, const Mesh& mesh, std::uint32_t seed);

}  // namespace rasterlab
