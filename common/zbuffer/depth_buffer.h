// Exercise 03.1: the depth buffer, which remembers for every pixel how near the nearest thing drawn
// there is.
#pragma once

#include "common/image/image.h"

namespace rasterlab {

/// One depth per pixel, as NDC z: near −1, far +1. Cleared to +1, the farthest, so that whatever is
/// nearer is drawn. Pixels as in Image: (0, 0) at the top left.
///
/// Source: A.Q26 (a buffer of doubles beside the image), C.3.
class DepthBuffer {
 public:
  /// As large as the image it belongs to, and cleared. Throws CheckError as Image does.
  DepthBuffer(int width, int height);

  int width() const { return depths_.width(); }
  int height() const { return depths_.height(); }

  /// Whether something at depth z would be seen at pixel (x, y): z is nearer (less) than what is
  /// stored. What is as far as the stored depth is not seen, so of two equal the earlier stays;
  /// neither is a z that is not a number. Changes nothing. Throws CheckError outside.
  bool test(int x, int y, float z) const;

  /// Stores z at pixel (x, y), whatever was there. Throws CheckError outside.
  void write(int x, int y, float z);

  /// Forgets everything: +1 everywhere.
  void clear();

  /// The stored depths, as to be shown or saved.
  const Image<float>& depths() const { return depths_; }

 private:
  Image<float> depths_;
};

}  // namespace rasterlab
