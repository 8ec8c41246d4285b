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
/// OpenMesh reads OM files only. Its other readers (version 9.0) report success where they have
/// dropped or misread something, never say in which line, and some broken files abort the process:
///
/// OFF: colours that the header does not announce are dropped, and faces that have one with them;
///      whole numbers count as 0…255; files of the other byte order are misread; a count is
///      allocated whatever it is.
/// OBJ: of a vertex's normals only the last is kept; a face with an index out of range is
///      dropped, or joined to a copy of a vertex that OpenMesh made; `\` does not continue a
///      line; "f //1" aborts.
/// PLY: a header without end is read for ever; a second list of a face costs other faces; a
///      face with an index out of range is dropped; the length of a list is allocated whatever
///      it is.
/// STL: of a file that is cut off nothing is left; words that are no numbers go unnoticed.
Mesh read_mesh(const std::filesystem::path& file);

/// The mesh in the bytes of a file of that name.
Mesh read_mesh_bytes(std::string_view bytes, const std::filesystem::path& file);

}  // namespace rasterlab
