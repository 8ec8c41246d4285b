// bench_07_shaders: how a fragment shader is called.
#include "bench/shaders/shading_calls.h"
#include "bench/support/program.h"

int main(int argc, char** argv) {
  using namespace rasterlab::bench;
  return run_program(argc, argv,
                     {.name = "bench_07_shaders",
                      .description = "Stage 07: time and error of ways to call a shader",
                      .ladders = {&flat_call_ladder, &phong_call_ladder}});
}
