// Stage 06 as a user runs it on any mesh.
#include "tests/support/both_engines.h"
#include "tests/support/places.h"

#include <string>

#include <gtest/gtest.h>

namespace rasterlab {
namespace {

TEST(stage06_viewer, both_engines_draw_the_same) {
  const std::string planet = source_folder() / "data/planet_color.png";
  for (const char* filter : {"nearest", "bilinear", "mip-mapped", "trilinear", "anisotropic"}) {
    expect_both_engines_draw_the_same(
        "06_texture", {"--mesh", "builtin:uv_sphere:24", "--texture", planet, "--filter", filter,
                       "--eye", "0.9,0.7,0.6", "--size", "200x160"});
  }
  for (const char* shape : {"builtin:cube", "builtin:torus_knot:16"}) {
    expect_both_engines_draw_the_same(
        "06_texture", {"--mesh", shape, "--material", "0.2,0.8,0.6,30", "--size", "200x160"});
  }
}

}  // namespace
}  // namespace rasterlab
