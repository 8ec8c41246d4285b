// bench_06_texture: texture coordinates in perspective, and filters.
#include "bench/support/program.h"
#include "bench/texture/attributes.h"
#include "bench/texture/filters.h"
#include "bench/texture/perspective.h"

int main(int argc, char** argv) {
  using namespace rasterlab::bench;
  std::vector<MakeLadder> ladders;
  for (const double w_ratio : {4.0, 100.0}) {
    ladders.emplace_back([w_ratio] { return perspective_ladder_of(w_ratio); });
    ladders.emplace_back([w_ratio] { return affine_run_ladder(w_ratio); });
    ladders.emplace_back([w_ratio] { return attribute_ladder(w_ratio); });
  }
  for (const TextureView view : {TextureView::near_by, TextureView::far_off, TextureView::grazing})
    ladders.emplace_back([view] { return filter_ladder_of(view); });
  return run_program(argc, argv,
                     {.name = "bench_06_texture",
                      .description = "Stage 06: time and error of texture coordinates and filters",
                      .ladders = ladders});
}
