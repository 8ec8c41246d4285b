// A mesh that can be lit, whatever its file said.
#pragma once

#include "common/mesh/mesh.h"

namespace rasterlab {

/// The mesh with its own normals or, where it has none, those of vertex_normals() (exercise 05.1).
Mesh with_normals(Mesh mesh);

}  // namespace rasterlab
