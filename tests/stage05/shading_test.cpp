#include "common/lighting/shading.h"

#include "common/image/check.h"
#include "common/lighting/light_vertices.h"
#include "common/lighting/power_pictures.h"
#include "common/lighting/turned_light.h"
#include "common/lighting/vertex_normals.h"
#include "common/mesh/shapes.h"
#include "common/projection/look_at.h"
#include "common/projection/perspective.h"
#include "common/projection/rotation.h"
#include "common/projection/viewport.h"

#include <array>
#include <cmath>
#include <set>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

using Vector = Eigen::Vector3f;

bool operator<(const Rgb8& a, const Rgb8& b) {
  return std::array{a.r, a.g, a.b} < std::array{b.r, b.g, b.b};
}

Transforms seen_from(const Vector& eye) {
  Transforms transforms;
  transforms.view = look_at(eye, {0, 0, 0}, {0, 1, 0});
  transforms.projection = perspective(40, 1, 0.1F, 100);
  return transforms;
}

const Light from_right{.position = {1, 0.5F, 0.7F, 0}};

// One triangle across the view whose normals lean apart.
Mesh leaning_triangle() {
  Mesh mesh;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  mesh.normals = {Vector(-0.6F, 0, 0.8F), Vector(0.6F, 0, 0.8F), Vector(0, 0.6F, 0.8F)};
  mesh.colors = {{1, 0.2F, 0.2F}, {0.2F, 1, 0.2F}, {0.2F, 0.2F, 1}};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

// Phong's reflection at one point, in double precision.
Eigen::Vector3d lit_point(const Eigen::Vector3d& color, Eigen::Vector3d normal,
                          const Eigen::Vector3d& point, const Eigen::Vector3d& eye,
                          const Eigen::Vector3d& to_light, const Material& material) {
  normal.normalize();
  const double facing = normal.dot(to_light);
  const Eigen::Vector3d mirrored = 2 * facing * normal - to_light;
  const double cosine = mirrored.dot((eye - point).normalized());
  const double specular = facing > 0 && cosine > 0
                              ? static_cast<double>(material.specular) *
                                    std::pow(cosine, static_cast<double>(material.shininess))
                              : 0;
  const double shade = static_cast<double>(material.ambient) +
                       static_cast<double>(material.diffuse) * std::max(facing, 0.0);
  return (color * shade + Eigen::Vector3d::Constant(specular)).cwiseMin(1);
}

// The point of z = 0 and its barycentric weights that a pixel's centre sees from (0, 0, 4).
struct SeenPoint {
  Eigen::Vector3d point;
  Eigen::Vector3d weights;  // in leaning_triangle()
};

SeenPoint seen_point(int x, int y, int size) {
  const double half = 4 * std::tan(20 * 3.14159265358979323846 / 180);
  const double px = ((x + 0.5) / size * 2 - 1) * half;
  const double py = (1 - (y + 0.5) / size * 2) * half;
  const double w2 = (py + 1) / 2;
  const double w1 = (px + 1 - w2) / 2;
  return {{px, py, 0}, {1 - w1 - w2, w1, w2}};
}

Eigen::Vector3d mixed(const std::vector<Vector>& corners, const Eigen::Vector3d& weights) {
  return weights[0] * corners[0].cast<double>() + weights[1] * corners[1].cast<double>() +
         weights[2] * corners[2].cast<double>();
}

void expect_near(const Rgb8& pixel, const Eigen::Vector3d& color) {
  EXPECT_NEAR(pixel.r, color.x() * 255, 1);
  EXPECT_NEAR(pixel.g, color.y() * 255, 1);
  EXPECT_NEAR(pixel.b, color.z() * 255, 1);
}

class Shaded {
 public:
  explicit Shaded(const Mesh& mesh) : mesh_(mesh) {}

  Frame by(ShadeFunction shade) const {
    Frame frame = make_frame(size, size);
    shade({.mesh = mesh_,
           .transforms = seen_from({0, 0, 4}),
           .light = from_right,
           .material = material},
          frame);
    return frame;
  }

  static constexpr int size = 48;
  static constexpr Material material{.shininess = 20};
  static inline const Eigen::Vector3d eye{0, 0, 4};
  static inline const Eigen::Vector3d to_light =
      from_right.position.head<3>().cast<double>().normalized();

 private:
  const Mesh& mesh_;
};

template <class Check>
int for_inner_pixels(const Check& check) {
  int count = 0;
  for (int y = 0; y < Shaded::size; ++y) {
    for (int x = 0; x < Shaded::size; ++x) {
      const SeenPoint seen = seen_point(x, y, Shaded::size);
      if (seen.weights.minCoeff() < 0.02) continue;
      check(x, y, seen);
      ++count;
    }
  }
  return count;
}

TEST(stage05_shade_flat, a_face_has_one_colour_that_of_its_own_normal_at_its_centroid) {
  const Mesh mesh = leaning_triangle();
  const Frame frame = Shaded(mesh).by(&shade_flat);
  const Eigen::Vector3d third = Eigen::Vector3d::Constant(1.0 / 3);
  const Eigen::Vector3d expected =
      lit_point(mixed(mesh.colors, third), {0, 0, 1}, mixed(mesh.positions, third), Shaded::eye,
                Shaded::to_light, Shaded::material);
  EXPECT_GT(for_inner_pixels(
                [&](int x, int y, const SeenPoint&) { expect_near(frame.color(x, y), expected); }),
            100);
}

TEST(stage05_shade_flat, needs_no_vertex_normals) {
  Mesh mesh = leaning_triangle();
  mesh.normals.clear();
  EXPECT_EQ(Shaded(mesh).by(&shade_flat).color, Shaded(leaning_triangle()).by(&shade_flat).color);
  EXPECT_THROW(Shaded(mesh).by(&shade_gouraud), CheckError);
  EXPECT_THROW(Shaded(mesh).by(&shade_phong), CheckError);
}

TEST(stage05_shade_gouraud, colours_of_the_corners_are_interpolated) {
  const Mesh mesh = leaning_triangle();
  const Frame frame = Shaded(mesh).by(&shade_gouraud);
  Eigen::Matrix3d corners;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    corners.col(i) = lit_point(mesh.colors[k].cast<double>(), mesh.normals[k].cast<double>(),
                               mesh.positions[k].cast<double>(), Shaded::eye, Shaded::to_light,
                               Shaded::material);
  }
  EXPECT_GT(for_inner_pixels([&](int x, int y, const SeenPoint& seen) {
              expect_near(frame.color(x, y), corners * seen.weights);
            }),
            100);
}

