// Clipped triangles whose outline, after snapping, winds round some pixels the other way than the
// triangle is seen. Two of its parts then overlap, and neither may be drawn as it is; its pixels
// are found row by row. There are few such triangles, and all are slivers somewhere.
#pragma once

#include "common/engine/hidden_clusters.h"
#include "common/engine/kernels.h"
#include "common/engine/window_vertex.h"

#include <algorithm>
#include <vector>

namespace rasterlab::RASTERLAB_SIMD {

/// A picture's pixels around a part; none when left > right or top > bottom.
inline PixelBounds pixels_of(const ClippedPart& part, const FrameAccess& frame) {
  const auto& [a, b, c] = part.snapped;
  const auto [low_x, high_x] = std::minmax({a.x, b.x, c.x});
  const auto [low_y, high_y] = std::minmax({a.y, b.y, c.y});
  return {std::max((low_x + 127) >> 8, 0), std::min((high_x - 128) >> 8, frame.width() - 1),
          std::max((low_y + 127) >> 8, 0), std::min((high_y - 128) >> 8, frame.height() - 1)};
}

/// Of one row: first and last pixel; none when the first is greater.
struct PixelRun {
  std::int32_t first, last;
};

/// A part's edge functions, positive inside, at any pixel's centre: exact.
class PartEdges {
 public:
  explicit PartEdges(const ClippedPart& part) : side_(part.side()) {
    for (std::size_t i = 0; i < 3; ++i) {
      const SnappedCorner& a = part.snapped[(i + 1) % 3];
      const SnappedCorner& b = part.snapped[(i + 2) % 3];
      step_x_[i] = std::int64_t{side_} * 256 * (a.y - b.y);
      step_y_[i] = std::int64_t{side_} * 256 * (b.x - a.x);
      at_first_[i] = side_ * twice_area(a, b, {128, 128});
    }
  }

  int side() const { return side_; }

  std::int64_t value(std::size_t i, int x, int y) const {
    return at_first_[i] + x * step_x_[i] + y * step_y_[i];
  }

  bool covers(int x, int y) const {
    return value(0, x, y) >= least(0) && value(1, x, y) >= least(1) && value(2, x, y) >= least(2);
  }

  /// Of a row's pixels `within`, those it covers.
  PixelRun run(int y, const PixelRun& within) const {
    std::int64_t first = within.first;
    std::int64_t last = within.last;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int64_t lacking = least(i) - value(i, 0, y);
      const std::int64_t step = step_x_[i];
      if (step == 0 && lacking > 0) return {1, 0};
      if (step > 0) first = std::max(first, -rounded_down(-lacking, step));
      if (step < 0) last = std::min(last, rounded_down(-lacking, -step));
    }
    return {static_cast<std::int32_t>(first), static_cast<std::int32_t>(std::max(last, first - 1))};
  }

 private:
  /// The top-left rule.
  std::int64_t least(std::size_t i) const {
    return step_x_[i] > 0 || (step_x_[i] == 0 && step_y_[i] > 0) ? 0 : 1;
  }
  static std::int64_t rounded_down(std::int64_t a, std::int64_t positive) {
    return a / positive - (a % positive < 0 ? 1 : 0);
  }

  int side_;
  std::array<std::int64_t, 3> step_x_;
  std::array<std::int64_t, 3> step_y_;
  std::array<std::int64_t, 3> at_first_;
};

/// A triangle with its top edge on the centres of the run's pixels and its left one on the first:
/// covers just these, and has their depths.
inline LargeTriangle triangle_of_run(const PixelRun& run, int y, float first_depth,
                                     float last_depth, std::uint32_t key) {
  const std::int32_t left = run.first * 256 + 128;
  const std::int32_t right = run.last * 256 + 129;
  const std::int32_t top = y * 256 + 128;
  const int steps = std::max(run.last - run.first, 1) * 256;
  const float beyond_last = last_depth + (last_depth - first_depth) / static_cast<float>(steps);
  return {{left, right, left}, {top, top, top + 127}, {first_depth, beyond_last, first_depth}, key};
}

/// Calls `visit(const LargeTriangle&, PixelBounds)` for triangles that together cover the pixels of
/// a picture that the parts' outline winds round the triangle's way: each pixel once, with the
/// depth of the first part of that side that covers it.
template <class Visit>
void for_each_run(const ClippedParts& parts, const FrameAccess& frame, std::uint32_t key,
                  Visit&& visit) {
  std::vector<PartEdges> edges;
  for (const ClippedPart& part : parts.all()) edges.emplace_back(part);
  const auto owns = [&](std::size_t part, int x, int y) {
    int winding = 0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (!edges[i].covers(x, y)) continue;
      if (edges[i].side() == parts.side && i < part) return false;
      winding += edges[i].side();
    }
    return winding * parts.side > 0;
  };
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const ClippedPart& part = parts.all()[i];
    if (part.side() != parts.side) continue;
    const auto depth = [&](int x, int y) {
      double sum = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        sum += static_cast<double>(edges[i].value(c, x, y)) *
               static_cast<double>(part.corner[c]->reversed_depth());
      }
      return static_cast<float>(sum / static_cast<double>(std::abs(part.area)));
    };
    const PixelBounds bounds = pixels_of(part, frame);
    for (int y = bounds.top; y <= bounds.bottom; ++y) {
      const PixelRun covered = edges[i].run(y, {bounds.left, bounds.right});
      for (int x = covered.first; x <= covered.last; ++x) {
        if (!owns(i, x, y)) continue;
        const int first = x;
        while (x < covered.last && owns(i, x + 1, y)) ++x;
        visit(triangle_of_run({first, x}, y, depth(first, y), depth(x, y), key),
              PixelBounds{first, x, y, y});
      }
    }
  }
}

}  // namespace rasterlab::RASTERLAB_SIMD
