// Stage 07: programs for pixels. The order is that of the lab sheet, README.md.
#include "common/stage/stage.h"

#include "07_shaders/any_mesh.h"

int main(int argc, char** argv) {
  using namespace rasterlab;
  return run_stage(
      argc, argv,
      {.name = "07_shaders", .exercises = {}, .own_inputs = {viewer(viewer_options())}});
}
