// The pictures of stage 05, one function an exercise.
#pragma once

#include "common/stage/run.h"

namespace rasterlab {

void draw_vertex_normals(Run& run);     ///< 05.1
void draw_phong_parts(Run& run);        ///< 05.2
void draw_blinn_phong(Run& run);        ///< 05.3
void draw_lit_mesh(Run& run);           ///< 05.4
void draw_shading_ladder(Run& run);     ///< 05.5
void draw_light_going_round(Run& run);  ///< 05.6
void draw_culling(Run& run);            ///< 05.7
void draw_specular_powers(Run& run);    ///< 05.8

}  // namespace rasterlab
