#include "common/stage/stage.h"

int main(int argc, char** argv) { return rasterlab::run_stage(argc, argv, {.name = "03_zbuffer", .exercises = {}}); }
