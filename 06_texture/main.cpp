// Stage 06: pictures on surfaces, seen in perspective. The order is that of the lab sheet,
// README.md.
#include "common/lighting/turned_light.h"
#include "common/stage/ladder.h"
#include "common/stage/stage.h"
#include "common/texture/perspective_ladder.h"
#include "common/texture/sample.h"
#include "common/viewer/viewer.h"

#include "06_texture/any_mesh.h"
#include "06_texture/figures.h"

namespace {

rasterlab::Choices filter_choices() {
  rasterlab::Choices choices;
  for (const auto& rung : rasterlab::filter_ladder()) {
    choices.push_back({rung.name, rung.known_fault});
  }
  return with_default(choices, "trilinear");
}

rasterlab::Choices wrap_choices() {
  rasterlab::Choices choices;
  for (const auto& mode : rasterlab::wrap_modes()) choices.push_back({mode.name, mode.description});
  return choices;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace rasterlab;
  return run_stage(
      argc, argv,
      {.name = "06_texture",
       .exercises = {{"06.1", &draw_wrap_modes},
                     {"06.2", &draw_planet},
                     {"06.3", &draw_perspective_ladder},
                     {"06.4", &draw_filter_ladder}},
       .ladders = {ladder_of("06.3", perspective_ladder()), ladder_of("06.4", filter_ladder())},
       .own_inputs = {viewer({.exercise = &draw_any_mesh,
                              .tiled = &draw_any_mesh_tiled,
                              .turn_light = &turned_light,
                              .textured = true,
                              .filters = filter_choices(),
                              .wraps = wrap_choices(),
                              .skips = texture_skips()})}});
}
