#include "common/image/files.h"
#include "common/projection/rotation.h"
#include "common/projection/viewport.h"
#include "common/shaders/shaders.h"

#include "tests/stage07/scene.h"
#include "tests/support/places.h"
#include "tests/support/toy_lanes.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace rasterlab {
namespace {

using Vector = Eigen::Vector3f;

Eigen::Vector3d random_direction(std::mt19937& random) {
  std::normal_distribution<double> value;
  Eigen::Vector3d direction(value(random), value(random), value(random));
  return direction.normalized();
}

double error(const Vector& actual, const Eigen::Vector3d& expected) {
  return (actual.cast<double>() - expected).norm();
}

TEST(stage07_normal_from_tangent_space, blue_alone_is_the_surfaces_own_normal) {
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d normal = random_direction(random);
    const Vector tangent = random_direction(random).cast<float>();
    for (const double length : {0.01, 0.6, 1.0}) {  // mixed between corners, it is shorter
      const Vector mixed = (length * normal).cast<float>();
      const Vector result = normal_from_tangent_space<float>({0, 0, 1}, mixed, tangent, 1);
      EXPECT_LE(error(result, normal), 1e-6);
    }
  }
}

TEST(stage07_normal_from_tangent_space, red_goes_with_u_green_with_v_blue_with_the_normal) {
  std::mt19937 random(2);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d normal = random_direction(random);
    const Eigen::Vector3d along_u = normal.cross(random_direction(random)).normalized();
    const double handedness = i % 2 == 0 ? 1 : -1;
    const Eigen::Vector3d along_v = handedness * normal.cross(along_u);
    const Eigen::Vector3d local = random_direction(random);
    // The face's tangent leans toward the mixed normal and is no unit vector any more.
    const Eigen::Vector3d tangent = 1.7 * (along_u + 0.6 * normal);
    const Vector result =
        normal_from_tangent_space<float>(local.cast<float>(), (0.8 * normal).cast<float>(),
                                         tangent.cast<float>(), static_cast<float>(handedness));
    const Eigen::Vector3d expected = local.x() * along_u + local.y() * along_v + local.z() * normal;
    EXPECT_LE(error(result, expected), 2e-6)
        << "got " << result.transpose() << ", expected " << expected.transpose() << ", handedness "
        << handedness;
  }
}

TEST(stage07_normal_from_tangent_space, is_of_unit_length_though_texels_are_not) {
  const Vector result =
      normal_from_tangent_space<float>({0.2F, -0.1F, 0.4F}, {0, 0.5F, 0}, {0.3F, 0, 0}, 1);
  EXPECT_NEAR(result.norm(), 1, 1e-6);
}

TEST(stage07_normal_from_tangent_space, degenerate_axes_count_for_nothing) {
  const Vector up(0, 0, 1);
  const Vector parallel = normal_from_tangent_space<float>({0.5F, 0.5F, 0.5F}, up, up, 1);
  EXPECT_LE((parallel - up).norm(), 1e-6F) << "a tangent along the normal";
  const Vector no_tangent = normal_from_tangent_space<float>({0.5F, 0.5F, -0.5F}, up, {0, 0, 0}, 1);
  EXPECT_LE((no_tangent + up).norm(), 1e-6F) << "a zero tangent";
  const Vector no_normal =
      normal_from_tangent_space<float>({0.5F, 0.5F, 0.5F}, {0, 0, 0}, {0, 2, 0}, 1);
  EXPECT_LE((no_normal - Vector(0, 1, 0)).norm(), 1e-6F) << "a zero normal";
  EXPECT_EQ(normal_from_tangent_space<float>({0.5F, 0.5F, 0.5F}, {0, 0, 0}, {0, 0, 0}, 1),
            Vector(0, 0, 0));
}

TEST(stage07_normal_maps, a_color_stands_for_twice_itself_less_one) {
  EXPECT_EQ(vector_of_color<float>({0, 0.5F, 1}), Vector(-1, 0, 1));
  EXPECT_EQ(vector_of_color<float>({0.25F, 0.75F, 0.5F}), Vector(-0.5F, 0.5F, 0));
}

