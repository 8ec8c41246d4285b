// Stage 04: from three dimensions to two. The order is that of the lab sheet, README.md.
#include "common/projection/clip.h"
#include "common/stage/ladder.h"
#include "common/stage/stage.h"
#include "common/viewer/viewer.h"

#include "04_projection/any_mesh.h"
#include "04_projection/figures.h"

int main(int argc, char** argv) {
  using namespace rasterlab;
  return run_stage(
      argc, argv,
      {.name = "04_projection",
       .exercises = {{"04.1", &draw_transforms_in_the_plane},
                     {"04.2", &draw_viewports},
                     {"04.3", &draw_from_distances},
                     {"04.4", &draw_in_perspective},
                     {"04.5", &draw_looking_at_things},
                     {"04.6", &draw_through_a_pinhole},
                     {"04.7", &draw_one_triangle},
                     {"04.8", &draw_cube_three_times},
                     {"04.9", &draw_clipping_ladder},
                     {"04.10", &draw_normals}},
       .ladders = {ladder_of("04.9", clip_ladder)},
       .own_inputs = {viewer({.exercise = &draw_any_mesh, .tiled = &draw_any_mesh_tiled})}});
}
