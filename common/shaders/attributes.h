// What a triangle's corners can hand to its pixels: each attribute said once, and interpolated only
// where a shader reads it.
//
// An attribute is made from a shader's inputs. It has a `Varying<Number>`, the members it adds to a
// shader's varyings, and `at(mesh, triangle, corner)`, their values at a corner: `mesh` is the one
// it was made with, `triangle` the index of one of its triangles, `corner` is 0, 1 or 2. If it does
// without the mesh's normals it says `static constexpr bool reads_vertex_normals = false;`.
#pragma once

#include "common/mesh/shader_types.h"
#include "common/shaders/inputs.h"
#include "common/texture/textured_mesh.h"

#include <cstdint>
#include <tuple>
#include <type_traits>

namespace rasterlab {

inline std::uint32_t vertex_of(const Mesh& mesh, std::uint32_t triangle, int corner) {
  return mesh.triangles[triangle][static_cast<std::size_t>(corner)];
}

/// Whether a shader, or an attribute, may read the normals of a mesh's vertices: unless it says
/// that it doesn't.
template <class Reader>
constexpr bool reads_vertex_normals() {
  if constexpr (requires { Reader::reads_vertex_normals; }) {
    return Reader::reads_vertex_normals;
  } else {
    return true;
  }
}

/// The mesh's texture coordinates, v up, as they are: they may leave [0, 1]. The constructor throws
/// InputError where the mesh has none.
struct TextureCoordinates {
  static constexpr bool reads_vertex_normals = false;

  template <class Number>
  struct Varying {
    Vector2<Number> uv;
  };

  explicit TextureCoordinates(const ShaderInputs& inputs) {
    require_texture_coordinates(inputs.mesh);
  }

  Varying<float> at(const Mesh& mesh, std::uint32_t triangle, int corner) const {
    return {mesh.texture_coordinates[vertex_of(mesh, triangle, corner)]};
  }
};

/// The mesh's colours, in [0, 1]. The constructor throws InputError where the mesh has none.
struct VertexColors {
  static constexpr bool reads_vertex_normals = false;

  template <class Number>
  struct Varying {
    Vector3<Number> color;
  };

  explicit VertexColors(const ShaderInputs& inputs);

  Varying<float> at(const Mesh& mesh, std::uint32_t triangle, int corner) const {
    return {mesh.colors[vertex_of(mesh, triangle, corner)]};
  }
};

/// Where the point is in the world: the model's matrix is affine.
struct WorldPosition {
  static constexpr bool reads_vertex_normals = false;

  template <class Number>
  struct Varying {
    Vector3<Number> position;
  };

  Eigen::Matrix4f to_world;

  explicit WorldPosition(const ShaderInputs& inputs) : to_world(inputs.transforms.model) {}

  Varying<float> at(const Mesh& mesh, std::uint32_t triangle, int corner) const {
    const Eigen::Vector3f& position = mesh.positions[vertex_of(mesh, triangle, corner)];
    return {(to_world * position.homogeneous()).hnormalized()};
  }
};

/// The normals of the vertices in the world, of unit length at the corners and, mixed, shorter
/// between them. Zero at all corners under a model pressed to a line (normal_matrix.h). The
/// constructor throws InputError where the mesh has none.
struct VertexNormals {
  template <class Number>
  struct Varying {
    Vector3<Number> normal;
  };

  Eigen::Matrix3f to_world;

  explicit VertexNormals(const ShaderInputs& inputs);

  Varying<float> at(const Mesh& mesh, std::uint32_t triangle, int corner) const;
};

/// The unit normal of the face in the world: the same at all three corners, so that no rounding
/// shows between them. Zero for a face without area, and under a model pressed to a line.
struct FaceNormals {
  static constexpr bool reads_vertex_normals = false;

  template <class Number>
  struct Varying {
    Vector3<Number> face_normal;
  };

  Eigen::Matrix3f to_world;

  explicit FaceNormals(const ShaderInputs& inputs);

  Varying<float> at(const Mesh& mesh, std::uint32_t triangle, int corner) const;
};

/// Which way the texture runs along the face, in the world (face_tangent.h): a unit tangent, along
/// which u grows, and ±1. v grows along handedness · (normal × tangent), also where the model's
/// matrix is a mirror. The same at all three corners. The tangent is zero where the model is
/// pressed flat along it. The constructor throws InputError where the mesh has no texture
/// coordinates.
struct Tangents {
  static constexpr bool reads_vertex_normals = false;

  template <class Number>
  struct Varying {
    Vector3<Number> tangent;
    Number handedness;
  };

  Eigen::Matrix3f to_world;
  float handedness;  ///< −1 where the model's matrix is a mirror

  explicit Tangents(const ShaderInputs& inputs);

  Varying<float> at(const Mesh& mesh, std::uint32_t triangle, int corner) const;
};

/// A set of attributes as one shader's varyings.
template <class... Each>
struct Attributes {
  static constexpr bool reads_vertex_normals = (rasterlab::reads_vertex_normals<Each>() || ...);

  template <class Number>
  struct Varyings : Each::template Varying<Number>... {};

  std::tuple<Each...> each;

  explicit Attributes([[maybe_unused]] const ShaderInputs& inputs) : each(Each(inputs)...) {}

  Varyings<float> at([[maybe_unused]] const Mesh& mesh, [[maybe_unused]] std::uint32_t triangle,
                     [[maybe_unused]] int corner) const {
    return {std::get<Each>(each).at(mesh, triangle, corner)...};
  }
};

/// What several parts of a shader read, each attribute once.
template <class Result, class... Sets>
struct UniteAttributes;
template <class Result>
struct UniteAttributes<Result> {
  using Type = Result;
};
template <class Result, class... Sets>
struct UniteAttributes<Result, Attributes<>, Sets...> : UniteAttributes<Result, Sets...> {};
template <class... Known, class First, class... More, class... Sets>
struct UniteAttributes<Attributes<Known...>, Attributes<First, More...>, Sets...>
    : UniteAttributes<std::conditional_t<(std::is_same_v<Known, First> || ...),
                                         Attributes<Known...>, Attributes<Known..., First>>,
                      Attributes<More...>, Sets...> {};
template <class... Sets>
using United = typename UniteAttributes<Attributes<>, Sets...>::Type;

}  // namespace rasterlab
