// Reading Wavefront OBJ files.
#pragma once

#include "common/mesh/mesh.h"

#include <string>
#include <string_view>

namespace rasterlab {

/// The mesh in the text of an OBJ file; `file` names it in messages.
///
/// Read are v (with the colour that some write after x y z), vt, vn and f; indices may be negative,
/// lines continued by
/// `\`. All else, materials and groups among it, is passed over. Faces of one or two corners are
/// left out.
///
/// Throws InputError: a number that is none, a face without corners or with an index that is out of
/// range.
Mesh read_obj(std::string_view text, const std::string& file);

}  // namespace rasterlab
