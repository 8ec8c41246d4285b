// Boxes around clusters, as many at once as there are lanes: where in clip space they are, and
// which are outside the view.
#pragma once

#include "common/engine/prepared_mesh.h"
#include "common/engine/window_vertex.h"

#include <cmath>
#include <limits>

namespace rasterlab::RASTERLAB_SIMD {

/// The range of a linear function over boxes.
struct Range {
  Number low;
  Number high;
};

struct Boxes {
  std::array<Number, 3> center;
  std::array<Number, 3> half_size;

  /// Of row · (p, 1), with a margin for rounding, here and in the vertices' own transform.
  Range of(const std::array<float, 4>& row) const {
    Number middle(row[3]);
    Number reach(0.0F);
    Number terms = magnitude(middle);
    for (std::size_t i = 0; i < 3; ++i) {
      middle += center[i] * Number(row[i]);
      reach += half_size[i] * magnitude(Number(row[i]));
      terms += magnitude(center[i] * Number(row[i]));
    }
    reach += (terms + reach) * Number(1e-5F);
    return {middle - reach, middle + reach};
  }

  /// The terms of row · (p, 1) add up to no more, all taken as positive.
  Number size_of_terms(const std::array<float, 4>& row) const {
    Number size(std::abs(row[3]));
    for (std::size_t i = 0; i < 3; ++i) {
      size += (magnitude(center[i]) + half_size[i]) * Number(std::abs(row[i]));
    }
    return size;
  }
};

inline std::array<float, 4> sum_of(const std::array<float, 4>& a, const std::array<float, 4>& b,
                                   float sign) {
  std::array<float, 4> sum;
  for (std::size_t i = 0; i < 4; ++i) sum[i] = a[i] + sign * b[i];
  return sum;
}

/// Whether boxes lie wholly on the outer side of a side of the view. Written so that what is not a
/// number is not outside.
inline Truth outside_view(const ClipTransform& transform, const Boxes& boxes) {
  const auto& row = transform.row;
  Truth outside = boxes.of(sum_of(row[3], row[2], 1)).high < Number(0);  // the near plane
  for (std::size_t axis = 0; axis < 2; ++axis) {
    outside = outside || boxes.of(sum_of(row[3], row[axis], 1)).high < Number(0) ||
              boxes.of(sum_of(row[3], row[axis], -1)).high < Number(0);
  }
  return outside;
}

inline std::array<float, 4> depth_row(const ClipTransform& transform) {
  std::array<float, 4> row;
  for (std::size_t i = 0; i < 4; ++i) row[i] = static_cast<float>(transform.depth_row[i]);
  return row;
}

/// The largest reversed depth in the boxes; infinite when they reach behind the eye.
inline Number nearest_depth(const ClipTransform& transform, const Boxes& boxes) {
  const Number w = boxes.of(transform.row[3]).low;
  const Number numerator = boxes.of(depth_row(transform)).high;
  const Number nearest = numerator / w * Number(1.00001F);
  return select(w > Number(0) && nearest >= Number(0), nearest,
                Number(std::numeric_limits<float>::infinity()));
}

inline Boxes load_boxes(const Clusters& clusters, std::uint32_t first) {
  Boxes boxes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    boxes.center[axis] = load(clusters.center[axis].data() + first);
    boxes.half_size[axis] = load(clusters.half_size[axis].data() + first);
  }
  return boxes;
}

}  // namespace rasterlab::RASTERLAB_SIMD
