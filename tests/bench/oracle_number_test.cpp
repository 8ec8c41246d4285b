// Code for any Number, run on the oracles: the same to a float's precision, so that it is the same
// code; better than a float, so that it is an oracle.
#include "bench/support/oracle_number.h"

#include "common/image/number.h"

#include <gtest/gtest.h>

namespace rasterlab {
namespace {

/// Of all that code for any Number may use. In the namespace where such code is.
template <class Number>
Number mixture(float a, float b) {
  const Vector3<Number> unit = normalized(Vector3<Number>(Number(a), Number(b), Number(1)));
  return power(unit.z(), Number(10)) + log_2(Number(a)) * round_down(Number(7) * unit.x()) +
         magnitude(minimum(unit.y(), Number(0)));
}

}  // namespace

namespace bench {
namespace {

TEST(bench_oracle_number, computes_what_floats_compute_and_better) {
  for (const auto& [a, b] : {std::pair{0.3F, -0.2F}, {1.7F, 0.9F}, {12.0F, -5.0F}}) {
    const double by_float = double{mixture<float>(a, b)};
    const double by_double = mixture<OracleNumber<double>>(a, b).value;
    const auto by_quad = static_cast<double>(mixture<OracleNumber<Quad>>(a, b).value);
    EXPECT_NEAR(by_float, by_double, 1e-5);
    EXPECT_NEAR(by_double, by_quad, 1e-13);
  }
}

}  // namespace
}  // namespace bench
}  // namespace rasterlab
