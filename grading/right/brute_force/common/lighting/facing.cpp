// A right answer written differently: the determinant by its three minors, each exactly zero where
// two corners are the same.
#include "common/lighting/facing.h"

#include "common/image/check.h"

namespace rasterlab {

Facing facing(const std::array<Eigen::Vector4f, 3>& clip, bool mirrored) {
  const Eigen::Vector4f &a = clip[0], &b = clip[1], &c = clip[2];
  const auto minor = [&](int row, int other) {
    return double(b[row]) * double(c[other]) - double(b[other]) * double(c[row]);
  };
  const int x = 0, y = 1, w = 3;
  const double volume = a[x] * minor(y, w) + a[y] * minor(w, x) + a[w] * minor(x, y);
  if (volume == 0) return Facing::edge_on;
  return (volume > 0) == mirrored ? Facing::back : Facing::front;
}

}  // namespace rasterlab
