// How stage 04 draws a mesh it knows nothing of, for --mesh and --scene.
#pragma once

#include "common/viewer/viewer.h"

namespace rasterlab {

/// Vertex colours where the mesh has them. Without light yet, a mesh of one colour would be a mere
/// outline: its faces are the brighter the more they face the camera.
DrawFrame draw_any_mesh(const Subject& subject);

/// The same by the engine: the same pixels, their colours within one code value.
DrawFrame draw_any_mesh_tiled(const Subject& subject);

}  // namespace rasterlab
