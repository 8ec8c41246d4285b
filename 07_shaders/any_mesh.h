// How stage 07 draws a mesh it knows nothing of, for --mesh and --scene, by any shader of its list.
#pragma once

#include "common/viewer/viewer.h"

namespace rasterlab {

/// The shaders, filters, ways to wrap and instruction sets there are.
ViewerOptions viewer_options();

}  // namespace rasterlab
