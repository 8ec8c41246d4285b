// What is drawn into: colour, depth, and what a user may ask for beside them.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/zbuffer/depth_buffer.h"

#include <cstdint>
#include <limits>

namespace rasterlab {

/// Pictures of one size, drawn together.
struct Frame {
  Image<Rgb8> color;
  DepthBuffer depth;

  /// Positive distance along the view axis, +∞ where nothing was drawn. Empty: not asked for.
  Image<float> distance = {};
  /// Index of the visible triangle, −1 where nothing was drawn. Empty: not asked for.
  Image<std::int32_t> ids = {};

  int width() const { return color.width(); }
  int height() const { return color.height(); }
};

/// A black frame where nothing was drawn yet, without distances and ids.
inline Frame make_frame(int width, int height) {
  return {.color = Image<Rgb8>(width, height), .depth = DepthBuffer(width, height)};
}

/// As before anything was drawn.
inline void clear(Frame& frame) {
  frame.color.clear({});
  frame.depth.clear();
  frame.distance.clear(std::numeric_limits<float>::infinity());
  frame.ids.clear(-1);
}

}  // namespace rasterlab
