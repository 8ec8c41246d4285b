// What is wrong with a way to decide what is in front, in numbers.
#pragma once

#include "common/zbuffer/visibility.h"

#include <cstdint>
#include <string>

namespace rasterlab {

/// How many pixels show a triangle although another one is nearer there, or show nothing although
/// one is there.
struct VisibilityFaults {
  std::int64_t wrong = 0;
  std::int64_t covered = 0;  ///< pixels where there is anything to see
};

/// Compares with what is nearest by exact integers; of triangles at equal distances any is right.
/// For corners within ±256 pixels and distances that are multiples of 1/16 below 16, which makes
/// 128 bits enough; throws CheckError otherwise.
VisibilityFaults visibility_faults(const VisibleTriangles& seen, const VisibilityScene& scene);

/// 30 random triangles that pierce each other, in 128 × 128, between distances 1 and 10.
VisibilityScene piercing_triangles();

/// Two triangles of one shape in 32 × 32: the corners of one are at 1, 1.5 and 2 times `distance`
/// from the eye, those of the other at (1 + delta) times as much, so that it is farther everywhere;
/// the near plane is at 0.5, the far one at 50 000.
VisibilityScene nearly_coplanar_pair(double distance, double delta, bool nearer_last);

/// The share, from 0 to 1, of wrong pixels of such a pair, drawn in either order.
double wrong_share_of_pair(VisibilityFunction rung, double distance, double delta);

/// Wrong pixels of every rung: of the piercing triangles, and of pairs over five decades of
/// distance and δ = 1e-2 … 1e-7.
std::string visibility_fault_table();

}  // namespace rasterlab
