// bench_05_lighting: shading, powers and normalisation.
#include "bench/lighting/normalisation.h"
#include "bench/lighting/powers.h"
#include "bench/lighting/shading_models.h"
#include "bench/support/program.h"

int main(int argc, char** argv) {
  using namespace rasterlab::bench;
  std::vector<MakeLadder> ladders = {&normalisation_ladder};
  for (const int rings : {8, 32})
    ladders.emplace_back([rings] { return shading_ladder_of(rings); });
  for (const int exponent : {1, 4, 16, 64, 256, 1024})
    ladders.emplace_back([exponent] { return power_ladder(exponent); });
  return run_program(argc, argv,
                     {.name = "bench_05_lighting",
                      .description = "Stage 05: time and error of what lighting computes with",
                      .ladders = ladders});
}
