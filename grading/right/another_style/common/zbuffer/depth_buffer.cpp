// A right answer written differently: the comparison the other way about, the buffer made anew.
#include "common/zbuffer/depth_buffer.h"

#include <algorithm>

namespace rasterlab {

DepthBuffer::DepthBuffer(int width, int height) : depths_(width, height, 1.0F) {}

bool DepthBuffer::test(int x, int y, float z) const {
  const float stored = depths_(x, y);
  return stored > z;
}

void DepthBuffer::write(int x, int y, float z) {
  float& stored = depths_(x, y);
  stored = z;
}

void DepthBuffer::clear() {
  std::fill(depths_.pixels().begin(), depths_.pixels().end(), 1.0F);
}

}  // namespace rasterlab
