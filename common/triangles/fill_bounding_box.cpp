#include "common/triangles/fill_bounding_box.h"

#include "common/triangles/barycentric.h"
#include "common/triangles/pixel_box.h"
#include "common/triangles/pixel_corners.h"

namespace rasterlab {

void fill_bounding_box(Image<Rgb8>& image, const Corners& corners, const Rgb8& color) {
  Corners whole;
  const std::array<Point, 3> pixels = pixel_corners(corners);
  for (std::size_t i = 0; i < 3; ++i) whole[i] = pixels[i].cast<double>();
  const PixelBox box = pixel_box(corners, image.width(), image.height());
  for (int y = box.top; y <= box.bottom; ++y) {
    for (int x = box.left; x <= box.right; ++x) {
      if (barycentric(whole, {x, y}).minCoeff() >= 0) image(x, y) = color;
    }
  }
}

}  // namespace rasterlab
