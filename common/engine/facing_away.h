// Clusters that face away, of which culling leaves nothing.
//
// Twice the area of a triangle in the window is −half_width · half_height · n · v / (w0 w1 w2),
// where n is (p1 − p0) × (p2 − p0) in object space and v a linear function of any of its points
// (the way to the eye, scaled; by determinants). Which side is seen, though, is asked after the
// corners have been snapped: a cluster may only be left out when no snapping could turn any of its
// triangles over.
#pragma once

#include "common/engine/cluster_boxes.h"
#include "common/engine/kernels.h"

namespace rasterlab::RASTERLAB_SIMD {

/// v as a function of a position p: `at_origin` + `by_position` · p.
struct WayToEye {
  std::array<double, 3> at_origin;
  double by_position;

  explicit WayToEye(const ClipTransform& transform) {
    Eigen::Matrix3d linear;
    Eigen::Vector3d constant;
    for (int r = 0; r < 3; ++r) {
      const auto& row = transform.row[r == 2 ? 3 : static_cast<std::size_t>(r)];
      linear.row(r) = Eigen::RowVector3d(row[0], row[1], row[2]);
      constant[r] = row[3];
    }
    const Eigen::Vector3d columns[3] = {linear.col(0), linear.col(1), linear.col(2)};
    for (std::size_t i = 0; i < 3; ++i) {
      at_origin[i] = columns[(i + 1) % 3].cross(columns[(i + 2) % 3]).dot(constant);
    }
    by_position = columns[0].dot(columns[1].cross(columns[2]));
  }
};

struct Facings {
  std::array<Number, 3> axis;
  Number spread, smallest, thinnest;
};

inline Facings load_facings(const Facing& facing, std::uint32_t first) {
  Facings result;
  for (std::size_t i = 0; i < 3; ++i) result.axis[i] = load(facing.axis[i].data() + first);
  result.spread = load(facing.spread.data() + first);
  result.smallest = load(facing.smallest.data() + first);
  result.thinnest = load(facing.thinnest.data() + first);
  return result;
}

inline Number length(const std::array<Number, 3>& a) {
  return square_root(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

inline float length_of_row(const std::array<float, 4>& row) {
  return std::sqrt(row[0] * row[0] + row[1] * row[1] + row[2] * row[2]);
}

/// At least so much n · v / |n| is on the far side of 0 for each of a cluster's triangles;
/// negative when it isn't for all. `sign`: −1 or 1, for which side is to be away.
inline Number least_facing_away(const WayToEye& way, const Boxes& boxes, const Facings& facings,
                                float sign) {
  const auto d = static_cast<float>(way.by_position);
  std::array<Number, 3> v;
  Number along(0);
  Number terms(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<float>(way.at_origin[i]);
    v[i] = Number(k) + Number(d) * boxes.center[i];
    terms += Number(std::abs(k)) + magnitude(Number(d) * boxes.center[i]);
    along += facings.axis[i] * v[i];
  }
  const Number reach = facings.spread * length(v) + Number(std::abs(d)) * length(boxes.half_size) +
                       terms * Number(1e-5F);
  return along * Number(sign) - reach;
}

/// How far, in pixels, a coordinate in the window may be from what exact arithmetic gives, before
/// and with snapping; and how far apart, at most, the ends of an edge are whose length in object
/// space is 1, times w.
struct WindowBounds {
  Number error;
  Number edge;
  Truth inside;  ///< of the guard band
};
inline WindowBounds window_bounds(const ClipTransform& transform, const Boxes& boxes,
                                  std::size_t axis, Range w) {
  const auto& row = transform.row[axis];
  const Range range = boxes.of(row);
  const Number farthest = maximum(magnitude(range.low), magnitude(range.high)) / w.low;
  const Number half(axis == 0 ? transform.half_width : transform.half_height);
  const Number terms = boxes.size_of_terms(row) + farthest * boxes.size_of_terms(transform.row[3]);
  const float guard = axis == 0 ? transform.guard_x : transform.guard_y;
  return {Number(1.0F / 512) + half * Number(1e-6F) * (terms / w.low + farthest + Number(1)),
          half * (Number(length_of_row(row)) + farthest * Number(length_of_row(transform.row[3]))),
          farthest <= Number(guard * 0.999F)};
}

/// Clusters all of whose triangles show, however they are snapped, the side that is culled. An
/// edge's window coordinates are off by twice a corner's error e, so twice the area by less than
/// 8 · e · edge + 8 · e²; asked for is twice that.
inline Truth facing_away(const DrawJob& job, const WayToEye& way, const Boxes& boxes,
                         const Facings& facings) {
  const ClipTransform& transform = job.transform;
  const Range w = boxes.of(transform.row[3]);
  const WindowBounds x = window_bounds(transform, boxes, 0, w);
  const WindowBounds y = window_bounds(transform, boxes, 1, w);
  const Number near = boxes.of(sum_of(transform.row[3], transform.row[2], 1)).low;
  const Number away = least_facing_away(way, boxes, facings, job.cull == Cull::back ? -1.0F : 1.0F);
  const Number area = Number(transform.half_width * transform.half_height) * away;
  const Number error = maximum(x.error, y.error);
  const Number w_cubed = w.high * w.high * w.high;
  // None is clipped, and none but numbers of usual size are multiplied.
  const Truth usual =
      w.low > Number(1e-6F) && w.high < Number(1e9F) && near > Number(0) && x.inside && y.inside;
  return usual && away > Number(0) &&
         area * facings.thinnest * w.low > Number(16) * error * maximum(x.edge, y.edge) * w_cubed &&
         area * facings.smallest > Number(16) * error * error * w_cubed;
}

}  // namespace rasterlab::RASTERLAB_SIMD
