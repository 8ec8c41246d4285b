// Reading a texture in double precision, by every filter of stage 06, from the filters' published
// definitions. Shares nothing with the stages.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"

#include "tests/oracle/ray_caster.h"
#include "tests/oracle/shading.h"

#include <string>
#include <vector>

#include <Eigen/Dense>

namespace rasterlab::oracle {

/// A picture and its smaller copies, each texel the mean of the area it stands for, rounded to 8
/// bit, halves up.
class DeepTexture {
 public:
  explicit DeepTexture(const Image<Rgb8>& image);

  struct Level {
    int width;
    int height;
    std::vector<Eigen::Vector3d> texels;  ///< row by row from the bottom, in [0, 1]
  };

  const std::vector<Level>& levels() const { return levels_; }

 private:
  std::vector<Level> levels_;
};

/// What a pixel sees of a texture: where its centre is, and the exact steps to its neighbours.
struct Steps {
  Eigen::Vector2d uv;
  Eigen::Vector2d dx;
  Eigen::Vector2d dy;
};

/// The colour by a filter (nearest, bilinear, mip-mapped, trilinear, anisotropic) and a way to wrap
/// (repeat, clamp, mirror), as --filter and --wrap name them.
Shade sample(const DeepTexture& texture, const std::string& filter, const std::string& wrap,
             const Steps& steps);

/// Steps at a hit of window point (x, y): differences over a ten-thousandth of a pixel on the
/// face's plane as it is drawn.
Steps steps_at(const RayCaster& witness, const Surface& surface, double x, double y,
               const Hit& hit);

}  // namespace rasterlab::oracle
