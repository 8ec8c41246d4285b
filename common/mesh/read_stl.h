// Reading STL files, text and binary.
#pragma once

#include "common/mesh/mesh.h"

#include <string>
#include <string_view>

namespace rasterlab {

/// The mesh in the bytes of an STL file; `file` names it in messages. Corners at the same position
/// are one vertex. The normals of the faces are passed over: they follow from the corners.
///
/// A file is binary when it has the size its count promises, whatever it begins with.
///
/// Throws InputError.
Mesh read_stl(std::string_view bytes, const std::string& file);

/// Whether bytes begin as an STL text does, or have exactly the size that a binary one promises.
bool looks_like_stl(std::string_view bytes);

}  // namespace rasterlab
