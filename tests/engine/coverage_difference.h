// Where the engine covers other pixels than the exercise code, and whose fault it is.
#pragma once

#include "common/engine/renderer.h"
#include "common/mesh/mesh.h"

#include <string>

namespace rasterlab {

/// Pixels a side of the square pictures that are compared.
inline constexpr int coverage_side = 256;

/// Whether the engine shows another triangle somewhere than the exercise code, which shows the
/// first that covers a pixel: each triangle must be flat and in front of those after it. Positions
/// are in NDC.
bool coverage_differs(const Mesh& mesh, Renderer& renderer);

/// The one triangle whose coverage differs, found by halving, with its positions.
std::string culprit(const Mesh& mesh, Renderer& renderer);

}  // namespace rasterlab
