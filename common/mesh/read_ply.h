// Reading PLY files, text and binary of either byte order.
#pragma once

#include "common/mesh/mesh.h"

#include <string>
#include <string_view>

namespace rasterlab {

/// The mesh in the bytes of a PLY file; `file` names it in messages.
///
/// Read are, of any number type and in any order: of a vertex x y z, nx ny nz, red green blue (also
/// r g b, diffuse_red …), and texture coordinates under their usual names (u v, s t, texture_u …);
/// of a face the list vertex_indices (vertex_index), red green blue, and the list texcoord, u v of
/// each corner. Colours of a whole number type are divided by its largest value. Other elements and
/// properties are passed over. Faces of one or two corners are left out.
///
/// Throws InputError.
Mesh read_ply(std::string_view bytes, const std::string& file);

}  // namespace rasterlab
