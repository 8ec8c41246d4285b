// A mesh's vertices and faces in the world, and the light on them: given.
#pragma once

#include "common/image/pixel.h"
#include "common/lighting/blinn_phong.h"
#include "common/lighting/lit_mesh.h"
#include "common/lighting/phong.h"

#include <array>
#include <cstdint>

#include <Eigen/Dense>

namespace rasterlab {

/// A point of a surface in the world.
template <class Number>
struct SurfaceSample {
  Vector3<Number> position;
  Vector3<Number> normal;  ///< unit length, or zero where there is none
  Vector3<Number> color;
};

/// The point of a triangle at a pixel, given its corners: the normal made a unit vector again.
SurfaceSample<float> interpolate(const std::array<SurfaceSample<float>, 3>& corners,
                                 const CornerWeights<float>& weights);

/// Lights the points of one mesh.
class SurfaceLighting {
 public:
  explicit SurfaceLighting(const LitMesh& lit_mesh);

  /// A vertex with its normal. Throws CheckError when the mesh has none.
  SurfaceSample<float> vertex(std::uint32_t vertex) const;

  /// The three vertices of a triangle.
  std::array<SurfaceSample<float>, 3> corners(std::uint32_t triangle) const;

  /// The centroid of a triangle, with the normal of the face and the mean of the corners' colours.
  SurfaceSample<float> face(std::uint32_t triangle) const;

  /// The colour the eye sees.
  template <class Number>
  Vector3<Number> light(const SurfaceSample<Number>& sample) const {
    const Vector3<Number> to_light = direction_to(lit_mesh_.light.position, sample.position);
    const Vector3<Number> to_eye = direction_to(eye_, sample.position);
    return lit(sample.color, reflection(sample.normal, to_light, to_eye));
  }

 private:
  template <class Number>
  Reflection<Number> reflection(const Vector3<Number>& normal, const Vector3<Number>& to_light,
                                const Vector3<Number>& to_eye) const {
    return lit_mesh_.model == ReflectionModel::phong
               ? phong(normal, to_light, to_eye, lit_mesh_.light, lit_mesh_.material)
               : blinn_phong(normal, to_light, to_eye, lit_mesh_.light, lit_mesh_.material);
  }

  Eigen::Vector3f world_position(std::uint32_t vertex) const;
  Color vertex_color(std::uint32_t vertex) const;

  const LitMesh& lit_mesh_;
  Eigen::Matrix3f normal_matrix_;
  Eigen::Vector4f eye_;
};

}  // namespace rasterlab
