// Stage 07: programs for pixels. The order is that of the lab sheet, README.md.
#include "common/stage/stage.h"

int main(int argc, char** argv) {
  return rasterlab::run_stage(argc, argv, {.name = "07_shaders", .exercises = {}});
}
