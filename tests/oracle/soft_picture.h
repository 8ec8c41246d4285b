// A texture to compare pictures with: no picture's pixels depend much on where exactly it is read.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"

#include <random>

#include <Eigen/Dense>

namespace rasterlab::oracle {

/// Random colours, blended from texel to texel, with sides that are no powers of two. Smooth, so
/// that the 1/512 px by which snapping may move a texture shows as less than a code value.
inline Image<Rgb8> soft_picture() {
  std::mt19937 random(5);
  Image<Rgb8> image(60, 44);
  Image<Eigen::Vector3d> knots(8, 6);
  for (Eigen::Vector3d& knot : knots.pixels()) {
    for (double& channel : knot) channel = static_cast<double>(random() % 256);
  }
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const double u = x / 60.0 * 7;
      const double v = y / 44.0 * 5;
      const int i = static_cast<int>(u);
      const int j = static_cast<int>(v);
      const Eigen::Vector3d above = knots(i, j) + (u - i) * (knots(i + 1, j) - knots(i, j));
      const Eigen::Vector3d below =
          knots(i, j + 1) + (u - i) * (knots(i + 1, j + 1) - knots(i, j + 1));
      const Eigen::Vector3d color = above + (v - j) * (below - above);
      image(x, y) = {static_cast<std::uint8_t>(color.x()), static_cast<std::uint8_t>(color.y()),
                     static_cast<std::uint8_t>(color.z())};
    }
  }
  return image;
}

}  // namespace rasterlab::oracle
