// Exercise 07.4: which way the texture runs along a face.
#pragma once

#include <array>

#include <Eigen/Dense>

namespace rasterlab {

/// The texture's axes on a face, in whatever space its corners are given.
struct FaceTangent {
  Eigen::Vector3f tangent;  ///< unit length: the direction along the face in which u grows
  float handedness;         ///< +1 or −1: v grows along handedness · (normal × tangent)
};

/// The tangent of the face with these corners and texture coordinates, the normal being the one
/// from whose side its corners go counter-clockwise.
///
/// With edges e₁, e₂ from the first corner and (u₁, v₁), (u₂, v₂) the texture coordinates' along
/// them, u grows along (v₂·e₁ − v₁·e₂)/d and v along (u₁·e₂ − u₂·e₁)/d, d = u₁·v₂ − u₂·v₁. Where a
/// mesh uses the same part of a texture twice, mirrored, d < 0 on one of the two: there u grows the
/// other way along the surface, and the handedness is −1, so that a bump stays a bump on both.
///
/// Degenerate: where d is 0, so that u has no direction, the tangent is some unit vector in the
/// face and the handedness +1; where the face has no area either, some unit vector. Both depend on
/// the corners alone. Computed in double precision. Cost: constant.
///
/// Source: E. Lengyel, "Computing Tangent Space Basis Vectors for an Arbitrary Mesh", 2001;
/// B.normal.
FaceTangent face_tangent(const std::array<Eigen::Vector3f, 3>& corners,
                         const std::array<Eigen::Vector2f, 3>& texture_coordinates);

}  // namespace rasterlab
