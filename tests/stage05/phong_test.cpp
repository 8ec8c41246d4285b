#include "common/lighting/phong.h"

#include "common/image/pixel.h"
#include "common/lighting/blinn_phong.h"

#include <cmath>
#include <random>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

using Vector = Eigen::Vector3f;

const Material course = {.ambient = 0.2F, .diffuse = 0.8F, .specular = 0.6F, .shininess = 128};
const Vector z(0, 0, 1);

// A unit vector in the plane y = 0, so many degrees from +z toward +x.
Vector at(double degrees) {
  const double angle = degrees * 3.14159265358979323846 / 180;
  return Eigen::Vector3d(std::sin(angle), 0, std::cos(angle)).cast<float>();
}

using Model = Reflection<float> (*)(const Vector&, const Vector&, const Vector&, const Light&,
                                    const Material&);

// The same formulas in double precision, written down anew.
Reflection<double> truth(bool blinn, const Vector& normal, const Vector& to_light,
                         const Vector& to_eye, const Light& light, const Material& material) {
  const Eigen::Vector3d n = normal.cast<double>();
  const Eigen::Vector3d l = to_light.cast<double>();
  const Eigen::Vector3d e = to_eye.cast<double>();
  const Eigen::Vector3d mirrored = 2 * n.dot(l) * n - l;
  const double cosine = blinn ? n.dot((l + e).normalized()) : mirrored.dot(e);
  const bool shines = n.dot(l) > 0 && cosine > 0;
  return {static_cast<double>(light.ambient_intensity) * static_cast<double>(material.ambient),
          static_cast<double>(light.intensity) * static_cast<double>(material.diffuse) *
              std::max(n.dot(l), 0.0),
          shines ? static_cast<double>(light.intensity) * static_cast<double>(material.specular) *
                       std::pow(cosine, static_cast<double>(material.shininess))
                 : 0};
}

void expect_truth(bool blinn, Model model) {
  std::mt19937 engine(52);
  std::normal_distribution<float> normal;
  const auto direction = [&] {
    const float x = normal(engine);
    const float y = normal(engine);
    return Vector(x, y, normal(engine)).normalized();
  };
  const Light light{.intensity = 0.7F, .ambient_intensity = 0.9F};
  for (int i = 0; i < 20000; ++i) {
    const Vector n = direction();
    const Vector l = direction();
    const Vector e = direction();
    Material material = course;
    material.shininess = static_cast<float>(i % 200);
    const Reflection<float> actual = model(n, l, e, light, material);
    const Reflection<double> expected = truth(blinn, n, l, e, light, material);
    ASSERT_NEAR(actual.ambient, expected.ambient, 1e-6);
    ASSERT_NEAR(actual.diffuse, expected.diffuse, 1e-6);
    // With shininess 0 the highlight has an edge, where rounding decides.
    const bool at_edge =
        material.shininess < 1 &&
        std::min(std::abs(n.dot(l)), std::abs(n.dot((l + e).normalized()))) < 1e-5F;
    if (!at_edge) {
      ASSERT_NEAR(actual.specular, expected.specular, 3e-5) << "shininess " << material.shininess;
    }
  }
}

TEST(stage05_phong, is_the_formula) {
  expect_truth(false, &phong<float>);
}

TEST(stage05_phong, seen_and_lit_straight_on_is_ambient_plus_diffuse_plus_specular) {
  const Reflection<float> reflection = phong<float>(z, z, z, Light{}, course);
  EXPECT_FLOAT_EQ(reflection.ambient, 0.2F);
  EXPECT_FLOAT_EQ(reflection.diffuse, 0.8F);
  EXPECT_FLOAT_EQ(reflection.specular, 0.6F);
}

TEST(stage05_phong, the_highlight_is_where_the_light_is_mirrored_to_the_eye) {
  EXPECT_NEAR(phong<float>(z, at(30), at(-30), Light{}, course).specular, 0.6F, 1e-4);
  EXPECT_LT(phong<float>(z, at(30), at(30), Light{}, course).specular, 1e-6F)
      << "not where the eye is beside the light";
}

TEST(stage05_phong, diffuse_light_falls_off_with_the_cosine_and_stops_at_0) {
  EXPECT_NEAR(phong<float>(z, at(60), z, Light{}, course).diffuse, 0.4F, 1e-6);
  for (const double degrees : {90.001, 120.0, 180.0}) {
    EXPECT_EQ(phong<float>(z, at(degrees), z, Light{}, course).diffuse, 0)
        << "clamped before it is added: light from behind takes nothing away";
  }
}

TEST(stage05_phong, a_back_lit_surface_mirrors_nothing) {
  // r is (sin −120°, cos −120°)… toward −z: seen from there r·e is 1.
  for (const float shininess : {0.0F, 1.0F, 2.0F, 128.0F}) {
    Material material = course;
    material.shininess = shininess;
    EXPECT_EQ(phong<float>(z, at(120), at(-120), Light{}, material).specular, 0) << shininess;
  }
}

TEST(stage05_phong, an_even_power_of_a_negative_cosine_is_no_highlight) {
  // Lit from 60° on one side, seen from 60° on the same side: r·e = cos 120° = −½.
  for (const float shininess : {0.0F, 2.0F, 4.0F, 128.0F}) {
    Material material = course;
    material.shininess = shininess;
    EXPECT_EQ(phong<float>(z, at(60), at(60), Light{}, material).specular, 0) << shininess;
  }
}

