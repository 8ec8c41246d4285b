#include "common/image/check.h"
#include "common/projection/clip.h"
#include "common/triangles/fixed_point.h"

#include <bit>
#include <string>

namespace rasterlab {

Eigen::Vector2f guard_band(int width, int height) {
  static_assert(longest_side < max_coordinate);
  if (width < 1 || height < 1 || width > longest_side || height > longest_side) {
    throw CheckError("a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                     " pixels cannot be drawn: sides are 1 to " + std::to_string(longest_side));
  }
  const auto band = [](int side) {
    return static_cast<float>(std::bit_floor(static_cast<unsigned>(max_coordinate / side)));
  };
  return {band(width), band(height)};
}

const std::array<ClipRung, 3> clip_ladder = {{
    {"drop", &clip_drop, "a triangle that reaches behind the eye is missing as a whole"},
    {"near", &clip_near,
     "neighbours cut a shared edge from opposite ends and may disagree in the last bit; what "
     "reaches "
     "far beyond the picture is lost"},
    {"homogeneous", &clip_homogeneous,
     "none but where the eye is in the triangle's plane, as nearly as a float can say"},
}};

}  // namespace rasterlab
