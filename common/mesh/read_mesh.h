// Reading meshes: OFF, OBJ, PLY, STL and OM files, and the built-in shapes.
#pragma once

#include "common/mesh/mesh.h"

#include <filesystem>

namespace rasterlab {

/// The mesh in `file`, whose format follows from its extension; "builtin:NAME[:SUBDIVISION]" is a
/// shape of shapes.h. Polygons are cut into triangles.
///
/// Normals, colours and texture coordinates are those of the file: an array is empty when the file
/// has none.
///
/// Throws InputError, whose message names the file, where it can the line, and what was expected.
Mesh read_mesh(const std::filesystem::path& file);

}  // namespace rasterlab
