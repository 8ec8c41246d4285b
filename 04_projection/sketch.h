// Drawings in the plane for exercises 04.1 and 04.2.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"

#include <span>

#include <Eigen/Dense>

namespace rasterlab {

/// A square picture of the plane around the origin, in the course's frame: x right, y up. Turned
/// over here, where it becomes pixels.
class Sketch {
 public:
  /// Shows [−extent, extent]², with the axes.
  Sketch(int size, float extent);

  void segment(const Eigen::Vector2f& a, const Eigen::Vector2f& b, const Rgb8& color);

  /// A point, three pixels wide.
  void dot(const Eigen::Vector2f& point, const Rgb8& color);

  /// A letter that looks like none of its mirror images, moved by a 2D transform.
  void letter(const Eigen::Matrix3f& transform, const Rgb8& color);

  const Image<Rgb8>& image() const { return image_; }

 private:
  Eigen::Vector2i pixel(const Eigen::Vector2f& point) const;

  float extent_;
  Image<Rgb8> image_;
};

}  // namespace rasterlab