/// The normal that a source gives at the middle of triangle 0.
template <class NormalSource>
Vector normal_in_the_middle(const ShaderInputs& inputs) {
  using Shader = Surface<ConstantColor, NormalSource, Diffuse>;
  const Shader shader(inputs);
  return shader.normals.normal_at(point_of(shader, inputs.mesh, 0, 1.0F / 3, 1.0F / 3));
}

TEST(stage07_normal_maps, in_object_space_they_move_as_normals_do) {
  const Rgb8 color{220, 90, 170};
  const TestScene scene("wall:1", plain_picture(color));
  ShaderInputs inputs = scene.inputs();
  const Eigen::Vector3d stored =
      2 * Eigen::Vector3d(color.r, color.g, color.b) / 255 - Eigen::Vector3d::Ones();
  for (const Vector& scale : {Vector(1, 1, 1), Vector(2, 0.5F, 1.5F), Vector(-1, 3, 0.4F)}) {
    inputs.transforms.model = rotation(50, {1, 2, 3}) * scaling(scale);
    const Eigen::Matrix3d model = inputs.transforms.model.topLeftCorner<3, 3>().cast<double>();
    const Eigen::Vector3d expected = (model.inverse().transpose() * stored).normalized();
    const Vector actual = normal_in_the_middle<ObjectSpaceNormalMap>(inputs);
    EXPECT_LE(error(actual, expected), 2e-6) << "scaled by " << scale.transpose();
  }
}

constexpr int map_size = 128;

/// A round hill in the middle of the texture, and its slopes in texture coordinates.
struct Hill {
  static double height(double u, double v) {
    return 0.08 * std::exp(-12 * (std::pow(u - 0.5, 2) + std::pow(v - 0.4, 2)));
  }
  static double slope_u(double u, double v) { return -24 * (u - 0.5) * height(u, v); }
  static double slope_v(double u, double v) { return -24 * (v - 0.4) * height(u, v); }

  /// The hill as a map, for a surface on which u and v grow by 1 in a distance of 1.
  static Image<Rgb8> normal_map() {
    Image<Rgb8> image(map_size, map_size);
    for (int y = 0; y < map_size; ++y) {
      for (int x = 0; x < map_size; ++x) {
        const double u = (x + 0.5) / map_size;
        const double v = 1 - (y + 0.5) / map_size;
        const Eigen::Vector3d normal =
            Eigen::Vector3d(-slope_u(u, v), -slope_v(u, v), 1).normalized();
        const auto code = [](double component) {
          return static_cast<std::uint8_t>(std::lround((component + 1) / 2 * 255));
        };
        image(x, y) = {code(normal.x()), code(normal.y()), code(normal.z())};
      }
    }
    return image;
  }
};

/// Two unit squares side by side in z = 0, x from −1 to 1, y from 0 to 1: on both v = y; u = x on
/// the right one and u = −x on the left one, a mirror image.
Mesh mirrored_squares() {
  Mesh mesh;
  for (int left = 0; left < 2; ++left) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const float shift = left == 0 ? 0.0F : -1.0F;
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
      mesh.positions.emplace_back(static_cast<float>(x) + shift, static_cast<float>(y), 0.0F);
      mesh.normals.emplace_back(0.0F, 0.0F, 1.0F);
      mesh.texture_coordinates.emplace_back(std::fabs(mesh.positions.back().x()),
                                            static_cast<float>(y));
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  }
  return mesh;
}

