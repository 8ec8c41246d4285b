// bench_04_projection: clipping, matrices far from the origin, and normals under uneven scales.
#include "bench/projection/clipping.h"
#include "bench/projection/matrix_chain.h"
#include "bench/projection/normals.h"
#include "bench/support/program.h"

int main(int argc, char** argv) {
  using namespace rasterlab::bench;
  std::vector<MakeLadder> ladders;
  for (const double extent : {1e1, 1e3, 1e5})
    ladders.emplace_back([extent] { return clipping_ladder(extent); });
  for (const double distance : {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7})
    ladders.emplace_back([distance] { return matrix_chain_ladder(distance); });
  for (const double unevenness : {1.0, 10.0, 1000.0})
    ladders.emplace_back([unevenness] { return normal_ladder(unevenness); });
  return run_program(
      argc, argv,
      {.name = "bench_04_projection",
       .description = "Stage 04: time and error of clipping, and of the numbers that "
                      "transforms are computed in",
       .ladders = ladders});
}
