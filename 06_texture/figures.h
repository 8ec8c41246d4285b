// The pictures of stage 06, one function an exercise.
#pragma once

#include "common/stage/run.h"

namespace rasterlab {

void draw_wrap_modes(Run& run);          ///< 06.1
void draw_planet(Run& run);              ///< 06.2
void draw_perspective_ladder(Run& run);  ///< 06.3
void draw_filter_ladder(Run& run);       ///< 06.4

}  // namespace rasterlab
