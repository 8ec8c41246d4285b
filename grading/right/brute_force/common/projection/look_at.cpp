// A right answer written differently: number by number, as the manual pages of OpenGL have it.
#include "common/projection/look_at.h"

#include "common/image/check.h"

#include <cmath>

namespace rasterlab {
namespace {

struct Axis {
  double x, y, z;
};

Axis unit(Axis a) {
  const double length = std::hypot(a.x, a.y, a.z);
  return length > 0 ? Axis{a.x / length, a.y / length, a.z / length} : Axis{0, 0, 0};
}

Axis across(Axis a, Axis b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace

Eigen::Matrix4f look_at(const Eigen::Vector3f& eye, const Eigen::Vector3f& center,
                        const Eigen::Vector3f& up) {
  const double ex = eye.x(), ey = eye.y(), ez = eye.z();
  Axis back = unit({ex - center.x(), ey - center.y(), ez - center.z()});
  if (back.x == 0 && back.y == 0 && back.z == 0) back.z = 1;
  Axis side = across(unit({up.x(), up.y(), up.z()}), back);
  if (std::hypot(side.x, side.y, side.z) < 1e-7) {
    const double x = std::fabs(back.x), y = std::fabs(back.y), z = std::fabs(back.z);
    const Axis least = x <= y && x <= z ? Axis{1, 0, 0} : y <= z ? Axis{0, 1, 0} : Axis{0, 0, 1};
    side = across(least, back);
  }
  side = unit(side);
  const Axis above = across(back, side);
  const auto moved = [&](Axis a) { return -(a.x * ex + a.y * ey + a.z * ez); };
  Eigen::Matrix4d m;
  m << side.x, side.y, side.z, moved(side),     //
      above.x, above.y, above.z, moved(above),  //
      back.x, back.y, back.z, moved(back),      //
      0, 0, 0, 1;
  return m.cast<float>();
}

}  // namespace rasterlab
