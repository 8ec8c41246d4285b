// Stage 05: light. The order is that of the lab sheet, README.md.
#include "common/lighting/shading.h"
#include "common/lighting/turned_light.h"
#include "common/stage/ladder.h"
#include "common/stage/stage.h"
#include "common/viewer/viewer.h"

#include "05_lighting/any_mesh.h"
#include "05_lighting/figures.h"

int main(int argc, char** argv) {
  using namespace rasterlab;
  return run_stage(argc, argv,
                   {.name = "05_lighting",
                    .exercises = {{"05.1", &draw_vertex_normals},
                                  {"05.2", &draw_phong_parts},
                                  {"05.3", &draw_blinn_phong},
                                  {"05.4", &draw_lit_mesh},
                                  {"05.5", &draw_shading_ladder},
                                  {"05.6", &draw_light_going_round},
                                  {"05.7", &draw_culling},
                                  {"05.8", &draw_specular_powers}},
                    .ladders = {ladder_of("05.5", shading_ladder)},
                    .own_inputs = {viewer({.exercise = &draw_any_mesh,
                                           .tiled = &draw_any_mesh_tiled,
                                           .turn_light = &turned_light})}});
}
