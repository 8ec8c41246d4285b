// Reading meshes: OFF, OBJ, PLY, STL and OM files, and the built-in shapes.
#pragma once

#include "common/mesh/mesh.h"

#include <filesystem>
#include <string_view>

namespace rasterlab {

/// The mesh in `file`, whose format follows from its extension, else from how it begins.
/// "builtin:NAME[:SUBDIVISION]" is a shape of shapes.h. What each format may hold is said in
/// read_off.h, read_obj.h, read_ply.h, read_stl.h and read_om.h; how polygons become triangles and
/// corners become vertices, in mesh_builder.h.
///
/// Normals, colours and texture coordinates are those of the file: an array is empty when the file
/// has none.
///
/// Throws InputError, whose message names the file, in a text the line, and what was expected.
/// Memory follows the size of the file, never a count in it.
///
/// Why OpenMesh reads OM only: its other readers (version 9) report success where they have dropped
/// or misread something, never say in which line, abort on some broken files, and loop or allocate
/// without end on others.
///   OFF  colours are dropped or taken for 0…255 (course C), face colours too; big-endian files
///   misread OBJ  of a vertex's normals only the last is kept; faces with an index out of range or
///   that are not
///        manifold are dropped or torn off; `\` does not continue a line; "f //1" aborts
///   PLY  binary files with doubles give zeros, lists that are not counted in bytes or not known
///   shift all
///        that follows; a header without end never ends
///   STL  a binary file that begins with "solid" has no faces; what is cut off or no number goes
///   unnoticed
Mesh read_mesh(const std::filesystem::path& file);

/// The mesh in the bytes of a file of that name.
Mesh read_mesh_bytes(std::string_view bytes, const std::filesystem::path& file);

}  // namespace rasterlab
