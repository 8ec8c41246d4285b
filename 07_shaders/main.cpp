// Stage 07: programs for pixels. The order is that of the lab sheet, README.md.
#include "common/stage/stage.h"
#include "common/viewer/viewer.h"

#include "07_shaders/any_mesh.h"
#include "07_shaders/figures.h"

int main(int argc, char** argv) {
  using namespace rasterlab;
  return run_stage(argc, argv,
                   {.name = "07_shaders",
                    .exercises = {{"07.1", &draw_with_holes},
                                  {"07.2", &draw_four_simple_shaders},
                                  {"07.3", &draw_quantized},
                                  {"07.4", &draw_normal_maps},
                                  {"07.5", &draw_culled_sides},
                                  {"07.6", &draw_four_phong_shaders},
                                  {"07.7", &draw_turning_light},
                                  {"07.8", &draw_phong_per_fragment}},
                    .own_inputs = {viewer(viewer_options())}});
}
