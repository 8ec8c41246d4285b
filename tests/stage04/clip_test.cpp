#include "common/projection/clip.h"

#include "common/image/image.h"
#include "common/projection/draw_mesh.h"
#include "common/projection/triangle_pixels.h"

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

// How many times each pixel is covered.
Image<int> coverage(const std::vector<ClipTriangle>& triangles, int width, int height,
                    const TriangleOptions& options = {}) {
  Image<int> count(width, height, 0);
  TriangleCounts counts;
  for (const ClipTriangle& triangle : triangles) {
    for_each_pixel(triangle, width, height, options, counts,
                   [&](const TrianglePixel& pixel) { ++count(pixel.x, pixel.y); });
  }
  return count;
}

TEST(stage04_clip_homogeneous, a_corner_behind_the_eye_covers_eleven_sixteenths) {
  const ClipTriangle triangle = {Eigen::Vector4f(-.5F, -.5F, 0, 1),
                                 Eigen::Vector4f(.5F, -.5F, 0, 1), Eigen::Vector4f(0, 1, 0, -1)};
  // Twice as wide as high: no pixel's centre lies on an edge, and every row's share is a whole
  // number of pixels.
  const Image<int> count = coverage({triangle}, 32, 16);
  int covered = 0;
  for (const int pixel : count.pixels()) covered += pixel;
  EXPECT_EQ(covered, 32 * 16 * 11 / 16)
      << "the triangle goes up from its base, widening to infinity: its third corner is behind the "
         "eye";
}

}  // namespace
}  // namespace rasterlab
