// Stage 06: pictures on surfaces, seen in perspective. The order is that of the lab sheet,
// README.md.
#include "common/stage/stage.h"

int main(int argc, char** argv) {
  return rasterlab::run_stage(argc, argv, {.name = "06_texture", .exercises = {}});
}
