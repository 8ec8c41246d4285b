// Texture coordinates along rows of pixels: what attributes.cpp measures, compiled once per
// instruction set.
#pragma once

#include "common/engine/compiled_simd_targets.h"

#include <array>
#include <cstdint>
#include <span>

namespace rasterlab::bench {

/// a · x + b · y + c, x and y in pixels from wherever the constant holds.
struct Plane {
  float a = 0;
  float b = 0;
  float c = 0;
};

/// Up to 64 pixels of one row, all in one tile of 64 × 64, and what is known of the triangle there.
struct AttributeRow {
  static constexpr int most = 64;

  float x = 0;  ///< the first pixel's centre, from the picture's origin …
  float y = 0;
  float x_in_tile = 0;  ///< … and from the tile's
  float y_in_tile = 0;
  int count = 0;

  // u/w, v/w and 1/w: linear in the window.
  std::array<Plane, 3> from_origin;
  std::array<Plane, 3> from_tile;

  // Edge functions of corners 1 and 2 and their sum with that of corner 0, exact, at the first
  // pixel; and per pixel to the right.
  double edge1 = 0, edge2 = 0, area = 0;
  double step1 = 0, step2 = 0;
  float ratio1 = 0, ratio2 = 0;  ///< w of corner 0 by that of corner 1, and of corner 2
  std::array<float, 3> u{};      ///< of the corners, in texels
  std::array<float, 3> v{};
};

/// Writes u and v of the row's pixels, and on to a whole number of SIMD vectors: `u` and `v` have
/// room for 16 more than the row has pixels.
using AttributeFunction = void (*)(const AttributeRow& row, float* u, float* v);

struct AttributeRung {
  const char* name;
  AttributeFunction evaluate;
  int run_length;  ///< pixels from one exact one to the next; 0: all are exact
  const char* known_fault;
};

/// Each setup with each division; and, last first to come, runs that are affine between their ends.
#define RASTERLAB_DECLARE_ATTRIBUTES(simd)            \
  namespace simd_##simd {                             \
    std::span<const AttributeRung> attribute_rungs(); \
    std::span<const AttributeRung> affine_rungs();    \
  }
RASTERLAB_EACH_SIMD_TARGET(RASTERLAB_DECLARE_ATTRIBUTES)
#undef RASTERLAB_DECLARE_ATTRIBUTES

}  // namespace rasterlab::bench
