#include "tests/oracle/shader_looks.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace rasterlab::oracle {

namespace {

using Normal = ShaderLook::Normal;
using Light = ShaderLook::Light;

double cosine_to_light(const Lighting& lighting, const Eigen::Vector3d& position,
                       const Eigen::Vector3d& normal) {
  const Eigen::Vector3d way = lighting.light.head<3>() - lighting.light.w() * position;
  return normal.dot(way.normalized());
}

/// Lambert's law with the vertices' normals at the corners, mixed.
double mixed_cosine(const ShadedScene& scene, const Hit& hit) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const Hit corner = Surface::corner(hit, i);
    const double cosine = cosine_to_light(scene.lighting, scene.surface.position(corner),
                                          scene.surface.normal(corner));
    sum += hit.weights[i] * std::max(cosine, 0.0);
  }
  return sum;
}

/// ∂position/∂u and ∂position/∂v on a face, as columns: position is affine in (u, v) there.
Eigen::Matrix<double, 3, 2> texture_axes(const Surface& surface, const Hit& hit) {
  const auto at = [&](int corner) { return Surface::corner(hit, corner); };
  Eigen::Matrix<double, 3, 2> edges;
  Eigen::Matrix2d steps;
  for (int i = 0; i < 2; ++i) {
    edges.col(i) = surface.position(at(i + 1)) - surface.position(at(0));
    steps.col(i) = surface.texture_coordinates(at(i + 1)) - surface.texture_coordinates(at(0));
  }
  return edges * steps.inverse();
}

/// A normal and what it jumps with.
struct NormalThere {
  Eigen::Vector3d normal;
  std::vector<long> key = {};
  bool at_jump = false;
};

NormalThere in_tangent_space(const ShadedScene& scene, const Hit& hit,
                             const Eigen::Vector3d& local) {
  const auto axes = texture_axes(scene.surface, hit);
  if (!axes.allFinite() || axes.col(0).isZero()) return {Eigen::Vector3d::UnitZ(), {}, true};
  const Eigen::Vector3d n = scene.surface.normal(hit);
  const Eigen::Vector3d u = axes.col(0).normalized();
  const Eigen::Vector3d t = (u - u.dot(n) * n).normalized();
  Eigen::Vector3d b = n.cross(t);
  const Eigen::Vector3d face = scene.surface.face_normal(hit.face);
  if (face.cross(axes.col(0)).dot(axes.col(1)) < 0) b = -b;  // u is mirrored
  return {(local.x() * t + local.y() * b + local.z() * n).normalized()};
}

NormalThere normal_there(const ShaderLook& look, const ShadedScene& scene, const Steps& steps,
                         const Hit& hit) {
  if (look.normal == Normal::face) return {scene.surface.face_normal(hit.face)};
  if (look.normal == Normal::vertices) return {scene.surface.normal(hit)};
  const Shade read = sample(scene.maps.normal, scene.filter, "repeat", steps);
  const Eigen::Vector3d stored = 2 * read.color - Eigen::Vector3d::Ones();
  NormalThere there = look.normal == Normal::object_map ? NormalThere{stored.normalized()}
                                                        : in_tangent_space(scene, hit, stored);
  there.key = read.key;
  there.at_jump = there.at_jump || read.at_jump;
  return there;
}

/// The look's light on a surface of that colour.
Shade light_there(const ShaderLook& look, const ShadedScene& scene, const Steps& steps,
                  const Hit& hit, const Eigen::Vector3d& color, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d position = scene.surface.position(hit);
  switch (look.light) {
    case Light::none:
      return {color};
    case Light::diffuse:
      return {color * std::max(cosine_to_light(scene.lighting, position, normal), 0.0)};
    case Light::at_corners:
      return {color * mixed_cosine(scene, hit)};
    case Light::five_levels: {
      const long band = std::min(std::lround(std::floor(mixed_cosine(scene, hit) * 5)), 4L);
      return {color * static_cast<double>(band) / 4, {band}};
    }
    case Light::phong:
    case Light::blinn_phong:
      break;
  }
  Lighting lighting = scene.lighting;
  lighting.model =
      look.light == Light::phong ? Lighting::Model::phong : Lighting::Model::blinn_phong;
  Shade map{.color = Eigen::Vector3d::Ones()};
  if (look.specular_mapped) {
    map = sample(scene.maps.specular, scene.filter, "repeat", steps);
  }
  lighting.specular *= map.color.x();
  Shade shade = light_point(lighting, position, normal, color);
  shade.key.insert(shade.key.end(), map.key.begin(), map.key.end());
  shade.at_jump = map.at_jump;
  return shade;
}

