// The pictures of stage 04 against the ray caster: which face each pixel shows and how far it is.
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
  for (const GeometryCase& geometry : foreign_cases()) {
    SCOPED_TRACE(geometry.mesh);
    expect_geometry("04_projection", geometry);
  }
}

}  // namespace
}  // namespace rasterlab::oracle
