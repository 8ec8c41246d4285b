// A fixed part of what `./lab stress` draws without end.
#include "common/projection/clip.h"

#include "tests/stress/family.h"
#include "tests/stress/special_floats.h"
#include "tests/support/scratch.h"

#include <bit>
#include <cstring>

#include <gmock/gmock.h>

namespace rasterlab::stress {
namespace {

/// Cases of one seed until so many samples have been compared.
class stress_family : public testing::TestWithParam<Family> {};

TEST_P(stress_family, keeps_its_contract) {
  constexpr std::int64_t enough = 3'000'000;
  constexpr std::uint64_t most_cases = 1500;
  const Family& drawn = GetParam();
  std::int64_t samples = 0;
  for (std::uint64_t i = 0; i < most_cases && samples < enough; ++i) {
    const Numbers numbers = draw(drawn, 1, i);
    const Verdict verdict = check(drawn, numbers);
    samples += verdict.samples;
    ASSERT_EQ(verdict.violations, 0)
        << drawn.contract << "; case " << i << ": " << verdict.first
        << "\nsimplest: " << testing::PrintToString(shrink(drawn, numbers));
  }
  RecordProperty("samples", std::to_string(samples));
  std::printf("%s: %lld samples, 0 violations\n", drawn.name.c_str(),
              static_cast<long long>(samples));
  EXPECT_GT(samples, 1000);
}

std::string name_of(const testing::TestParamInfo<Family>& parameter) {
  return parameter.param.name;
}
INSTANTIATE_TEST_SUITE_P(, stress_family, testing::ValuesIn(families()), name_of);

/// Alone in any component of a triangle, and any two in one corner.
TEST(stress_fixed, every_special_float_in_every_component) {
  const Family& family = family_named("special_floats");
  const Numbers usual = {-1, -1, 0, 1, 1, -1, 0.2, 1, 0, 1, 0.1, 0.7};
  std::int64_t samples = 0;
  const auto check_changed = [&](std::size_t i, float a, std::size_t j, float b) {
    Numbers numbers = usual;
    numbers[i] = a;
    numbers[j] = b;
    const Verdict verdict = check(family, numbers);
    samples += verdict.samples;
    EXPECT_EQ(verdict.violations, 0)
        << a << " in component " << i << ", " << b << " in " << j << ": " << verdict.first;
  };
  for (std::size_t i = 0; i < usual.size(); ++i) {
    for (std::size_t j = i; j < i / 4 * 4 + 4; ++j) {
      for (const float a : special_floats) {
        for (const float b : special_floats) {
          if (i != j || std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b)) {
            check_changed(i, a, j, b);
          }
        }
      }
    }
  }
  std::printf("%lld samples, 0 violations\n", static_cast<long long>(samples));
}

/// Nine corners are left of it, more than a convex polygon has after five planes; the engine had
/// room for eight.
TEST(stress_fixed, a_polygon_that_rounding_has_bent) {
  const Family& family = family_named("beyond_range");
  const Numbers numbers = draw(family, 9784, 1377);
  ClipTriangle triangle;
  for (std::size_t i = 0; i < 12; ++i) {
    triangle[i / 4][static_cast<Eigen::Index>(i % 4)] = static_cast<float>(numbers[i]);
  }
  EXPECT_GT(clip_homogeneous(triangle, guard_band(64, 48)).size(), 8U);
  EXPECT_EQ(check(family, numbers).violations, 0);
}

/// What is left of it reaches so far beyond the far plane that single precision had no number for
/// the depth.
TEST(stress_fixed, a_corner_further_than_any_float) {
  const Numbers numbers = {1, -1.75, 0x1.fffffep+127, 1.625, 0, 0x1p-24, 0, 1, 0, 0, 0, -0x1p+24};
  const Verdict verdict = check(family_named("special_floats"), numbers);
  EXPECT_GT(verdict.samples, 0);
  EXPECT_EQ(verdict.violations, 0);
}

/// The centre of pixel (39, 15) lies on the edge that faces the corner beyond the far plane: its
/// depth is of the other two corners alone.
TEST(stress_fixed, an_edge_that_faces_a_corner_beyond_the_far_plane) {
  const Numbers numbers = {1, 0, 0x1.fffffep+127, 1, 1, 0x1.82d3p+0, 0, 0x1.fc67p+0, 0, 0, 0, 1};
  const Verdict verdict = check(family_named("special_floats"), numbers);
  EXPECT_GT(verdict.samples, 0);
  EXPECT_EQ(verdict.violations, 0);
}

/// Where the first triangle is cut w is 2e-5, and off by a hundredth of that for rounding; the
/// depth there, of −768, decides whether pixel (17, 18) is before the far plane.
TEST(stress_fixed, a_cut_far_beyond_the_far_plane) {
  const Numbers numbers = {-0x1.02p+0,
                           -0x1.4p-2,
                           0x1.dp-4,
                           0x1.0a3a48a5d399ap+0,
                           0x1.dap-1,
                           0x1.4p-2,
                           -0x1.3eeb2de1784p-5,
                           -0x1.e40363a3db2a9p-1,
                           0,
                           0,
                           0,
                           1,
                           0,
                           0,
                           1};
  const Verdict verdict = check(family_named("shared_edges"), numbers);
  EXPECT_GT(verdict.samples, 0);
  EXPECT_EQ(verdict.violations, 0);
}

/// Past the eye w goes from 1.6 to −0.15; of the 3.6e-5 that is left at one corner single precision
/// lost a thousandth, and with it pixel (13, 35), just before the far plane.
TEST(stress_fixed, a_cut_where_w_cancels) {
  const Numbers numbers = {0x1.8p-2,
                           -0x1.39p+0,
                           0x1.8p-3,
                           0x1.1dp+0,
                           -0x1.952p-5,
                           0x1.c318p-3,
                           0x0p+0,
                           -0x1.34a8p-3,
                           -0x1.c03p+13,
                           -0x1.1268p+14,
                           0x0p+0,
                           0x1.ap+0,
                           0,
                           0,
                           1};
  const Verdict verdict = check(family_named("shared_edges"), numbers);
  EXPECT_GT(verdict.samples, 0);
  EXPECT_EQ(verdict.violations, 0);
}

/// "No number is above 100, and none is NaN."
Family toy() {
  return {"toy",
          "numbers stay below 100",
          2,
          1,
          [](Random& random) {
            Numbers numbers;
            for (int i = 0; i < 21; ++i) numbers.push_back(random.number(0, 110));
            return numbers;
          },
          [](const Numbers& numbers, Verdict& verdict) {
            for (const double number : numbers) {
              verdict.expect(number < 100, [&] { return std::to_string(number); });
            }
          }};
}

TEST(stress_runner, finds_and_simplifies_a_violation) {
  const Family family = toy();
  for (std::uint64_t i = 0; i < 100; ++i) {
    const Numbers numbers = draw(family, 3, i);
    if (check(family, numbers).violations == 0) continue;
    const Numbers simplest = shrink(family, numbers);
    EXPECT_GE(check(family, simplest).violations, 1);
    EXPECT_LE(simplest.size(), 3U) << "groups that don't matter are left out";
    return;
  }
  FAIL() << "no violation drawn";
}

TEST(stress_runner, what_is_thrown_is_a_violation) {
  Family family = toy();
  family.check = [](const Numbers&, Verdict&) { throw std::runtime_error("lost"); };
  EXPECT_THAT(check(family, {}).first, testing::HasSubstr("lost"));
}

TEST(stress_runner, same_seed_same_cases) {
  for (const Family& family : families()) {
    EXPECT_EQ(draw(family, 7, 3).size(), draw(family, 7, 3).size()) << family.name;
    const Numbers once = draw(family, 7, 3);
    const Numbers again = draw(family, 7, 3);
    EXPECT_EQ(std::memcmp(once.data(), again.data(), once.size() * sizeof(double)), 0);
  }
}

TEST(stress_runner, a_saved_case_is_read_back_exactly) {
  const ScratchFolder folder;
  const Family& family = families().front();
  const Numbers numbers = {0.1,
                           -0.0,
                           1e300,
                           std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::quiet_NaN(),
                           5e-324};
  save_case(folder / "case.json", family, numbers, {});
  const SavedCase loaded = load_case(folder / "case.json");
  EXPECT_EQ(loaded.family, &family);
  ASSERT_EQ(loaded.numbers.size(), numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (std::isnan(numbers[i])) {
      EXPECT_TRUE(std::isnan(loaded.numbers[i]));
    } else {
      EXPECT_EQ(loaded.numbers[i], numbers[i]);
      EXPECT_EQ(std::signbit(loaded.numbers[i]), std::signbit(numbers[i]));
    }
  }
}

}  // namespace
}  // namespace rasterlab::stress
