// Exercise 07.4: normals from a picture: hills and dents that the mesh does not have.
#pragma once

#include "common/projection/normal_matrix.h"
#include "common/shaders/attributes.h"
#include "common/shaders/color_sources.h"
#include "common/shaders/inputs.h"

namespace rasterlab {

/// The vector that a normal map's colour stands for: 2c − 1 for each of red, green and blue, not
/// renormalised. Red is along x (or the tangent), green along y, blue along z (or the normal);
/// green grows with v. `color` is in [0, 1], the result in [−1, 1]; no code value of 8 bits gives
/// exactly 0.
template <class Number>
Vector3<Number> vector_of_color(const Vector3<Number>& color) {
  return {Number(2) * color.x() - Number(1), Number(2) * color.y() - Number(1),
          Number(2) * color.z() - Number(1)};
}

/// A normal map in object space: its colours are normals of the mesh as it is in the file, which
/// move with it. Filtering mixes normals, so the result is renormalised, in the world. The
/// constructor throws InputError where the inputs have no such map. Source: B.normal.
struct ObjectSpaceNormalMap {
  using Reads = Attributes<TextureCoordinates>;

  Sampler map;
  Eigen::Matrix3f to_world;

  explicit ObjectSpaceNormalMap(const ShaderInputs& inputs)
      : map(required(inputs.object_normal_map, "--normal-map")),
        to_world(normal_matrix(inputs.transforms.model)) {}

  template <class Point>
  auto normal_at(const Point& point) const {
    return normalized(multiply(to_world, vector_of_color(sample(map, footprint_of(point)))));
  }
};

/// A normal given relative to the surface, turned into the space of the surface's own normal n and
/// tangent, in which u grows: local.x · t + local.y · b + local.z · n, renormalised, where n is
/// `normal` renormalised, t is `tangent` made perpendicular to n, and b = handedness · (n × t), the
/// direction in which v grows. Where tangent and normal are parallel, or the tangent is zero,
/// local.x and local.y count for nothing; where the normal is zero, local.y and local.z. What is
/// then left being zero, so is the result. Cost: three square roots.
///
/// Source: B.normal; Blinn, "Simulation of Wrinkled Surfaces", SIGGRAPH 1978.
template <class Number>
Vector3<Number> normal_from_tangent_space(const Vector3<Number>& local,
                                          const Vector3<Number>& normal,
                                          const Vector3<Number>& tangent, const Number& handedness);

/// A normal map in tangent space: its colours are normals relative to the surface, (0, 0, 1) being
/// the surface's own, so that one map fits any mesh, bent and mirrored too. The surface's own
/// normal is that of the vertices, interpolated, and the tangent that of the face (face_tangent.h).
/// The constructor throws InputError where the inputs have no such map.
struct TangentSpaceNormalMap {
  using Reads = Attributes<TextureCoordinates, VertexNormals, Tangents>;

  Sampler map;

  explicit TangentSpaceNormalMap(const ShaderInputs& inputs)
      : map(required(inputs.normal_map, "--normal-map")) {}

  template <class Point>
  auto normal_at(const Point& point) const {
    return normal_from_tangent_space(vector_of_color(sample(map, footprint_of(point))),
                                     point.value.normal, point.value.tangent,
                                     point.value.handedness);
  }
};

}  // namespace rasterlab

#include "common/shaders/normal_maps.inl"
