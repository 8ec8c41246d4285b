// The pictures and printouts of stage 04, one function an exercise.
#pragma once

#include "common/stage/run.h"

namespace rasterlab {

void draw_transforms_in_the_plane(Run& run);  ///< 04.1
void draw_viewports(Run& run);                ///< 04.2
void draw_from_distances(Run& run);           ///< 04.3
void draw_in_perspective(Run& run);           ///< 04.4
void draw_looking_at_things(Run& run);        ///< 04.5
void draw_through_a_pinhole(Run& run);        ///< 04.6
void draw_one_triangle(Run& run);             ///< 04.7
void draw_cube_three_times(Run& run);         ///< 04.8
void draw_clipping_ladder(Run& run);          ///< 04.9
void draw_normals(Run& run);                  ///< 04.10

}  // namespace rasterlab
