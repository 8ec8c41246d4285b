// How stage 06 draws a mesh it knows nothing of, for --mesh and --scene.
#pragma once

#include "common/viewer/viewer.h"

namespace rasterlab {

/// Lit at every pixel, with the texture where one was given, else in the mesh's colours. Throws
/// InputError when there is a texture but the mesh says not where it lies.
DrawFrame draw_any_mesh(const Subject& subject);

/// The same by the engine: the same pixels, their colours within one code value.
DrawFrame draw_any_mesh_tiled(const Subject& subject);

/// What either leaves out unless the subject says otherwise: levels of a texture that the filter
/// doesn't read.
Choices texture_skips();

}  // namespace rasterlab
