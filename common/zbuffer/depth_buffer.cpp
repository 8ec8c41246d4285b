#include "common/zbuffer/depth_buffer.h"

namespace rasterlab {

namespace {
constexpr float farthest = 1;
}

DepthBuffer::DepthBuffer(int width, int height) : depths_(width, height, farthest) {}

bool DepthBuffer::test(int x, int y, float z) const {
  return z < depths_(x, y);
}

void DepthBuffer::write(int x, int y, float z) {
  depths_(x, y) = z;
}

void DepthBuffer::clear() {
  depths_.clear(farthest);
}

}  // namespace rasterlab
