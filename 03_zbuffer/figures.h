// The pictures and printouts of stage 03, one function an exercise.
#pragma once

#include "common/stage/run.h"

namespace rasterlab {

void show_depth_buffer(Run& run);       ///< 03.1
void draw_points(Run& run);             ///< 03.2
void draw_segments(Run& run);           ///< 03.3
void draw_interpenetrating(Run& run);   ///< 03.4
void draw_visibility_ladder(Run& run);  ///< 03.5
void draw_bunny_with_depth(Run& run);   ///< 03.6

}  // namespace rasterlab
