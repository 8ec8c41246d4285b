// What both sides compute for a pixel: here for the engine, in peer.cpp in GLSL, formula by
// formula the same.
#pragma once

#include "common/mesh/shader_types.h"
#include "common/texture/texture_pair.h"

#include <vector>

namespace rasterlab::bench {

/// A directional light and an eye, in object space.
struct Lighting {
  Eigen::Vector3f toward_light = Eigen::Vector3f(0.3F, 0.5F, 0.8F).normalized();
  Eigen::Vector3f from_light = -toward_light;
  Eigen::Vector3f eye = Eigen::Vector3f::Zero();

  static constexpr float ambient = 0.1F;
  static constexpr float diffuse = 0.7F;
  static constexpr float specular = 0.4F;
  static constexpr float shininess = 10.0F;
};

inline Eigen::Vector3f plain_color() {
  return {0.9F, 0.6F, 0.3F};
}

/// ambient + diffuse · max(N·L, 0)
template <class Number>
Number lit_by(const Number& cosine) {
  return fused_multiply_add(Number(Lighting::diffuse), maximum(cosine, Number(0)),
                            Number(Lighting::ambient));
}

/// color · (ambient + diffuse · max(N·L, 0)) + specular · max(R·V, 0)^shininess
template <class Number>
Vector3<Number> phong(const Lighting& lighting, const Vector3<Number>& normal,
                      const Vector3<Number>& position, const Vector3<Number>& color) {
  const Vector3<Number> from_light = broadcast<Number>(lighting.from_light);
  const Vector3<Number> eye = broadcast<Number>(lighting.eye);
  const Vector3<Number> view = normalized(
      Vector3<Number>(eye.x() - position.x(), eye.y() - position.y(), eye.z() - position.z()));
  const Number cosine = dot(normal, broadcast<Number>(lighting.toward_light));
  const Number twice = Number(2) * cosine;
  const Vector3<Number> reflected(fused_multiply_add(twice, normal.x(), from_light.x()),
                                  fused_multiply_add(twice, normal.y(), from_light.y()),
                                  fused_multiply_add(twice, normal.z(), from_light.z()));
  const Number shine = Number(Lighting::specular) *
                       power(maximum(dot(reflected, view), Number(0)), Lighting::shininess);
  const Number lit = lit_by(cosine);
  return {fused_multiply_add(color.x(), lit, shine), fused_multiply_add(color.y(), lit, shine),
          fused_multiply_add(color.z(), lit, shine)};
}

inline std::uint32_t corner_vertex(const Mesh& mesh, std::uint32_t triangle, int corner) {
  return mesh.triangles[triangle][static_cast<std::size_t>(corner)];
}

/// One colour per triangle, by the normal of its last corner.
struct FlatShader {
  static constexpr bool reads_derivatives = false;

  Lighting lighting;

  template <class Number>
  struct Varyings {
    Vector3<Number> normal;
  };
  Varyings<float> vertex(const Mesh& mesh, std::uint32_t triangle, int) const {
    return {mesh.normals[corner_vertex(mesh, triangle, 2)]};
  }
  template <class Number>
  Vector3<Number> fragment(const SurfacePoint<Varyings, Number>& point) const {
    const Number cosine = dot(point.value.normal, broadcast<Number>(lighting.toward_light));
    const Number lit = lit_by(cosine);
    const Vector3<Number> color = broadcast<Number>(plain_color());
    return {color.x() * lit, color.y() * lit, color.z() * lit};
  }
};

struct PhongShader {
  static constexpr bool reads_derivatives = false;

  Lighting lighting;

  template <class Number>
  struct Varyings {
    Vector3<Number> normal;
    Vector3<Number> position;
  };
  Varyings<float> vertex(const Mesh& mesh, std::uint32_t triangle, int corner) const {
    const std::uint32_t index = corner_vertex(mesh, triangle, corner);
    return {mesh.normals[index], mesh.positions[index]};
  }
  template <class Number>
  Vector3<Number> fragment(const SurfacePoint<Varyings, Number>& point) const {
    return phong(lighting, normalized(point.value.normal), point.value.position,
                 broadcast<Number>(plain_color()));
  }
};

/// What of a texture a pixel sees.
template <class Point>
auto footprint_of(const Point& point) {
  return Footprint<typename Point::Number>{point.value.uv, point.dx.uv, point.dy.uv};
}

struct TexturedShader {
  Lighting lighting;
  const Texture* texture;

  template <class Number>
  struct Varyings {
    Vector3<Number> normal;
    Vector3<Number> position;
    Vector2<Number> uv;
  };
  Varyings<float> vertex(const Mesh& mesh, std::uint32_t triangle, int corner) const {
    const std::uint32_t index = corner_vertex(mesh, triangle, corner);
    return {mesh.normals[index], mesh.positions[index], mesh.texture_coordinates[index]};
  }
  template <class Number>
  Vector3<Number> fragment(const SurfacePoint<Varyings, Number>& point) const {
    return phong(lighting, normalized(point.value.normal), point.value.position,
                 sample_trilinear(*texture, Wrap::repeat, footprint_of(point)));
  }
};

struct NormalMappedShader {
  Lighting lighting;
  TexturePair maps;                              ///< of normals and of colours
  const std::vector<Eigen::Vector3f>* tangents;  ///< one per vertex

  template <class Number>
  struct Varyings {
    Vector3<Number> normal;
    Vector3<Number> position;
    Vector3<Number> tangent;
    Vector2<Number> uv;
  };
  Varyings<float> vertex(const Mesh& mesh, std::uint32_t triangle, int corner) const {
    const std::uint32_t index = corner_vertex(mesh, triangle, corner);
    return {mesh.normals[index], mesh.positions[index], (*tangents)[index],
            mesh.texture_coordinates[index]};
  }
  template <class Number>
  Vector3<Number> fragment(const SurfacePoint<Varyings, Number>& point) const {
    const auto& value = point.value;
    const Vector3<Number>& n = value.normal;
    const Vector3<Number>& t = value.tangent;
    const Vector3<Number> b(n.y() * t.z() - n.z() * t.y(), n.z() * t.x() - n.x() * t.z(),
                            n.x() * t.y() - n.y() * t.x());
    const auto [bump, color] = sample_trilinear(maps, Wrap::repeat, footprint_of(point));
    const Number x = bump.x() * Number(2) - Number(1);
    const Number y = bump.y() * Number(2) - Number(1);
    const Number z = bump.z() * Number(2) - Number(1);
    const auto blend = [&](int i) {
      return fused_multiply_add(x, t[i], fused_multiply_add(y, b[i], Number(z * n[i])));
    };
    const Vector3<Number> normal(blend(0), blend(1), blend(2));
    return phong(lighting, normalized(normal), value.position, color);
  }
};

}  // namespace rasterlab::bench
