// Stage 04: from three dimensions to two. The order is that of the lab sheet, README.md.
#include "common/stage/stage.h"
#include "common/viewer/viewer.h"

#include "04_projection/any_mesh.h"

int main(int argc, char** argv) {
  using namespace rasterlab;
  return run_stage(argc, argv,
                   {.name = "04_projection",
                    .exercises = {},
                    .own_inputs = {viewer({.exercise = &draw_any_mesh})}});
}
