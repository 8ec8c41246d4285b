// Exercise 05.1: which way a vertex faces, when only faces have a direction.
#pragma once

#include "common/mesh/mesh.h"

#include <vector>

#include <Eigen/Dense>

namespace rasterlab {

/// The normal of every vertex, in object space and of unit length: the mean of the unit normals of
/// the triangles it belongs to, whatever their size, normalised. A triangle's normal is (b − a) ×
/// (c − a), outside where corners go counter-clockwise; one without area has none and does not
/// count.
///
/// Where the mean is (nearly) zero, shorter than 10⁻⁵ times what it is the mean of, as on a sheet
/// with two sides, the vertex gets the normal of the first of its triangles that has one. A vertex
/// without such a triangle gets +z. Vertices are told apart by their index, so one that a seam has
/// split has a normal on each side.
///
/// The mean depends on how a flat face is cut into triangles: angle_weighted_normals() of
/// common/mesh/normals.h does not. Cost: the triangles and the vertices, once each.
///
/// Source: C.4, A.7; H. Gouraud, "Continuous Shading of Curved Surfaces", IEEE Transactions on
/// Computers C-20(6), 1971.
std::vector<Eigen::Vector3f> vertex_normals(const Mesh& mesh);

}  // namespace rasterlab
