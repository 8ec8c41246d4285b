// Exercise 04.9, a ladder: what to do with triangles that reach behind the eye, where the division
// by w would wrap them round to the other side of the picture.
//
// Clipping happens in homogeneous clip space, before the division, where lines and planes are still
// what they were. The visible side of the near plane is z ≥ −w.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Dense>

namespace rasterlab {

/// A corner of what is left of a triangle.
struct ClipVertex {
  Eigen::Vector4f position;  ///< clip space
  Eigen::Vector3f weights;   ///< which part of each corner of the whole triangle it has; sum to 1
};

/// A convex polygon, its corners in the triangle's order; empty where nothing is left, else 3 to 8,
/// or more where coordinates of very different size made rounding bend it.
using ClipPolygon = std::vector<ClipVertex>;
using ClipTriangle = std::array<Eigen::Vector4f, 3>;

/// No picture is wider or higher than this many pixels: coverage is exact within ±32768.
inline constexpr int longest_side = 32767;

/// How far |x/w| and |y/w| of a picture's triangles may go without clipping: the greatest power of
/// two g for which g · side ≤ 32768. So window coordinates stay within the ±32768 pixels in which
/// coverage is exact, and g · w is exact too: whether a corner is within is never a matter of
/// rounding. Throws CheckError for a picture without pixels or with a side beyond `longest_side`.
Eigen::Vector2f guard_band(int width, int height);

/// One rung: what of the triangle is in front of the near plane. A triangle that is wholly in front
/// and within the guard band stays as it is. Any floats are allowed, w ≤ 0, infinities and NaN
/// included; what cannot be clipped to anything finite leaves nothing.
using ClipFunction = ClipPolygon (*)(const ClipTriangle& triangle, const Eigen::Vector2f& guard);

/// Leaves out every triangle that has a corner behind the near plane. Ignores the guard band.
ClipPolygon clip_drop(const ClipTriangle& triangle, const Eigen::Vector2f& guard);

/// Cuts at the near plane, going round the triangle and computing each cut from the corner it comes
/// from to the one it goes to. Ignores the guard band.
ClipPolygon clip_near(const ClipTriangle& triangle, const Eigen::Vector2f& guard);

/// Cuts at the near plane, then where x/w and y/w leave the guard band (which also removes all that
/// is left with w < 0), plane after plane in the order z ≥ −w, x ≥ −gw, x ≤ gw, y ≥ −gw, y ≤ gw
/// (Sutherland and Hodgman, "Reentrant Polygon Clipping", CACM 17, 1974; Blinn and Newell,
/// "Clipping Using Homogeneous Coordinates", SIGGRAPH 1978). All in double precision, rounded to
/// single at the end: where a side goes past the eye, w cancels between its ends. With d = z + w,
/// or g·w ± x, or g·w ± y, the point of the cut is a + t · (b − a), t = d_a / (d_a − d_b), always
/// from the corner inside (d ≥ 0) to the one outside: so two triangles that share an edge get the
/// same point, to the last bit, and leave neither gap nor double. Weights are cut with the same t.
/// Cost: five distances for each corner.
///
/// That holds for the cuts. What is thinner than the 1/256 pixel that corners are snapped to
/// afterwards may turn over; of what has been cut, that part is not drawn (cut_outline.h).
///
/// Known fault: where all three corners have |w| < 2⁻⁵¹/g times the largest of their |x| and |y|,
/// rounding moves a cut farther than the guard band is wide, and parts or all of the triangle are
/// lost. The eye is then in its plane, as nearly as a double can say. (To put the cut exactly on
/// its plane would mend that, and tear edges elsewhere: it takes the point off the edge.)
ClipPolygon clip_homogeneous(const ClipTriangle& triangle, const Eigen::Vector2f& guard);

/// The ladder, worst first.
struct ClipRung {
  const char* name;
  ClipFunction clip;
  const char* known_fault;
};
extern const std::array<ClipRung, 3> clip_ladder;

}  // namespace rasterlab
