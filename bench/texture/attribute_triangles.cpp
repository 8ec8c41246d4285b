#include "bench/texture/attribute_triangles.h"

#include "bench/support/random_number.h"

#include <cmath>
#include <random>

namespace rasterlab::bench {

std::vector<AttributeTriangle> attribute_triangles(double w_ratio) {
  constexpr double most = 200;  // pixels a side
  constexpr double texels = 1024;
  std::mt19937 random(29);
  std::vector<AttributeTriangle> triangles;
  while (triangles.size() < 40) {
    AttributeTriangle triangle;
    const double left = random_number(random, 0, attribute_width - most);
    const double top = random_number(random, 0, attribute_height - most);
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = left + random_number(random, 0, most);
      const double y = top + random_number(random, 0, most);
      triangle.snapped[i] = {snap(x), snap(y)};
      AttributeCorner& corner = triangle.corners[i];
      corner.w = static_cast<float>(std::pow(w_ratio, random_number(random, 0, 1)));
      corner.u = static_cast<float>(random_number(random, 0, texels));
      corner.v = static_cast<float>(random_number(random, 0, texels));
    }
    if (make_edges(triangle.snapped).twice_area > 5000 * subpixels * subpixels)
      triangles.push_back(triangle);
  }
  return triangles;
}

}  // namespace rasterlab::bench
