#include "bench/engine/scenes.h"

#include "common/mesh/normals.h"
#include "common/mesh/read_mesh.h"
#include "common/mesh/shapes.h"
#include "common/stage/given_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace rasterlab::bench {

namespace {

const std::vector<ShadingKind> every_shading = {ShadingKind::depth, ShadingKind::flat,
                                                ShadingKind::phong, ShadingKind::textured,
                                                ShadingKind::normal_mapped};
const std::vector<ShadingKind> untextured = {ShadingKind::depth, ShadingKind::flat,
                                             ShadingKind::phong};

Eigen::Matrix4f perspective(float aspect) {
  constexpr float near = 0.1F;
  constexpr float far = 100.0F;
  const float scale = 1 / std::tan(std::numbers::pi_v<float> / 6);
  Eigen::Matrix4f m = Eigen::Matrix4f::Zero();
  m(0, 0) = scale / aspect;
  m(1, 1) = scale;
  m(2, 2) = -(far + near) / (far - near);
  m(2, 3) = -2 * far * near / (far - near);
  m(3, 2) = -1;
  return m;
}

Eigen::Matrix4f look_from(const Eigen::Vector3f& eye, const Eigen::Vector3f& center) {
  const Eigen::Vector3f back = (eye - center).normalized();
  const Eigen::Vector3f right = Eigen::Vector3f::UnitY().cross(back).normalized();
  const Eigen::Vector3f up = back.cross(right);
  Eigen::Matrix4f m = Eigen::Matrix4f::Identity();
  m.block<1, 3>(0, 0) = right.transpose();
  m.block<1, 3>(1, 0) = up.transpose();
  m.block<1, 3>(2, 0) = back.transpose();
  m.topRightCorner<3, 1>() = -(m.topLeftCorner<3, 3>() * eye);
  return m;
}

/// Per vertex, the direction in which u grows, at right angles to the normal.
std::vector<Eigen::Vector3f> make_tangents(const Mesh& mesh) {
  std::vector<Eigen::Vector3f> tangents(mesh.positions.size(), Eigen::Vector3f::Zero());
  if (mesh.texture_coordinates.empty()) return {};
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3f side1 = mesh.positions[b] - mesh.positions[a];
    const Eigen::Vector3f side2 = mesh.positions[c] - mesh.positions[a];
    const Eigen::Vector2f uv1 = mesh.texture_coordinates[b] - mesh.texture_coordinates[a];
    const Eigen::Vector2f uv2 = mesh.texture_coordinates[c] - mesh.texture_coordinates[a];
    const Eigen::Vector3f tangent = (side1 * uv2.y() - side2 * uv1.y()).normalized();
    for (const std::uint32_t i : {a, b, c}) tangents[i] += tangent;
  }
  for (std::size_t i = 0; i < tangents.size(); ++i) {
    const Eigen::Vector3f& n = mesh.normals[i];
    const Eigen::Vector3f flat = tangents[i] - n * n.dot(tangents[i]);
    tangents[i] = flat.norm() > 1e-6F ? flat.normalized() : n.unitOrthogonal();
  }
  return tangents;
}

Scene make_scene(std::string name, Mesh mesh, const Eigen::Vector3f& eye,
                 const Eigen::Vector3f& center, PictureSize size,
                 std::vector<ShadingKind> shadings) {
  std::vector<Eigen::Vector3f> tangents = make_tangents(mesh);
  return {std::move(name),
          std::move(mesh),
          std::move(tangents),
          perspective(size.aspect()) * look_from(eye, center),
          eye,
          std::move(shadings)};
}

void append(Mesh& mesh, const Mesh& part, const Eigen::Vector3f& at, float scale) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Eigen::Vector3f& p : part.positions) mesh.positions.push_back(at + scale * p);
  mesh.normals.insert(mesh.normals.end(), part.normals.begin(), part.normals.end());
  mesh.texture_coordinates.insert(mesh.texture_coordinates.end(), part.texture_coordinates.begin(),
                                  part.texture_coordinates.end());
  for (const auto& [a, b, c] : part.triangles) {
    mesh.triangles.push_back({first + a, first + b, first + c});
  }
}

