// Reading OFF files, text and binary.
#pragma once

#include "common/mesh/mesh.h"

#include <string>
#include <string_view>

namespace rasterlab {

/// The mesh in the bytes of an OFF file; `file` names it in messages.
///
/// The header is [ST][C][N][4]OFF or missing, the counts follow it or stand on a line of their own.
/// A vertex is x y z [w] [normal] [colour] [u v]. What the header does not announce is recognised
/// by the number of columns, since the OFF files of course C announce nothing: 3 or 4 more numbers
/// are a colour, 2 are u v. Faces may have colours; they count where vertices have none. Faces of
/// one or two corners are left out.
///
/// Binary files: as Geomview defines them (most significant byte first, each face followed by the
/// size of its colour) and as OpenMesh writes them (least significant first, no colours of faces).
///
/// Throws InputError.
Mesh read_off(std::string_view bytes, const std::string& file);

/// Whether bytes begin as an OFF file does.
bool looks_like_off(std::string_view bytes);

}  // namespace rasterlab
