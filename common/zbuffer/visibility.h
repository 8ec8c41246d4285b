// Exercise 03.5, a ladder: which of several triangles is seen at each pixel.
#pragma once

#include "common/image/image.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Dense>

namespace rasterlab {

/// A triangle as a perspective camera has put it into the window.
struct VisibilityTriangle {
  std::array<Eigen::Vector2f, 3> corners;  ///< window coordinates: pixels, y down
  std::array<float, 3> distances;          ///< of the corners, along the view axis; near to far
};

/// What is to be seen: triangles in the order they are drawn, and the planes they lie between.
struct VisibilityScene {
  int width = 0;
  int height = 0;
  float near = 0.1F;  ///< distance of the near plane, above 0
  float far = 1000;   ///< distance of the far plane, above `near`
  std::vector<VisibilityTriangle> triangles;
};

/// The index of the triangle seen at a pixel, −1 where there is none.
using VisibleTriangles = Image<std::int32_t>;

/// A rung: says what is seen. Right is, at each pixel, the triangle that covers its centre
/// (rasterize.h) at the smallest distance; of equals, the earliest. In perspective 1/distance, not
/// distance, is linear in the window:
///
///   1/d = Σ wᵢ/dᵢ with the barycentric weights wᵢ of the pixel's centre.
///
/// A triangle without area covers nothing. Throws CheckError for corners beyond ±32768 pixels.
/// Cost: one step per pixel that a triangle covers.
///
/// Source: B.zbuffer, C.3.
using VisibilityFunction = VisibleTriangles (*)(const VisibilityScene& scene);

/// Each triangle over those before it.
VisibleTriangles seen_by_draw_order(const VisibilityScene& scene);

/// The painter's algorithm: triangles sorted by the mean distance of their corners, the farthest
/// first; of equals, the later first, so that the earlier stays (Newell, Newell, Sancha, "A
/// solution to the hidden surface problem", 1972, without its splitting).
VisibleTriangles seen_by_painter(const VisibilityScene& scene);

/// Depth buffers (Catmull 1974) that store far/(far − near) · (1 − near/d), 0 near and 1 far,
/// rounded to nearest into 16 or 24 bit or a float; less is nearer.
VisibleTriangles seen_by_zbuffer_16(const VisibilityScene& scene);
VisibleTriangles seen_by_zbuffer_24(const VisibilityScene& scene);
VisibleTriangles seen_by_zbuffer_float(const VisibilityScene& scene);

/// A depth buffer that stores near/d as a float, 1 near and toward 0 far, so that the float's fine
/// steps around 0 are where perspective crowds the far distances; more is nearer, and the far plane
/// may be infinite (Lapidous and Jiao, "Optimal depth buffer for low-cost graphics hardware", 1999;
/// Reed, "Depth precision visualized", 2015).
VisibleTriangles seen_by_zbuffer_reversed(const VisibilityScene& scene);

struct VisibilityRung {
  const char* name;
  VisibilityFunction seen;
  const char* known_fault;
};

/// The rungs, worst first.
extern const std::array<VisibilityRung, 6> visibility_ladder;

}  // namespace rasterlab