Scene planet(PictureSize size) {
  return make_scene("planet", make_shape("uv_sphere", 25), {0, 0, 1.9F}, {0, 0, 0}, size,
                    every_shading);
}

Scene bunny(PictureSize size) {
  Mesh mesh = read_mesh(bunny_path());
  mesh.texture_coordinates.clear();
  mesh.normals = angle_weighted_normals(mesh);
  const Eigen::AlignedBox3f box = bounding_box(mesh);
  const Eigen::Vector3f center = box.center();
  const float extent = box.sizes().maxCoeff();
  for (Eigen::Vector3f& p : mesh.positions) p = (p - center) / extent * 2.0F;
  return make_scene("bunny", std::move(mesh), {0, 0.2F, 2.3F}, {0, 0, 0}, size, untextured);
}

Scene sphere(PictureSize size) {
  return make_scene("sphere 1M", make_shape("uv_sphere", 500), {0, 0.4F, 2.1F}, {0, 0, 0}, size,
                    every_shading);
}

/// 10 × 10 × 10 of them, from the far end of the grid to the near one, or the other way.
Mesh rings(bool far_to_near) {
  const Mesh ring = make_shape("torus", 16);
  Mesh mesh;
  for (int i = 0; i < 1000; ++i) {
    const int layer = far_to_near ? i / 100 : 9 - i / 100;
    append(mesh, ring,
           {static_cast<float>(i % 10) - 4.5F, static_cast<float>(i / 10 % 10) - 4.5F,
            static_cast<float>(layer) - 4.5F},
           0.45F);
  }
  return mesh;
}

Scene tori(PictureSize size, bool far_to_near) {
  return make_scene(far_to_near ? "tori far to near" : "tori near to far", rings(far_to_near),
                    {0.2F, 0.3F, 4.4F}, {0.5F, 0.2F, -4.5F}, size, every_shading);
}

/// 50 squares that fill the view.
Scene quads(PictureSize size, bool back_to_front) {
  const Mesh wall = make_shape("wall", 1);
  Mesh mesh;
  for (int i = 0; i < 50; ++i) {
    const int layer = back_to_front ? i : 49 - i;
    append(mesh, wall, {0, 0, 0.02F * static_cast<float>(layer) - 3}, 6);
  }
  return make_scene(back_to_front ? "quads back to front" : "quads front to back", std::move(mesh),
                    {0, 0, 0}, {0, 0, -1}, size, every_shading);
}

Scene displaced_sphere(PictureSize size) {
  Mesh mesh = make_shape("uv_sphere", 1415);
  for (Eigen::Vector3f& p : mesh.positions) {
    const float bumps = std::sin(9 * p.x()) * std::sin(11 * p.y()) * std::sin(10 * p.z()) +
                        0.3F * std::sin(41 * p.x() + 3 * p.y()) * std::sin(37 * p.z());
    p *= 1 + 0.05F * bumps;
  }
  mesh.normals = angle_weighted_normals(mesh);
  return make_scene("sphere 8M", std::move(mesh), {0, 0.4F, 2.2F}, {0, 0, 0}, size, every_shading);
}

/// The point as far away as `p` that is seen at the whole 1/256 pixel nearest to where `p` is.
Eigen::Vector3f on_grid(const Eigen::Vector3f& p, const Eigen::Matrix4d& matrix, PictureSize size) {
  Eigen::Vector4d clip = matrix * p.cast<double>().homogeneous();
  const Eigen::Array2d units = Eigen::Array2d(size.width, size.height) * 128;
  clip.head<2>() = (clip.head<2>().array() / clip.w() * units).round() / units * clip.w();
  return (matrix.inverse() * clip).hnormalized().cast<float>();
}