TEST(stage05_shade_phong, every_pixel_is_lit_with_the_interpolated_normal_made_a_unit_vector) {
  const Mesh mesh = leaning_triangle();
  const Frame frame = Shaded(mesh).by(&shade_phong);
  EXPECT_GT(for_inner_pixels([&](int x, int y, const SeenPoint& seen) {
              expect_near(
                  frame.color(x, y),
                  lit_point(mixed(mesh.colors, seen.weights), mixed(mesh.normals, seen.weights),
                            seen.point, Shaded::eye, Shaded::to_light, Shaded::material));
            }),
            100);
}

TEST(stage05_shade_phong, opposite_normals_that_cancel_do_no_harm) {
  Mesh mesh = leaning_triangle();
  mesh.normals = {Vector(1, 0, 0), Vector(-1, 0, 0), Vector(1, 0, 0)};
  const Frame frame = Shaded(mesh).by(&shade_phong);
  EXPECT_FALSE(frame.color(24, 24) == Rgb8{}) << "ambient light at least";
}

TEST(stage05_shade_phong, rungs_agree_where_all_normals_are_the_faces) {
  Mesh mesh = leaning_triangle();
  mesh.normals.assign(3, Vector(0, 0, 1));
  mesh.colors.clear();
  const Material dull{.ambient = 0.2F, .diffuse = 0.8F, .specular = 0};
  Frame flat = make_frame(32, 32);
  Frame gouraud = make_frame(32, 32);
  Frame phong = make_frame(32, 32);
  const LitMesh lit_mesh{
      .mesh = mesh, .transforms = seen_from({0, 0, 4}), .light = from_right, .material = dull};
  shade_flat(lit_mesh, flat);
  shade_gouraud(lit_mesh, gouraud);
  shade_phong(lit_mesh, phong);
  EXPECT_EQ(flat.color, gouraud.color);
  EXPECT_EQ(flat.color, phong.color);
}

LitMesh sphere_lit(const Mesh& sphere) {
  return {.mesh = sphere,
          .transforms = seen_from({0, 0, 4}),
          .light = from_right,
          .material = {},
          .color = Color(0.5F, 0.6F, 0.7F)};
}

TEST(stage05_light_vertices, one_colour_a_vertex_between_black_and_white) {
  const Mesh sphere = make_shape("uv_sphere", 16);
  LitMesh lit_mesh = sphere_lit(sphere);
  lit_mesh.light.intensity = 5;
  const std::vector<Color> colors = light_vertices(lit_mesh);
  ASSERT_EQ(colors.size(), sphere.positions.size());
  for (const Color& color : colors) {
    ASSERT_GE(color.minCoeff(), 0);
    ASSERT_LE(color.maxCoeff(), 1);
  }
}

