// Normals that follow from positions alone. The mean of the faces around a vertex is exercise 05.1
// (common/lighting); here is what is given.
#pragma once

#include "common/mesh/mesh.h"

#include <cstdint>
#include <vector>

namespace rasterlab {

/// The unit normal of a triangle, (b − a) × (c − a) normalised: outside where corners go
/// counter-clockwise. A triangle without area has the normal zero.
Eigen::Vector3f face_normal(const Mesh& mesh, std::uint32_t triangle);

/// The same of every triangle.
std::vector<Eigen::Vector3f> face_normals(const Mesh& mesh);

/// The unit normal of every vertex: the sum of its faces' unit normals, each times the face's angle
/// at the vertex, normalised. It does not depend on how a flat face is cut into triangles.
///
/// Vertices with the same position share one normal, so that a seam of the texture does not show in
/// the light. Where the sum is zero, as between opposite faces, it is the normal of the first face
/// there; a vertex without a face that has area gets +z.
///
/// Source: G. Thürmer, C. A. Wüthrich, "Computing Vertex Normals from Polygonal Facets", Journal of
/// Graphics Tools 3(1), 1998.
std::vector<Eigen::Vector3f> angle_weighted_normals(const Mesh& mesh);

}  // namespace rasterlab
