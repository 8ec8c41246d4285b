// Stage 01: from a single pixel to the wireframe of a mesh. The order is that of the lab sheet, README.md.
#include "common/stage/stage.h"

int main(int argc, char** argv) { return rasterlab::run_stage(argc, argv, {.name = "01_lines", .exercises = {}}); }
