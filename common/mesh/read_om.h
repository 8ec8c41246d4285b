// Reading OM files, OpenMesh's own format.
#pragma once

#include "common/mesh/mesh.h"

#include <string>
#include <string_view>

namespace rasterlab {

/// The mesh in the bytes of an OM file; `file` names it in messages. OpenMesh reads it. OpenMesh
/// trusts what it reads, so the sizes of the parts are checked before, and the links between
/// half-edges on the way.
///
/// Throws InputError.
Mesh read_om(std::string_view bytes, const std::string& file);

/// Whether bytes begin as an OM file does.
bool looks_like_om(std::string_view bytes);

}  // namespace rasterlab
