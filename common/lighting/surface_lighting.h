// A mesh's vertices and faces in the world, and the light on them: given.
#pragma once

#include "common/image/pixel.h"
#include "common/lighting/lit_mesh.h"

#include <array>
#include <cstdint>

#include <Eigen/Dense>

namespace rasterlab {

/// A point of a surface in the world.
struct SurfaceSample {
  Eigen::Vector3f position;
  Eigen::Vector3f normal;  ///< unit length, or zero where there is none
  Color color;
};

/// The point of a triangle at a pixel, given its corners: the normal made a unit vector again.
SurfaceSample interpolate(const std::array<SurfaceSample, 3>& corners,
                          const CornerWeights<float>& weights);

/// Lights the points of one mesh.
class SurfaceLighting {
 public:
  explicit SurfaceLighting(const LitMesh& lit_mesh);

  /// A vertex with its normal. Throws CheckError when the mesh has none.
  SurfaceSample vertex(std::uint32_t vertex) const;

  /// The three vertices of a triangle.
  std::array<SurfaceSample, 3> corners(std::uint32_t triangle) const;

  /// The centroid of a triangle, with the normal of the face and the mean of the corners' colours.
  SurfaceSample face(std::uint32_t triangle) const;

  /// The colour the eye sees.
  Color light(const SurfaceSample& sample) const;

 private:
  Eigen::Vector3f world_position(std::uint32_t vertex) const;
  Color vertex_color(std::uint32_t vertex) const;

  const LitMesh& lit_mesh_;
  Eigen::Matrix3f normal_matrix_;
  Eigen::Vector4f eye_;
};

}  // namespace rasterlab