/// The largest difference between what the map gives on the squares and the hill's own normal,
/// under a model that turns or mirrors.
double worst_on_hill(const Eigen::Matrix4f& model, bool left) {
  const TestScene scene("wall:1", Hill::normal_map());
  const Mesh mesh = mirrored_squares();
  ShaderInputs inputs = {.mesh = mesh,
                         .transforms = {.model = model},
                         .normal_map = Sampler{&scene.texture, Filter::bilinear}};
  const Bumped<ConstantColor> shader(inputs);
  const Eigen::Matrix3d turn = model.topLeftCorner<3, 3>().cast<double>();
  double worst = 0;
  for (std::uint32_t triangle = left ? 2U : 0U; triangle < (left ? 4U : 2U); ++triangle) {
    for (int i = 1; i < 15; ++i) {
      for (int j = 1; i + j < 15; ++j) {
        const auto point = point_of(shader, mesh, triangle, static_cast<float>(i) / 15,
                                    static_cast<float>(j) / 15);
        const double u = static_cast<double>(point.value.uv.x());
        const double v = static_cast<double>(point.value.uv.y());
        const double along_x = left ? -Hill::slope_u(u, v) : Hill::slope_u(u, v);
        const Eigen::Vector3d in_object =
            Eigen::Vector3d(-along_x, -Hill::slope_v(u, v), 1).normalized();
        worst = std::max(worst, error(shader.normals.normal_at(point), turn * in_object));
      }
    }
  }
  return worst;
}

// Eight bits a channel and mixing between texels leave a hundredth; a slope the wrong way round is
// off by more than half.
constexpr double map_precision = 0.012;

TEST(stage07_normal_maps, a_hill_is_a_hill) {
  EXPECT_LE(worst_on_hill(Eigen::Matrix4f::Identity(), false), map_precision);
}

TEST(stage07_normal_maps, a_hill_stays_a_hill_where_u_is_mirrored) {
  EXPECT_LE(worst_on_hill(Eigen::Matrix4f::Identity(), true), map_precision)
      << "on this face u grows to the left: its handedness is −1";
}

TEST(stage07_normal_maps, they_turn_and_mirror_with_the_model) {
  for (const Eigen::Matrix4f& model :
       {rotation(40, {3, 1, 2}), scaling({-1, 1, 1}), scaling({1, 1, -1}),
        Eigen::Matrix4f(rotation(200, {1, -1, 2}) * scaling({1, -1, 1}))}) {
    for (const bool left : {false, true}) {
      EXPECT_LE(worst_on_hill(model, left), map_precision)
          << (left ? "u mirrored, model:\n" : "model:\n") << model;
    }
  }
}

TEST(stage07_normal_maps, the_planets_two_maps_tell_of_the_same_mountains) {
  const Texture object(read_image<Rgb8>(source_folder() / "data/planet_normal_object.png"));
  const Texture tangent(read_image<Rgb8>(source_folder() / "data/planet_normal_tangent.png"));
  const Mesh sphere = make_shape("uv_sphere", 48);
  const ShaderInputs inputs = {
      .mesh = sphere, .normal_map = Sampler{&tangent}, .object_normal_map = Sampler{&object}};
  const BumpedInObjectSpace<ConstantColor> by_object(inputs);
  const Bumped<ConstantColor> by_tangent(inputs);
  int rough = 0;
  int different = 0;
  for (std::uint32_t triangle = 0; triangle < sphere.triangles.size(); ++triangle) {
    const float y = sphere.positions[sphere.triangles[triangle][0]].y();
    if (std::fabs(y) > 0.9F) continue;  // toward the poles faces are slivers of the map
    const Vector smooth = sphere.normals[sphere.triangles[triangle][0]];
    const Vector a =
        by_object.normals.normal_at(point_of(by_object, sphere, triangle, 1.0F / 3, 1.0F / 3));
    const Vector b =
        by_tangent.normals.normal_at(point_of(by_tangent, sphere, triangle, 1.0F / 3, 1.0F / 3));
    if (a.dot(smooth) < 0.95F) ++rough;
    if (a.dot(b) < 0.99F) ++different;
  }
  EXPECT_GT(rough, 500) << "no mountains to compare";
  EXPECT_LE(different, 5) << "of " << sphere.triangles.size() << " faces";
}

}  // namespace
}  // namespace rasterlab
