#include "common/projection/look_at.h"

#include "tests/stage04/random_values.h"

#include <cmath>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

using Vector = Eigen::Vector3f;

Vector seen(const Eigen::Matrix4f& view, const Vector& point) {
  return (view * point.homogeneous()).head<3>();
}

testing::AssertionResult is_rigid(const Eigen::Matrix4f& view) {
  const Eigen::Matrix3d rotation = view.topLeftCorner<3, 3>().cast<double>();
  const double off =
      (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  const double determinant = rotation.determinant();
  if (off <= 1e-6 && std::abs(determinant - 1) <= 1e-6 &&
      view.row(3) == Eigen::RowVector4f(0, 0, 0, 1)) {
    return testing::AssertionSuccess();
  }
  return testing::AssertionFailure()
         << "R Rᵀ is off the identity by " << off << ", det R = " << determinant << ":\n"
         << view;
}

TEST(stage04_look_at, the_eye_lands_on_the_origin_and_the_centre_ahead) {
  for (const Vector& center : {Vector(0, 0, 0), Vector(-3, 1, 0.5F), Vector(1, 1, 5)}) {
    const Vector eye(1, 1, 2);
    const Eigen::Matrix4f view = look_at(eye, center, {0, 1, 0});
    EXPECT_TRUE(is_rigid(view));
    EXPECT_LT(seen(view, eye).norm(), 1e-6F)
        << "the translation is −R·eye, whatever the centre is; centre " << center.transpose();
    const Vector ahead(0, 0, -(center - eye).norm());
    EXPECT_LT((seen(view, center) - ahead).norm(), 1e-5F) << "centre " << center.transpose();
  }
}

TEST(stage04_look_at, the_courses_camera) {
  const Eigen::Matrix4f view = look_at({1, 1, 2}, {0, 0, 0}, {0, 1, 0});
  Eigen::Matrix4d expected;
  const double s2 = 1 / std::sqrt(5.0);
  const double s6 = 1 / std::sqrt(6.0);
  const double s30 = 1 / std::sqrt(30.0);
  expected << 2 * s2, 0, -s2, 0,        //
      -s30, 5 * s30, -2 * s30, 0,       //
      s6, s6, 2 * s6, -std::sqrt(6.0),  //
      0, 0, 0, 1;
  EXPECT_LT((view.cast<double>() - expected).cwiseAbs().maxCoeff(), 1e-6) << view;
}

TEST(stage04_look_at, up_is_seen_pointing_up_and_right_stays_right) {
  const Eigen::Matrix4f view = look_at({0, 0, 5}, {0, 0, 0}, {0.2F, 3, 1});
  EXPECT_GT(seen(view, {0.2F, 3, 0}).y(), seen(view, {0, 0, 0}).y());
  EXPECT_GT(seen(view, {1, 0, 0}).x(), 0) << "from +z, with y up, x is on the right: no mirror";
}

TEST(stage04_look_at, rigid_for_any_camera) {
  RandomValues random(405);
  for (int i = 0; i < 10000; ++i) {
    const float size = std::pow(10.0F, random.number(-6, 6));
    const Vector eye = random.vector(size);
    const Vector center = random.vector(size);
    const Vector up = random.vector(1);
    const Eigen::Matrix4f view = look_at(eye, center, up);
    ASSERT_TRUE(is_rigid(view)) << "eye " << eye.transpose() << ", centre " << center.transpose()
                                << ", up " << up.transpose();
    const Eigen::Vector3d translation =
        -(view.topLeftCorner<3, 3>().cast<double>() * eye.cast<double>());
    ASSERT_LT((view.topRightCorner<3, 1>().cast<double>() - translation).norm(),
              1e-6 * static_cast<double>(eye.norm()));
  }
}

TEST(stage04_look_at, up_ever_closer_to_the_line_of_sight) {
  for (int k = 0; k <= 12; ++k) {
    const double angle = std::pow(10.0, -k);
    const Vector forward(0, 0, -1);
    const Vector up(static_cast<float>(std::sin(angle)), 0, static_cast<float>(-std::cos(angle)));
    for (const float sign : {1.0F, -1.0F}) {
      const Eigen::Matrix4f view = look_at({0, 0, 0}, forward, sign * up);
      ASSERT_TRUE(is_rigid(view)) << "angle 1e-" << k;
      if (k <= 6) {
        EXPECT_NEAR(view(1, 0), sign, 1e-6) << "up still says which way; angle 1e-" << k;
      }
      if (k >= 8) {
        EXPECT_TRUE(view.isApprox(look_at({0, 0, 0}, forward, Vector::UnitX())))
            << "the contract's axis instead of up: x, the first of those that the line of sight "
               "leans to least; angle 1e-"
            << k;
      }
    }
  }
}

TEST(stage04_look_at, up_that_says_nothing_is_replaced_by_the_contracts_axis) {
  const Vector eye(3, 2, 1);
  for (const Vector& up : {Vector(0, 0, 0), Vector(3, 2, 1), Vector(-6, -4, -2)}) {
    const Eigen::Matrix4f view = look_at(eye, {0, 0, 0}, up);
    EXPECT_TRUE(is_rigid(view));
    EXPECT_TRUE(view.isApprox(look_at(eye, {0, 0, 0}, Vector::UnitZ()), 1e-6F))
        << "the line of sight (3, 2, 1) leans to z least";
  }
}

TEST(stage04_look_at, an_eye_in_the_centre_looks_along_minus_z) {
  const Eigen::Matrix4f view = look_at({5, 6, 7}, {5, 6, 7}, {0, 1, 0});
  EXPECT_TRUE(is_rigid(view));
  EXPECT_LT((seen(view, {5, 6, 6}) - Vector(0, 0, -1)).norm(), 1e-6F);
}

TEST(stage04_look_at, huge_and_tiny_lengths_do_not_over_or_underflow) {
  EXPECT_TRUE(is_rigid(look_at({0, 0, 1e30F}, {0, 0, -1e30F}, {0, 1e-38F, 0})));
  EXPECT_TRUE(is_rigid(look_at({0, 0, 1e-38F}, {0, 0, 0}, {0, 1e38F, 0})));
}

}  // namespace
}  // namespace rasterlab
