#include "tests/oracle/shading.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

namespace rasterlab::oracle {

namespace {

Eigen::Vector3d direction_from(const Eigen::Vector3d& point, const Eigen::Vector4d& goal) {
  return (goal.head<3>() - goal.w() * point).normalized();
}

}  // namespace

std::vector<std::string> Lighting::flags() const {
  std::ostringstream material;
  material << ambient << "," << diffuse << "," << specular << "," << shininess;
  std::ostringstream w;
  w << light.w();
  return {"--light", comma_separated(light.head<3>()) + "," + w.str(), "--material",
          material.str()};
}

Eigen::Vector4d eye_of(const Viewpoint& viewpoint) {
  if (!viewpoint.ortho) return viewpoint.eye.homogeneous();
  const Eigen::Vector3d back = (viewpoint.eye - viewpoint.center).normalized();
  return {back.x(), back.y(), back.z(), 0};
}

Shade light_point(const Lighting& lighting, const Eigen::Vector3d& position,
                  const Eigen::Vector3d& normal, const Eigen::Vector3d& color) {
  const Eigen::Vector3d to_light = direction_from(position, lighting.light);
  const Eigen::Vector3d to_eye = direction_from(position, lighting.eye);
  const double facing = normal.dot(to_light);
  const Eigen::Vector3d mirrored = 2 * facing * normal - to_light;
  const double cosine = lighting.model == Lighting::Model::phong
                            ? mirrored.dot(to_eye)
                            : normal.dot((to_light + to_eye).normalized());
  const bool shines = facing > 0 && cosine > 0;
  const double specular = shines ? lighting.specular * std::pow(cosine, lighting.shininess) : 0;
  const double shade = lighting.ambient + lighting.diffuse * std::max(facing, 0.0);
  return {.color = (color * shade + Eigen::Vector3d::Constant(specular)).cwiseMin(1.0),
          .key = {shines ? 1 : 0}};
}

Surface::Surface(const Mesh& mesh, const Eigen::Vector3d& color_without)
    : triangles_(mesh.triangles) {
  for (const Eigen::Vector3f& position : mesh.positions) {
    positions_.push_back(position.cast<double>());
  }
  for (const Eigen::Vector3f& normal : mesh.normals) normals_.push_back(normal.cast<double>());
  for (const Eigen::Vector3f& color : mesh.colors) colors_.push_back(color.cast<double>());
  for (const Eigen::Vector2f& uv : mesh.texture_coordinates) {
    texture_coordinates_.emplace_back(uv.x(), uv.y(), 0);
  }
  if (normals_.empty()) average_face_normals();
  if (colors_.empty()) colors_.assign(positions_.size(), color_without);
}

Eigen::Vector3d Surface::face_normal(int face) const {
  const auto& [a, b, c] = triangles_[static_cast<std::size_t>(face)];
  return (positions_[b] - positions_[a]).cross(positions_[c] - positions_[a]).stableNormalized();
}

void Surface::average_face_normals() {
  normals_.assign(positions_.size(), Eigen::Vector3d::Zero());
  std::vector<Eigen::Vector3d> first(positions_.size(), Eigen::Vector3d::UnitZ());
  std::vector<int> counts(positions_.size(), 0);
  for (std::size_t face = 0; face < triangles_.size(); ++face) {
    const Eigen::Vector3d normal = face_normal(static_cast<int>(face));
    if (normal.isZero()) continue;
    for (const std::uint32_t vertex : triangles_[face]) {
      if (counts[vertex]++ == 0) first[vertex] = normal;
      normals_[vertex] += normal;
    }
  }
  for (std::size_t i = 0; i < normals_.size(); ++i) {
    const bool cancels = normals_[i].norm() < 1e-5 * counts[i];
    normals_[i] = cancels || counts[i] == 0 ? first[i] : normals_[i].normalized();
  }
}

Hit Surface::corner(const Hit& hit, int corner) {
  Hit at = hit;
  at.weights = Eigen::Vector3d::Unit(corner);
  return at;
}

Eigen::Vector3d Surface::mix(const Hit& hit, const std::vector<Eigen::Vector3d>& values) const {
  const auto& [a, b, c] = triangles_[static_cast<std::size_t>(hit.face)];
  return hit.weights[0] * values[a] + hit.weights[1] * values[b] + hit.weights[2] * values[c];
}

Shade shade_flat(const Surface& surface, const Lighting& lighting, const Hit& hit) {
  Hit center = hit;
  center.weights = Eigen::Vector3d::Constant(1.0 / 3);
  return light_point(lighting, surface.position(center), surface.face_normal(hit.face),
                     surface.color(center));
}

Shade shade_gouraud(const Surface& surface, const Lighting& lighting, const Hit& hit) {
  Shade sum{.color = Eigen::Vector3d::Zero()};
  for (int i = 0; i < 3; ++i) {
    const Hit corner = Surface::corner(hit, i);
    sum.color += hit.weights[i] * light_point(lighting, surface.position(corner),
                                              surface.normal(corner), surface.color(corner))
                                      .color;
  }
  return sum;
}

Shade shade_phong(const Surface& surface, const Lighting& lighting, const Hit& hit) {
  return light_point(lighting, surface.position(hit), surface.normal(hit), surface.color(hit));
}

namespace {

/// Whether the colour jumps within 1/128 px of a point of a face, or another face crosses it there.
bool near_a_jump(const RayCaster& witness, double x, double y, const Hit& hit,
                 const ShadePixel& shade, const Shade& here) {
  constexpr double beside = 1.0 / 128;
  if (here.at_jump) return true;
  for (const double dx : {-beside, beside}) {
    for (const double dy : {-beside, beside}) {
      if (here.key.empty()) continue;
      const Hit there = witness.drawn_plane(x + dx, y + dy, hit.face);
      if (shade(x + dx, y + dy, there).key != here.key) return true;
    }
  }
  return witness.is_near_crossing(x, y, hit, beside);
}

Eigen::Vector3i code_values(const Eigen::Vector3d& color) {
  return (color.cwiseMax(0.0).cwiseMin(1.0) * 255).array().round().cast<int>();
}

/// A pixel that is compared.
struct Pixel {
  int x;
  int y;
  Eigen::Vector3i actual;
  Eigen::Vector3i expected;

