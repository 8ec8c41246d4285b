// How stage 05 draws a mesh it knows nothing of, for --mesh and --scene.
#pragma once

#include "common/viewer/viewer.h"

namespace rasterlab {

/// Phong's reflection at every vertex, interpolated (A.Q31). Normals the file does not give are
/// those of exercise 05.1.
DrawFrame draw_any_mesh(const Subject& subject);

/// The same by the engine: the same pixels, their colours within one code value.
DrawFrame draw_any_mesh_tiled(const Subject& subject);

}  // namespace rasterlab