bool in_hole(const Eigen::Vector2d& uv) {
  const auto in_middle = [](double cells) {
    return std::abs(cells - std::floor(cells) - 0.5) < 0.3;
  };
  return in_middle(uv.x() * 32) && in_middle(uv.y() * 16);
}

}  // namespace

const std::vector<ShaderLook>& shader_looks() {
  static const std::vector<ShaderLook> looks{
      {"color", false, Normal::face, Light::none},
      {"texture", true, Normal::face, Light::none},
      {"flat", false, Normal::face, Light::diffuse},
      {"flat_texture", true, Normal::face, Light::diffuse},
      {"gouraud", false, Normal::vertices, Light::at_corners},
      {"gouraud_texture", true, Normal::vertices, Light::at_corners},
      {"quantized", false, Normal::vertices, Light::five_levels},
      {"normal_object", false, Normal::object_map, Light::diffuse},
      {"normal", false, Normal::tangent_map, Light::diffuse},
      {"normal_texture", true, Normal::tangent_map, Light::diffuse},
      {"phong", false, Normal::vertices, Light::phong},
      {"phong_normal", false, Normal::tangent_map, Light::phong},
      {"phong_texture", true, Normal::vertices, Light::phong},
      {"phong_normal_texture", true, Normal::tangent_map, Light::phong},
      {"phong_all_maps", true, Normal::tangent_map, Light::phong, true},
      {"blinn_phong", false, Normal::vertices, Light::blinn_phong},
      {"blinn_phong_texture", true, Normal::vertices, Light::blinn_phong},
  };
  return looks;
}

Shade shade_look(const ShaderLook& look, const ShadedScene& scene, double x, double y,
                 const Hit& hit) {
  Steps steps{};
  if (look.reads_texture_coordinates()) {
    steps = steps_at(scene.witness, scene.surface, x, y, hit);
  }
  Shade surface{.color = scene.surface.color(hit)};
  if (look.textured) surface = sample(scene.maps.color, scene.filter, "repeat", steps);
  const NormalThere there = normal_there(look, scene, steps, hit);
  Shade shade = light_there(look, scene, steps, hit, surface.color, there.normal);
  shade.key.insert(shade.key.end(), surface.key.begin(), surface.key.end());
  shade.key.insert(shade.key.end(), there.key.begin(), there.key.end());
  shade.at_jump = shade.at_jump || surface.at_jump || there.at_jump;
  return shade;
}

Shade see_through_lattice(const ShadedScene& scene, double x, double y,
                          const Eigen::Vector3d& front) {
  Shade shade{.color = Eigen::Vector3d::Zero()};
  for (const Hit& met : scene.witness.cast_through(x, y)) {
    const Hit hit = scene.witness.drawn_plane(x, y, met.face);
    const bool hole = in_hole(scene.surface.texture_coordinates(hit));
    shade.key.insert(shade.key.end(), {hit.face, hole ? 1 : 0});
    if (hole) continue;
    const double toward_eye = hit.front ? 1 : -1;
    const double cosine = toward_eye * cosine_to_light(scene.lighting, scene.surface.position(hit),
                                                       scene.surface.normal(hit));
    const Eigen::Vector3d color = hit.front ? front : Eigen::Vector3d(0.8, 0.25, 0.2);
    shade.color = color * std::max(cosine, 0.0);
    break;
  }
  return shade;
}

}  // namespace rasterlab::oracle
