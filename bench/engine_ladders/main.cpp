// bench_engine_ladders: how coarse a mesh may be.
#include "bench/engine_ladders/level_of_detail.h"
#include "bench/support/program.h"

int main(int argc, char** argv) {
  using namespace rasterlab::bench;
  std::vector<MakeLadder> ladders;
  for (const int pixels : {64, 360})
    ladders.emplace_back([pixels] { return level_of_detail_ladder(pixels); });
  return run_program(argc, argv,
                     {.name = "bench_engine_ladders",
                      .description = "The engine: time and error of levels of detail",
                      .ladders = ladders});
}
