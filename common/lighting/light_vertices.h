// Exercise 05.4: a whole mesh lit, wherever it was turned and moved to.
#pragma once

#include "common/image/pixel.h"
#include "common/lighting/lit_mesh.h"

#include <vector>

namespace rasterlab {

/// The colour the eye sees at every vertex of the mesh, each channel in [0, 1]. A vertex' position
/// and normal are those of the world: moved by the model's matrix, the normal as normals move
/// (exercise 04.10). Light and eye are where they are seen from there; the colour is the mesh's own
/// at that vertex, unless `color` says otherwise. Light does not shine through: a vertex turned
/// away from it gets ambient light alone. Throws CheckError when the mesh has no normals.
/// Cost: one reflection a vertex, seen or not.
///
/// Source: A.Q32.
std::vector<Color> light_vertices(const LitMesh& lit_mesh);

}  // namespace rasterlab
