// The pictures of stage 07, one function an exercise.
#pragma once

#include "common/stage/run.h"

namespace rasterlab {

void draw_with_holes(Run& run);           ///< 07.1
void draw_four_simple_shaders(Run& run);  ///< 07.2
void draw_quantized(Run& run);            ///< 07.3
void draw_normal_maps(Run& run);          ///< 07.4
void draw_culled_sides(Run& run);         ///< 07.5
void draw_four_phong_shaders(Run& run);   ///< 07.6
void draw_turning_light(Run& run);        ///< 07.7
void draw_phong_per_fragment(Run& run);   ///< 07.8

}  // namespace rasterlab
