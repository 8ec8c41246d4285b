// Meshes made by a formula, at any subdivision: what the stages draw before a file is read, and
// what tests and benchmarks count on.
#pragma once

#include "common/mesh/mesh.h"

#include <string>
#include <string_view>
#include <vector>

namespace rasterlab {

// Every shape is centred on the origin, fits into the cube [-1, 1]³ and has unit normals and
// texture coordinates; the cube also has colours. Faces are counter-clockwise seen from outside
// (wall: from +z, grid: from above, +y). Closed shapes are closed exactly: vertices that a seam has
// split have the same position to the last bit. With subdivision n:
//
// cube        12 n² triangles; side 2. Colour = (position + 1) / 2, so that each corner has its
//             own, black at (-1, -1, -1), white at (1, 1, 1). Normals are the faces' own; the
//             whole texture on every face.
// wall        2 n²; an upright square of side 2 in z = 0, with the whole texture
// grid        2 n²; a level square of side 2 in y = 0, with the whole texture; v grows towards -z
// uv_sphere   4 n (n - 1); a unit sphere of n rings of 2 n columns. The texture is a map of the
//             world: v from the south pole (-y) to the north pole, u eastwards, its middle on +z,
//             its seam on -z.
// icosphere   20 · 4ⁿ; a unit sphere of nearly equal triangles: an icosahedron split n times.
//             Texture as on the UV sphere; u exceeds 1 in the triangles that cross the seam.
// torus       4 n²; a tube of radius 0.3 in a ring of radius 0.7 around y, 2 n sections of n
//             sides; u along the ring, v around the tube
// torus_knot  16 n²; a trefoil: a tube of radius 0.15, twice around y, three times through the
//             hole, 8 n sections of n sides; u along the knot, v around the tube

/// A shape that can be asked for by name.
struct Shape {
  std::string name;
  std::string description;
  int subdivision;  ///< when none is asked for
  int minimum_subdivision;
  int maximum_subdivision;  ///< keeps below 2^26 triangles
  Mesh (*make)(int subdivision);
};

/// All of the above, in that order.
const std::vector<Shape>& shapes();

/// The shape of that name. Throws InputError for an unknown name or a subdivision out of range, and
/// tells which there are.
Mesh make_shape(std::string_view name, int subdivision);

/// "icosphere" at its usual subdivision, or "icosphere:5". Throws InputError as above.
Mesh make_shape(std::string_view name_and_subdivision);

}  // namespace rasterlab
