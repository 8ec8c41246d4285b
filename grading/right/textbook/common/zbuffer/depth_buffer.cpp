// A right answer written differently: the stored depth is asked, and every pixel set anew.
#include "common/zbuffer/depth_buffer.h"

#include "common/image/check.h"

namespace rasterlab {

namespace {
constexpr float farthest = 1;
}

DepthBuffer::DepthBuffer(int width, int height) : depths_(width, height, farthest) {}

bool DepthBuffer::test(int x, int y, float z) const {
  const float stored = depths_(x, y);
  return stored > z;
}

void DepthBuffer::write(int x, int y, float z) {
  float& stored = depths_(x, y);
  stored = z;
}

void DepthBuffer::clear() {
  for (int y = 0; y < height(); ++y) {
    for (int x = 0; x < width(); ++x) depths_(x, y) = farthest;
  }
}

}  // namespace rasterlab
