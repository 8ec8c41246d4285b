#include "bench/projection/clipping.h"

#include "common/image/image.h"
#include "common/projection/clip.h"
#include "common/projection/perspective.h"
#include "common/projection/triangle_pixels.h"
#include "common/projection/vertex_stage.h"

#include "bench/support/quad.h"
#include "bench/support/random_number.h"

#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <vector>

namespace rasterlab::bench {
namespace {

constexpr int size = 256;
constexpr int cells = 12;
constexpr float eye_height = 0.7F;
constexpr float near = 0.1F;

/// The floor's triangles in clip space. The camera stands at the origin and looks along −z, level.
std::vector<ClipTriangle> floor_triangles(double extent) {
  std::mt19937 random(23);
  const Eigen::Matrix4f projection =
      perspective(90, 1, near, std::numeric_limits<float>::infinity());
  std::vector<Eigen::Vector4f> vertices;
  for (int row = 0; row <= cells; ++row) {
    for (int column = 0; column <= cells; ++column) {
      const auto place = [&](int index) {
        const bool at_edge = index == 0 || index == cells;
        const double jitter = at_edge ? 0 : random_number(random, -0.3, 0.3);
        return static_cast<float>(extent * (2 * (index + jitter) / cells - 1));
      };
      const float x = place(column);
      vertices.push_back(to_clip(projection, {x, -eye_height, place(row)}));
    }
  }
  std::vector<ClipTriangle> triangles;
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      const auto at = [&](int below, int right) {
        const int index = (row + below) * (cells + 1) + column + right;
        return vertices[static_cast<std::size_t>(index)];
      };
      triangles.push_back({at(0, 0), at(1, 0), at(1, 1)});
      triangles.push_back({at(0, 0), at(1, 1), at(0, 1)});
    }
  }
  return triangles;
}

/// Whether the line of sight through a pixel's centre meets the floor before its end, beyond the
/// near plane; in a kind of number that makes no difference to the answer but on the edge itself.
template <class Number>
bool sees_floor(int x, int y, double extent) {
  const Number right = (2 * Number(x) + 1) / size - 1;
  const Number down = (2 * Number(y) + 1) / size - 1;
  if (down <= 0) return false;
  const Number distance = Number(eye_height) / down;
  const Number sideways = right * distance;
  return distance >= Number(near) && distance <= Number(extent) && sideways >= -Number(extent) &&
         sideways <= Number(extent);
}

Errors errors_of(ClipFunction clip, const std::vector<ClipTriangle>& triangles, double extent) {
  Image<std::int32_t> times(size, size);
  TriangleCounts counts;
  for (const ClipTriangle& triangle : triangles) {
    for_each_pixel(triangle, size, size, {.clip = clip}, counts,
                   [&](const TrianglePixel& pixel) { ++times.row(pixel.y)[pixel.x]; });
  }
  MeasuredError missing;
  MeasuredError extra;
  double floor_pixels = 0;
  double doubled = 0;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const bool by_double = sees_floor<double>(x, y, extent);
      const bool by_quad = sees_floor<Quad>(x, y, extent);
      const bool shown = times.row(y)[x] > 0;
      missing.add(by_double && !shown ? 1e6 : 0, by_quad && !shown ? 1e6 : 0);
      extra.add(shown && !by_double ? 1e6 : 0, shown && !by_quad ? 1e6 : 0);
      floor_pixels += by_quad ? 1 : 0;
      doubled += times.row(y)[x] > 1 ? 1e6 : 0;
    }
  }
  const double scale = size * size / floor_pixels;
  const double wrong = scale * (missing.mean() + extra.mean()) + doubled / floor_pixels;
  return {{"wrong per million", wrong},
          {"missing per million", scale * missing.mean()},
          {"extra per million", scale * extra.mean()},
          {"doubled per million", doubled / floor_pixels}};
}

}  // namespace

TimedLadder clipping_ladder(double extent) {
  const std::vector<ClipTriangle> triangles = floor_triangles(extent);
  char name[80];
  std::snprintf(name, sizeof name, "04.9 clipping, a floor %.0e to each side of the eye", extent);
  TimedLadder ladder{.name = name,
                     .stage = "04",
                     .unit = "triangle",
                     .units = static_cast<double>(triangles.size()),
                     .error = "wrong per million",
                     .rungs = {}};
  for (const ClipRung& rung : clip_ladder) {
    const auto left = std::make_shared<std::size_t>(0);
    ladder.rungs.push_back({.name = rung.name,
                            .fault = rung.known_fault,
                            .work =
                                [triangles, left, clip = rung.clip] {
                                  const Eigen::Vector2f guard = guard_band(size, size);
                                  for (const ClipTriangle& triangle : triangles)
                                    *left += clip(triangle, guard).size();
                                },
                            .errors = errors_of(rung.clip, triangles, extent)});
  }
  return ladder;
}

}  // namespace rasterlab::bench