  int codes_off() const { return (actual - expected).cwiseAbs().maxCoeff(); }
};

/// Whether all of a face's pixels agree once its corners are snapped in one of the other ways.
bool is_snapped_otherwise(const RayCaster& witness, int face, std::vector<Pixel> pixels,
                          const ShadePixel& shade, int tolerance) {
  if (face < 0) return false;
  const int snappings = witness.snappings(face);
  for (int snapping = 1; snapping < snappings; ++snapping) {
    const bool agree = std::ranges::all_of(pixels, [&](Pixel& pixel) {
      const double x = pixel.x + 0.5;
      const double y = pixel.y + 0.5;
      pixel.expected = code_values(shade(x, y, witness.drawn_plane(x, y, face, snapping)).color);
      return pixel.codes_off() <= tolerance;
    });
    if (agree) return true;
  }
  return false;
}

void add_faults(int face, const std::vector<Pixel>& pixels, int tolerance, Agreement& agreement) {
  for (const Pixel& pixel : pixels) {
    if (pixel.codes_off() <= tolerance) continue;
    std::ostringstream what;
    what << "(" << pixel.x << ", " << pixel.y << "), face " << face << ": "
         << pixel.actual.transpose() << ", expected " << pixel.expected.transpose();
    agreement.add_fault(what.str());
  }
}

}  // namespace

Agreement compare_colors(const RayCaster& witness, const Image<Rgb8>& picture,
                         const ShadePixel& shade, int tolerance) {
  Agreement agreement;
  std::map<int, std::vector<Pixel>> pixels_of_faces;
  const std::vector<double> edges = witness.edge_distances();
  for (int y = 0; y < witness.height(); ++y) {
    for (int x = 0; x < witness.width(); ++x) {
      const auto pixel = static_cast<std::size_t>(y * witness.width() + x);
      Hit hit = witness.cast(x + 0.5, y + 0.5);
      if (hit.face >= 0) hit = witness.drawn_plane(x + 0.5, y + 0.5, hit.face);
      Shade expected{.color = Eigen::Vector3d::Zero()};
      if (hit.face >= 0) expected = shade(x + 0.5, y + 0.5, hit);
      if (edges[pixel] <= 1.0 / 128 ||
          (hit.face >= 0 && near_a_jump(witness, x + 0.5, y + 0.5, hit, shade, expected))) {
        ++agreement.near_edge;
        continue;
      }
      ++agreement.compared;
      if (hit.face >= 0) ++agreement.drawn;
      const Rgb8 stored = picture(x, y);
      pixels_of_faces[hit.face].push_back(
          {x, y, {stored.r, stored.g, stored.b}, code_values(expected.color)});
    }
  }
  for (const auto& [face, pixels] : pixels_of_faces) {
    const auto differing = std::ranges::count_if(
        pixels, [&](const Pixel& pixel) { return pixel.codes_off() > tolerance; });
    if (differing == 0) continue;
    if (is_snapped_otherwise(witness, face, pixels, shade, tolerance)) {
      agreement.snapping += static_cast<int>(differing);
    } else {
      add_faults(face, pixels, tolerance, agreement);
    }
  }
  return agreement;
}

void expect_figure(const std::string& name, const Image<Rgb8>& figure, const FigureScene& scene,
                   const std::function<Shade(const Surface& surface, const Hit& hit)>& shade) {
  const RayCaster witness(scene.mesh, scene.camera, figure.width(), figure.height(), scene.cull);
  const Surface surface(scene.mesh);
  const Agreement agreement = compare_colors(
      witness, figure, [&](double, double, const Hit& hit) { return shade(surface, hit); });
  std::cout << name << ": " << agreement;
  EXPECT_EQ(agreement.wrong, 0) << name << ": " << agreement;
  EXPECT_GT(agreement.drawn, 100) << name;
}

}  // namespace rasterlab::oracle
