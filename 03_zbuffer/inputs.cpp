#include "03_zbuffer/inputs.h"

#include <cmath>

namespace rasterlab {
namespace {

/// The distance at which a camera with these planes sees NDC depth z.
float distance_of(float z, float near, float far) {
  return 2 * far * near / (far + near - z * (far - near));
}

}  // namespace

const std::vector<std::array<DepthCorner, 3>>& interpenetrating_triangles() {
  static const Color red(1, 0.2F, 0.2F);
  static const Color green(0.2F, 0.9F, 0.2F);
  static const Color blue(0.3F, 0.4F, 1);
  static const Color pale(0.9F, 0.9F, 0.7F);
  static const std::vector<std::array<DepthCorner, 3>> triangles = {
      {{{{20, 30}, -0.6F, red}, {{190, 70}, 0.6F, pale}, {{30, 100}, -0.6F, red}}},
      {{{{180, 20}, -0.6F, green}, {{160, 110}, -0.6F, green}, {{40, 180}, 0.6F, pale}}},
      {{{{110, 190}, -0.6F, blue}, {{60, 10}, 0.6F, pale}, {{190, 170}, -0.6F, blue}}},
  };
  return triangles;
}

const std::vector<FlatShape>& scene_from_above() {
  static const std::vector<FlatShape> shapes = {
      {"white square", {1, 1, 1}, {{70, 80}, {130, 80}, {130, 140}, {70, 140}}},
      {"green triangle", {0.1F, 0.8F, 0.1F}, {{20, 60}, {110, 110}, {30, 150}}},
      {"blue triangle", {0.2F, 0.3F, 1}, {{90, 30}, {180, 60}, {120, 100}}},
      {"red triangle", {1, 0.1F, 0.1F}, {{10, 160}, {150, 20}, {190, 180}}},
  };
  return shapes;
}

VisibilityScene interpenetrating_scene() {
  VisibilityScene scene{.width = 200, .height = 200, .near = 1, .far = 10, .triangles = {}};
  for (const auto& triangle : interpenetrating_triangles()) {
    VisibilityTriangle& added = scene.triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      added.corners[i] = triangle[i].position.cast<float>();
      added.distances[i] = distance_of(triangle[i].z, scene.near, scene.far);
    }
  }
  return scene;
}

VisibilityScene nearly_coplanar_pairs() {
  constexpr int cell = 32;
  constexpr int decades = 5;
  constexpr int gaps = 6;
  VisibilityScene scene{
      .width = cell * gaps, .height = cell * decades, .near = 0.5F, .far = 40000, .triangles = {}};
  for (int row = 0; row < decades; ++row) {
    for (int column = 0; column < gaps; ++column) {
      const Eigen::Vector2f corner(static_cast<float>(column * cell),
                                   static_cast<float>(row * cell));
      const auto distance = static_cast<float>(std::pow(10, row));
      VisibilityTriangle far_one;
      far_one.corners = {corner + Eigen::Vector2f(2, 2), corner + Eigen::Vector2f(3, 30),
                         corner + Eigen::Vector2f(30, 16)};
      far_one.distances = {distance, 2 * distance, 3 * distance};
      VisibilityTriangle near_one = far_one;
      const double part = 1 - std::pow(10, -2 - column);
      for (float& d : near_one.distances) d = static_cast<float>(d * part);
      scene.triangles.push_back(far_one);
      scene.triangles.push_back(near_one);
    }
  }
  return scene;
}

}  // namespace rasterlab
