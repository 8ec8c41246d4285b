// Exercise 02.5: anything that corners have, anywhere in the triangle.
#pragma once

#include <Eigen/Dense>

namespace rasterlab {

/// What the corners' attributes are at a point of the triangle. `at_corners` has a row for every
/// attribute, of any number, and a column for every corner; `weights` are the point's barycentric
/// weights, summing to 1. The result has an entry for every attribute: a₀ + w₁ (a₁ − a₀) + w₂ (a₂ −
/// a₀), which is Σ wᵢ aᵢ in a form that gives exactly a where all corners have a.
///
/// Free: the order of operations; a right answer is within 1e-12 relative to the largest attribute,
/// and exact where the corners agree or all weight is on corner 0.
///
/// Source: C.2.2.
Eigen::VectorXd interpolate_attributes(const Eigen::MatrixX3d& at_corners,
                                       const Eigen::Vector3d& weights);

}  // namespace rasterlab
