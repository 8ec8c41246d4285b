// Cutting a polygon into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Dense>

namespace rasterlab {

/// Replaces `triangles` by a polygon cut up. A polygon of n ≥ 3 corners, which need be neither
/// convex nor quite flat, gives n − 2 triangles of its corners, numbered from 0, wound as the
/// polygon is. A polygon may touch itself, as one with a hole does. One that crosses itself is cut
/// into n − 2 triangles too, somehow. Convex: a fan around corner 0.
///
/// Cost: O(n) for a convex polygon, else O(n²) to O(n³); beyond 1024 corners always a fan.
///
/// Source: G. H. Meisters, "Polygons Have Ears", American Mathematical Monthly 82, 1975; the plane
/// is Newell's.
void triangulate(std::span<const Eigen::Vector3f> polygon,
                 std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace rasterlab
