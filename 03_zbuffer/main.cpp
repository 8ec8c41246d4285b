// Stage 03: what is in front of what. The order is that of the lab sheet, README.md.
#include "common/stage/ladder.h"
#include "common/stage/stage.h"
#include "common/zbuffer/visibility.h"

#include "03_zbuffer/figures.h"
#include "03_zbuffer/own_triangles.h"

int main(int argc, char** argv) {
  using namespace rasterlab;
  return run_stage(argc, argv,
                   {.name = "03_zbuffer",
                    .exercises = {{"03.1", &show_depth_buffer},
                                  {"03.2", &draw_points},
                                  {"03.3", &draw_segments},
                                  {"03.4", &draw_interpenetrating},
                                  {"03.5", &draw_visibility_ladder},
                                  {"03.6", &draw_bunny_with_depth}},
                    .ladders = {ladder_of("03.5", visibility_ladder)},
                    .own_inputs = {own_triangles()}});
}
