// Stage 05: light. The order is that of the lab sheet, README.md.
#include "05_lighting/any_mesh.h"
#include "common/stage/stage.h"
#include "common/viewer/viewer.h"

int main(int argc, char** argv) {
  using namespace rasterlab;
  return run_stage(argc, argv,
                   {.name = "05_lighting",
                    .exercises = {},
                    .own_inputs = {viewer({.exercise = &draw_any_mesh, .lit = true})}});
}
