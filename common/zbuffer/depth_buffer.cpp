#include "common/zbuffer/depth_buffer.h"

#include "common/image/check.h"

namespace rasterlab {

namespace {
constexpr float farthest = 1;
}

DepthBuffer::DepthBuffer(int width, int height) : depths_(width, height, farthest) {}

bool DepthBuffer::test(int x, int y, float z) const {
  // <solution>
  return z < depths_(x, y);
  // <starter> throw NotWritten("03.1", x, y, z);
  // </solution>
}

void DepthBuffer::write(int x, int y, float z) {
  // <solution>
  depths_(x, y) = z;
  // <starter> throw NotWritten("03.1", x, y, z);
  // </solution>
}

void DepthBuffer::clear() {
  // <solution>
  depths_.clear(farthest);
  // <starter> throw NotWritten("03.1");
  // </solution>
}

}  // namespace rasterlab