TEST(stage05_light_vertices, the_mesh_turns_and_the_light_stays) {
  const Mesh sphere = make_shape("uv_sphere", 16);
  LitMesh lit_mesh = sphere_lit(sphere);
  const auto brightest = [&] {
    const std::vector<Color> colors = light_vertices(lit_mesh);
    std::size_t best = 0;
    for (std::size_t i = 0; i < colors.size(); ++i) {
      if (colors[i].sum() > colors[best].sum()) best = i;
    }
    const Eigen::Vector4f world = lit_mesh.transforms.model * sphere.positions[best].homogeneous();
    return Vector(world.head<3>());
  };
  lit_mesh.material.specular = 0;
  const Vector before = brightest();
  EXPECT_GT(before.normalized().dot(from_right.position.head<3>().normalized()), 0.98F);
  lit_mesh.transforms.model = rotation(100, {0.3F, 1, 0.2F});
  EXPECT_GT(brightest().dot(before), 0.97F) << "normals turn with the mesh; the light does not";
}

TEST(stage05_light_vertices, moving_mesh_light_and_camera_together_changes_nothing) {
  const Mesh sphere = make_shape("uv_sphere", 12);
  LitMesh lit_mesh = sphere_lit(sphere);
  lit_mesh.light.position = {2, 1, 1, 1};
  const std::vector<Color> before = light_vertices(lit_mesh);
  const Eigen::Matrix4f move = translation({5, -3, 2}) * rotation(50, {1, 2, 3});
  lit_mesh.transforms.model = move;
  lit_mesh.transforms.view = lit_mesh.transforms.view * move.inverse();
  lit_mesh.light.position = move * lit_mesh.light.position;
  const std::vector<Color> after = light_vertices(lit_mesh);
  for (std::size_t i = 0; i < before.size(); ++i) {
    ASSERT_LT((before[i] - after[i]).norm(), 1e-3F) << "vertex " << i;
  }
}

TEST(stage05_light_vertices, a_mirrored_mesh_is_lit_from_the_mirrored_side) {
  const Mesh sphere = make_shape("uv_sphere", 12);
  LitMesh lit_mesh = sphere_lit(sphere);
  const std::vector<Color> before = light_vertices(lit_mesh);
  lit_mesh.transforms.model = scaling({-1, 1, 1});
  lit_mesh.light.position.x() *= -1;
  const std::vector<Color> after = light_vertices(lit_mesh);
  for (std::size_t i = 0; i < before.size(); ++i) {
    ASSERT_LT((before[i] - after[i]).norm(), 1e-4F) << "vertex " << i;
  }
}

TEST(stage05_light_vertices, uneven_scale_tilts_normals_the_right_way) {
  Mesh slope;
  slope.positions = {{0, 0, 0}, {1, 1, 0}, {0, 0, -1}};
  slope.triangles = {{0, 1, 2}};
  slope.normals.assign(3, Vector(-1, 1, 0).normalized());
  LitMesh lit_mesh{.mesh = slope,
                   .transforms = seen_from({0, 5, 4}),
                   .light = {.position = {0, 1, 0, 0}},
                   .material = {.ambient = 0, .diffuse = 1, .specular = 0},
                   .color = Color(1, 1, 1)};
  lit_mesh.transforms.model = scaling({1, 0.25F, 1});
  // Pressed flat, the slope 1 : 1 is 1 : ¼; its normal is (−¼, 1).
  EXPECT_NEAR(light_vertices(lit_mesh)[0].x(), 1 / std::sqrt(1 + 1.0 / 16), 1e-5);
}

TEST(stage05_light_vertices, colours_are_the_meshs_unless_one_is_given) {
  Mesh mesh = leaning_triangle();
  LitMesh lit_mesh{.mesh = mesh,
                   .transforms = seen_from({0, 0, 4}),
                   .light = {.position = {0, 0, -1, 0}},
                   .material = {.ambient = 1}};
  EXPECT_EQ(light_vertices(lit_mesh)[1], mesh.colors[1]) << "lit from behind: ambient alone";
  lit_mesh.color = Color(0.25F, 0.5F, 1);
  EXPECT_EQ(light_vertices(lit_mesh)[1], Color(0.25F, 0.5F, 1));
}

