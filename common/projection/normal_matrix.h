// Exercise 04.10: a normal is no point and no edge: it stands on the surface, and moves
// differently.
#pragma once

#include <Eigen/Dense>

namespace rasterlab {

/// The matrix that takes normals where `model_view` takes the surface: of its upper left 3 × 3
/// block, the inverse transpose up to a positive factor, computed as the matrix of cofactors times
/// the determinant's sign. So translations do not matter (a normal is a direction: w = 0), uneven
/// scales tilt normals the right way, and under a mirror what pointed outside still does.
///
/// Cofactors exist for singular matrices too, where the inverse does not: a model pressed flat gets
/// the normal of the plane it lies in, of either sign for a surface parallel to that plane; one
/// pressed to a line or a point has none and gets the zero matrix.
/// Cost: three cross products, once a picture.
///
/// Source: A.6.2; E. Haines, "Transforming Normals", Ray Tracing News 2(3), 1989; cofactors after
/// R. E. Webb's and N. Reed's observation that they need no division.
Eigen::Matrix3f normal_matrix(const Eigen::Matrix4f& model_view);

/// The normal moved and of unit length again; (0, 0, 0) where the surface has none left.
Eigen::Vector3f transform_normal(const Eigen::Matrix3f& normal_matrix,
                                 const Eigen::Vector3f& normal);

}  // namespace rasterlab