TEST(stage05_phong, power_0_shines_wherever_it_mirrors_at_all) {
  Material material = course;
  material.shininess = 0;
  EXPECT_FLOAT_EQ(phong<float>(z, at(40), at(20), Light{}, material).specular, 0.6F);
}

TEST(stage05_phong, a_surface_without_a_normal_gets_ambient_light_alone) {
  const Reflection<float> reflection = phong<float>({0, 0, 0}, z, z, Light{}, course);
  EXPECT_FLOAT_EQ(reflection.ambient, 0.2F);
  EXPECT_EQ(reflection.diffuse, 0);
  EXPECT_EQ(reflection.specular, 0);
}

TEST(stage05_phong, intensities_scale_their_own_parts) {
  const Light light{.intensity = 0.5F, .ambient_intensity = 3};
  const Reflection<float> reflection = phong<float>(z, z, z, light, course);
  EXPECT_FLOAT_EQ(reflection.ambient, 0.6F);
  EXPECT_FLOAT_EQ(reflection.diffuse, 0.4F);
  EXPECT_FLOAT_EQ(reflection.specular, 0.3F);
}

TEST(stage05_phong, huge_powers_neither_overflow_nor_become_no_number) {
  Material material = course;
  material.shininess = 1e6F;
  EXPECT_FLOAT_EQ(phong<float>(z, z, z, Light{}, material).specular, 0.6F);
  EXPECT_EQ(phong<float>(z, at(5), z, Light{}, material).specular, 0);
}

TEST(stage05_blinn_phong, is_the_formula) {
  expect_truth(true, &blinn_phong<float>);
}

TEST(stage05_blinn_phong, the_highlight_is_where_the_normal_is_half_way) {
  EXPECT_NEAR(blinn_phong<float>(z, at(30), at(-30), Light{}, course).specular, 0.6F, 1e-4);
}

TEST(stage05_blinn_phong, is_wider_than_phongs_the_angle_being_half) {
  Material material = course;
  for (const double off : {5.0, 10.0, 20.0}) {
    material.shininess = 10;
    const float blinn = blinn_phong<float>(z, z, at(off), Light{}, material).specular;
    EXPECT_GT(blinn, phong<float>(z, z, at(off), Light{}, material).specular);
    EXPECT_NEAR(blinn, phong<float>(z, z, at(off / 2), Light{}, material).specular, 1e-5);
  }
}

TEST(stage05_blinn_phong, a_back_lit_surface_mirrors_nothing) {
  for (const float shininess : {0.0F, 2.0F, 128.0F}) {
    Material material = course;
    material.shininess = shininess;
    EXPECT_EQ(blinn_phong<float>(z, at(100), at(-20), Light{}, material).specular, 0)
        << "though the half vector is in front; shininess " << shininess;
  }
}

TEST(stage05_blinn_phong, light_and_eye_in_opposite_directions_have_no_half_way) {
  const Reflection<float> reflection =
      blinn_phong<float>(z, at(80), -at(80), Light{}, {.shininess = 0});
  EXPECT_EQ(reflection.specular, 0);
  EXPECT_GT(reflection.diffuse, 0);
}

TEST(stage05_direction_to, a_light_near_by_and_one_at_infinity) {
  EXPECT_LT((direction_to<float>({3, 0, 4, 1}, {0, 0, 0}) - Vector(0.6F, 0, 0.8F)).norm(), 1e-6F);
  EXPECT_LT((direction_to<float>({3, 0, 4, 1}, {3, 0, 0}) - z).norm(), 1e-6F);
  EXPECT_LT((direction_to<float>({6, 0, 8, 2}, {3, 0, 0}) - z).norm(), 1e-6F)
      << "(6, 0, 8)/2 is the same point";
  for (const Vector& from : {Vector(0, 0, 0), Vector(100, -50, 3)}) {
    EXPECT_LT((direction_to<float>({3, 0, 4, 0}, from) - Vector(0.6F, 0, 0.8F)).norm(), 1e-6F)
        << "at infinity it is in the same direction from everywhere";
  }
  EXPECT_TRUE(direction_to<float>({1, 2, 3, 1}, {1, 2, 3}).isZero(0)) << "in the light itself";
}

TEST(stage05_lit, colour_takes_ambient_and_diffuse_and_the_highlight_is_white) {
  const Color color(1, 0.5F, 0);
  EXPECT_LT((lit<float>(color, {0.25F, 0.25F, 0.125F}) - Color(0.625F, 0.375F, 0.125F)).norm(),
            1e-6F)
      << "channel by channel";
}

TEST(stage05_lit, what_is_brighter_than_white_is_white_and_does_not_wrap) {
  const Color color = lit<float>({1, 0.9F, 0.1F}, {0.5F, 1, 0.6F});
  EXPECT_EQ(color, Color(1, 1, 0.75F));
  EXPECT_EQ(to_rgb8(Color(1.3F, 2, 100)), (Rgb8{255, 255, 255}));
}

}  // namespace
}  // namespace rasterlab
