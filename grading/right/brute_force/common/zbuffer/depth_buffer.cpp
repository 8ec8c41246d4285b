// A right answer written differently: what does not hide is seen; a new image forgets.
#include "common/zbuffer/depth_buffer.h"

#include "common/image/check.h"

#include <cmath>

namespace rasterlab {

namespace {
constexpr float farthest = 1;
}

DepthBuffer::DepthBuffer(int width, int height) : depths_(width, height, farthest) {}

bool DepthBuffer::test(int x, int y, float z) const {
  if (std::isnan(z)) return false;
  return !(depths_(x, y) <= z);
}

void DepthBuffer::write(int x, int y, float z) {
  if (!depths_.contains(x, y)) throw CheckError("no such pixel");
  depths_.row(y)[x] = z;
}

void DepthBuffer::clear() {
  depths_ = Image<float>(width(), height(), 1.0F);
}

}  // namespace rasterlab
