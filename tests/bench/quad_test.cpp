// The oracle of the benchmarks, against cpp_bin_float with 50 digits.
#include "bench/support/quad.h"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

namespace rasterlab::bench {
namespace {

using Wide = boost::multiprecision::cpp_bin_float_50;

/// Exactly: as the sum of three doubles.
Wide wide(Quad value) {
  Wide sum = 0;
  for (int i = 0; i < 3; ++i) {
    const auto part = static_cast<double>(value);
    sum += part;
    value -= part;
  }
  return sum;
}

double relative_error(Quad computed, const Wide& exact) {
  return static_cast<double>(abs(wide(computed) / exact - 1));
}

constexpr double few_last_places = 0x1p-109;

TEST(bench_quad, roots_powers_and_logarithms_are_right_to_a_few_last_places) {
  for (const double x : {1e-30, 0.003, 0.4999, 0.75, 1.0000001, 1.4142, 3.0, 65536.5, 1e20}) {
    EXPECT_LT(relative_error(quad_sqrt(x), sqrt(Wide(x))), few_last_places) << x;
    EXPECT_LT(relative_error(quad_power(x, 7), pow(Wide(x), 7)), few_last_places) << x;
    EXPECT_LT(relative_error(quad_log2(x), log2(Wide(x))), few_last_places) << x;
  }
  for (const double x : {-40.25, -1.0, -1e-9, 0.0, 0.3, 1.0, 17.75}) {
    EXPECT_LT(relative_error(quad_exp2(x), pow(Wide(2), Wide(x))), few_last_places) << x;
    EXPECT_EQ(static_cast<double>(quad_floor(x)), std::floor(x));
  }
}

TEST(bench_quad, a_figure_counts_only_where_both_oracles_agree_to_a_thousandth) {
  EXPECT_EQ(agreed(1.0009, 1), 1);
  EXPECT_TRUE(std::isnan(agreed(1.0011, 1)));
  EXPECT_EQ(agreed(0, 0), 0);
  EXPECT_TRUE(std::isnan(agreed(1e-20, 0)));
  EXPECT_EQ(agreed(-3.001, -3), -3);
}

TEST(bench_quad, an_error_below_what_doubles_can_tell_is_none_that_counts) {
  const double third = 1.0 / 3;
  MeasuredError of_float;
  of_float.add(double{1.0F / 3} - third, Quad{1.0F / 3} - Quad{1} / 3);
  EXPECT_GT(of_float.largest(), 1e-9);
  MeasuredError of_double;
  of_double.add(third - third, Quad{third} - Quad{1} / 3);
  EXPECT_TRUE(std::isnan(of_double.largest()));
  EXPECT_TRUE(std::isnan(of_double.root_mean_square()));
}

TEST(bench_quad, errors_come_to_their_largest_mean_and_root_mean_square) {
  MeasuredError errors;
  for (const double error : {3.0, -4.0, 0.0, 0.0}) errors.add(error, Quad{error});
  EXPECT_EQ(errors.largest(), 4);
  EXPECT_EQ(errors.mean(), 1.75);
  EXPECT_EQ(errors.root_mean_square(), 2.5);
}

}  // namespace
}  // namespace rasterlab::bench