TEST(stage05_turned_light, a_hundred_steps_lead_round_once) {
  Light light{.position = {1, 2, 3, 1}};
  const Vector center(0.5F, -1, 2);
  std::set<float> places;
  for (int i = 0; i < 100; ++i) {
    const Light turned = turned_light(light, center, {0, 1, 0}, 3.6F * static_cast<float>(i));
    EXPECT_NEAR((turned.position.head<3>() - center).norm(), 3.2015621, 1e-4);
    EXPECT_NEAR(turned.position.y(), 2, 1e-5);
    EXPECT_EQ(turned.position.w(), 1);
    places.insert(turned.position.x() + 100 * turned.position.z());
  }
  EXPECT_EQ(places.size(), 100U) << "every frame has its own place";
  EXPECT_LT((turned_light(light, center, {0, 1, 0}, 360).position - light.position).norm(), 1e-4F);
}

TEST(stage05_turned_light, goes_counter_clockwise_seen_from_the_axis_end) {
  const Light light{.position = {0, 0, 1, 0}, .intensity = 0.5F, .ambient_intensity = 0.25F};
  const Light turned = turned_light(light, {7, 7, 7}, {0, 2, 0}, 90);
  EXPECT_LT((turned.position - Eigen::Vector4f(1, 0, 0, 0)).norm(), 1e-6F)
      << "at infinity, where the axis stands does not matter";
  EXPECT_EQ(turned.intensity, 0.5F);
  EXPECT_EQ(turned.ambient_intensity, 0.25F);
}

TEST(stage05_turned_light, without_an_axis_or_on_it_the_light_stays) {
  const Light light{.position = {1, 2, 3, 1}};
  EXPECT_EQ(turned_light(light, {5, 5, 5}, {0, 0, 0}, 77).position, light.position);
  EXPECT_LT((turned_light(light, {1, -9, 3}, {0, 1, 0}, 77).position - light.position).norm(),
            1e-5F);
  EXPECT_LT((turned_light(light, {0, 0, 0}, {0, 1, 0}, -90).position -
             turned_light(light, {0, 0, 0}, {0, 1, 0}, 630).position)
                .norm(),
            1e-5F)
      << "−90° is 630°";
}

int lit_pixels(const Image<Rgb8>& image) {
  return static_cast<int>(std::count_if(image.pixels().begin(), image.pixels().end(),
                                        [](const Rgb8& pixel) { return pixel.r > 8; }));
}

TEST(stage05_draw_power, the_higher_the_power_the_smaller_the_highlight) {
  const Mesh sphere = make_shape("uv_sphere", 24);
  int previous = 1 << 30;
  for (int power = 0; power <= 10; ++power) {
    const PowerPictures pictures =
        draw_power(sphere_lit(sphere), static_cast<float>(power), 48, 48);
    const int lit = lit_pixels(pictures.highlight);
    EXPECT_LT(lit, previous) << "power " << power;
    EXPECT_GT(lit, 0);
    previous = lit;
  }
}

TEST(stage05_draw_power, the_sum_is_the_highlight_over_the_rest) {
  const Mesh sphere = make_shape("uv_sphere", 24);
  const LitMesh lit_mesh = sphere_lit(sphere);
  const PowerPictures pictures = draw_power(lit_mesh, 5, 48, 48);
  LitMesh dull = lit_mesh;
  dull.material.specular = 0;
  Frame rest = make_frame(48, 48);
  shade_phong(dull, rest);
  for (std::size_t i = 0; i < rest.color.pixels().size(); ++i) {
    const int expected = std::min(255, pictures.highlight.pixels()[i].g + rest.color.pixels()[i].g);
    ASSERT_NEAR(pictures.sum.pixels()[i].g, expected, 1);
  }
}

TEST(stage05_draw_power, nothing_gives_black_pictures) {
  const Mesh nothing;
  const PowerPictures pictures = draw_power(sphere_lit(nothing), 5, 8, 8);
  EXPECT_EQ(pictures.highlight, Image<Rgb8>(8, 8));
  EXPECT_EQ(pictures.sum, Image<Rgb8>(8, 8));
}

TEST(stage05_draw_power, power_0_leaves_the_dark_side_dark) {
  const Mesh sphere = make_shape("uv_sphere", 24);
  const Image<Rgb8> highlight = draw_power(sphere_lit(sphere), 0, 48, 48).highlight;
  EXPECT_EQ(highlight(30, 20), (Rgb8{153, 153, 153})) << "Ks · 255 on the lit side";
  EXPECT_EQ(highlight(12, 30), (Rgb8{0, 0, 0})) << "nothing on the other";
  std::set<Rgb8, decltype([](const Rgb8& a, const Rgb8& b) { return a < b; })> colors(
      highlight.pixels().begin(), highlight.pixels().end());
  EXPECT_EQ(colors.size(), 2U) << "a hard edge";
}

}  // namespace
}  // namespace rasterlab
