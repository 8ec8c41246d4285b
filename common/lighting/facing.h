// Exercise 05.7: does the camera see the front of a triangle, or its back?
#pragma once

#include <array>

#include <Eigen/Dense>

namespace rasterlab {

enum class Facing { front, back, edge_on };

/// Which side of a triangle the eye sees, from its corners in clip space, in any projection. Fronts
/// go counter-clockwise in NDC (y up). Whether corners are behind the eye does not matter: the sign
/// of the determinant of the three (x, y, w) says on which side of the triangle's plane the eye is,
/// without a division. `mirrored` says that model · view is a mirror (its determinant is below 0),
/// by which fronts go clockwise. A triangle without area, or whose plane goes through the eye, is
/// edge-on.
///
/// It is the eye's side that counts, not the light's: a face turned away from the light is dark,
/// but seen; and with perspective not the view axis's: near the picture's border a face whose
/// normal points a little away from the axis may still be seen. Cost: one determinant.
///
/// Source: B.culling; M. Olano and T. Greer, "Triangle Scan Conversion using 2D Homogeneous
/// Coordinates", Graphics Hardware 1997.
Facing facing(const std::array<Eigen::Vector4f, 3>& clip, bool mirrored);

}  // namespace rasterlab