/// Needles of any length and direction, a few hundredths of a pixel to a pixel thin.
///
/// Where each renderer's own rounding would decide which triangle it draws, pictures could not be
/// compared: of so thin a triangle another corner is another outline. So corners are seen at whole
/// 1/256 pixels, never near the middle between two; and inside the picture, at whose border
/// llvmpipe cuts triangles and rounds again.
Scene slivers(PictureSize size) {
  const Eigen::Vector3f eye(0, 0, 2);
  const Eigen::Matrix4d matrix =
      (perspective(size.aspect()) * look_from(eye, {0, 0, 0})).cast<double>();
  const auto in_view = [&matrix](const Eigen::Vector3f& p) {
    const Eigen::Vector4d clip = matrix * p.cast<double>().homogeneous();
    return clip.head<2>().cwiseAbs().maxCoeff() < clip.w();
  };
  std::mt19937 random(7);
  const auto number = [&random](float low, float high) {
    return low + (high - low) * static_cast<float>(random() >> 8U) / 16777216.0F;
  };
  Mesh mesh;
  while (mesh.triangles.size() < 100000) {
    const Eigen::Vector3f from(number(-1.7F, 1.7F), number(-1, 1), number(-1, 0));
    const float angle = number(0, 2 * std::numbers::pi_v<float>);
    const Eigen::Vector3f along(std::cos(angle), std::sin(angle), number(-0.2F, 0.2F));
    const Eigen::Vector3f across(-along.y(), along.x(), 0);
    const float length = number(0.01F, 0.6F);
    const float width = number(0.0001F, 0.002F);
    std::array<Eigen::Vector3f, 3> corners = {from, from + length * along, from + width * across};
    if (!std::all_of(corners.begin(), corners.end(), in_view)) continue;
    for (Eigen::Vector3f& p : corners) p = on_grid(p, matrix, size);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), corners.begin(), corners.end());
    mesh.normals.insert(mesh.normals.end(), 3,
                        Eigen::Vector3f(across.x(), across.y(), 1).normalized());
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return make_scene("slivers", std::move(mesh), eye, {0, 0, 0}, size, untextured);
}

}  // namespace

std::string name_of(ShadingKind kind) {
  switch (kind) {
    case ShadingKind::depth:
      return "depth";
    case ShadingKind::flat:
      return "flat";
    case ShadingKind::phong:
      return "phong";
    case ShadingKind::textured:
      return "textured phong";
    case ShadingKind::normal_mapped:
      break;
  }
  return "normal-mapped phong";
}

const std::vector<SceneEntry>& scenes() {
  static const std::vector<SceneEntry> all = {
      {"planet", &planet},
      {"bunny", &bunny},
      {"sphere 1M", &sphere},
      {"tori far to near", [](PictureSize size) { return tori(size, true); }},
      {"tori near to far", [](PictureSize size) { return tori(size, false); }},
      {"quads back to front", [](PictureSize size) { return quads(size, true); }},
      {"quads front to back", [](PictureSize size) { return quads(size, false); }},
      {"sphere 8M", &displaced_sphere},
      {"slivers", &slivers}};
  return all;
}

Scene tori_around_the_eye(PictureSize size) {
  return make_scene("tori around the eye", rings(true), {0, 0, 0}, {0.5F, 0.2F, -1}, size,
                    every_shading);
}

Image<Rgb8> make_texture(int size) {
  Image<Rgb8> image(size, size);
  const float step = 2 * std::numbers::pi_v<float> / static_cast<float>(size);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const float u = step * static_cast<float>(x);
      const float v = step * static_cast<float>(y);
      const float waves = std::sin(8 * u) * std::sin(6 * v);
      const float grain = std::sin(40 * u + 3 * std::sin(5 * v)) * std::cos(31 * v);
      image.row(y)[x] = to_rgb8(
          {0.55F + 0.25F * waves, 0.5F + 0.2F * std::sin(3 * u + v), 0.45F + 0.15F * grain});
    }
  }
  return image;
}

Image<Rgb8> make_normal_map(int size) {
  Image<Rgb8> image(size, size);
  const float step = 2 * std::numbers::pi_v<float> / static_cast<float>(size);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const float u = step * static_cast<float>(x);
      const float v = step * static_cast<float>(y);
      const Eigen::Vector3f n =
          Eigen::Vector3f(0.3F * std::cos(12 * u), 0.3F * std::sin(14 * v), 1).normalized();
      image.row(y)[x] = to_rgb8(n * 0.5F + Eigen::Vector3f::Constant(0.5F));
    }
  }
  return image;
}

}  // namespace rasterlab::bench
