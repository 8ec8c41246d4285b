#include "common/lighting/blinn_phong.h"
#include "common/lighting/phong.h"

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

using Vector = Eigen::Vector3f;

const Material course = {.ambient = 0.2F, .diffuse = 0.8F, .specular = 0.6F, .shininess = 128};

TEST(stage05_phong, seen_and_lit_straight_on_is_ambient_plus_diffuse_plus_specular) {
  const Vector z(0, 0, 1);
  const Reflection<float> reflection = phong<float>(z, z, z, Light{}, course);
  EXPECT_FLOAT_EQ(reflection.ambient, 0.2F);
  EXPECT_FLOAT_EQ(reflection.diffuse, 0.8F);
  EXPECT_FLOAT_EQ(reflection.specular, 0.6F);
}

}  // namespace
}  // namespace rasterlab
