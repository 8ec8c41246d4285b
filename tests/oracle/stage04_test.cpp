// The pictures of stage 04 against the ray caster: which face each pixel shows and how far it is.
#include "common/mesh/read_mesh.h"

#include "tests/oracle/geometry_cases.h"

#include <gtest/gtest.h>

namespace rasterlab::oracle {
namespace {

class stage04_witness_of : public testing::TestWithParam<GeometryCase> {};

TEST_P(stage04_witness_of, sees_the_same) {
  expect_geometry("04_projection", GetParam());
}

INSTANTIATE_TEST_SUITE_P(, stage04_witness_of, testing::ValuesIn(built_in_cases()),
                         case_name<testing::TestParamInfo<GeometryCase>>);

TEST(stage04_witness, sees_the_same_of_models_no_one_here_wrote) {
  int drawn = 0;
  for (const GeometryCase& geometry : foreign_cases()) {
    SCOPED_TRACE(geometry.mesh);
    drawn += expect_geometry("04_projection", geometry).drawn;
  }
  EXPECT_GT(drawn, 10000);
}

TEST(stage04_witness, is_not_easily_satisfied) {
  const Viewpoint here;
  const Picture picture = take_picture("04_projection", "builtin:torus", 96, 72, here.flags());
  Viewpoint beside = here;
  beside.eye.x() += 0.004;  // about a tenth of a pixel
  for (const Viewpoint& viewpoint : {here, beside}) {
    const RayCaster witness(read_mesh("builtin:torus"), viewpoint.camera(96, 72), 96, 72);
    const Agreement agreement = compare_geometry(witness, picture);
    EXPECT_EQ(agreement.wrong > 500, viewpoint.eye != here.eye) << agreement;
  }
}

}  // namespace
}  // namespace rasterlab::oracle
