#include "common/lighting/turned_light.h"

#include "common/image/check.h"
#include "common/projection/rotation.h"
#include "common/projection/viewport.h"

namespace rasterlab {

Light turned_light(const Light& light, const Eigen::Vector3f& center, const Eigen::Vector3f& axis,
                   float angle) {
  // <solution>
  Light turned = light;
  turned.position =
      translation(center) * (rotation(angle, axis) * (translation(-center) * light.position));
  return turned;
  // <starter> throw NotWritten("05.6", light, center, axis, angle);
  // </solution>
}

}  // namespace rasterlab
