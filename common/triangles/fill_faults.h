// Exercise 02.6: what was hoped for of a fill, measured.
#pragma once

#include "common/triangles/coverage.h"
#include "common/triangles/fill_ladder.h"

#include <string>
#include <vector>

namespace rasterlab {

/// Triangles in a square picture.
struct TriangleSample {
  std::string name;
  int size;  ///< of the picture, in pixels
  std::vector<Corners> triangles;
};

/// Faults of a way to fill, per million pixels that are exactly covered.
struct FillFaults {
  double missing = 0;  ///< covered but not drawn: gaps
  double extra = 0;    ///< drawn but not covered
  double doubled = 0;  ///< drawn by more triangles than cover it, where some do: overlaps
  double order = 0;  ///< not the same when the corners come in another order, the worst of the six
  double translation = 0;  ///< not the same when all is moved by whole pixels
  double rotation = 0;     ///< not the same when all is turned by 90° about the picture's middle
};

/// Compares with how often each pixel is covered exactly, by its centre with the top-left rule, in
/// 128-bit integers after snapping to 1/256 pixel; and with what `fill` itself draws of the same
/// triangles given otherwise. Triangles are within the picture and ±32768.
///
/// Source: B.quality.
FillFaults fill_faults(FillTriangle fill, const TriangleSample& sample);

/// Random triangles one by one; a disc cut into triangles; a grid whose vertices are shaken, half
/// of them onto pixel centres; slivers one by one. The same at every call; vertices on 1/256 pixel.
std::vector<TriangleSample> fill_samples();

/// How often each pixel is covered exactly.
Coverage exact_coverage(const TriangleSample& sample);

/// White where a pixel is drawn as often as covered, red where it is missing, blue where extra,
/// yellow where doubled.
Image<Rgb8> fault_picture(const Coverage& drawn, const Coverage& exact);

/// One line per rung of the ladder and sample.
std::string fill_fault_table();

}  // namespace rasterlab
