// What the pixels of a drawn mesh see, without a rounding error to speak of.
#pragma once

#include "common/image/check.h"
#include "common/lighting/lit_mesh.h"
#include "common/projection/vertex_stage.h"
#include "common/triangles/edge_function.h"

#include "bench/support/oracle_number.h"

#include <array>

namespace rasterlab::bench {

/// The triangles of a mesh in clip space, where perspective-correct weights are exact but for the
/// oracle's own rounding. The vertices' floats are taken as given, and so is their place in the
/// window on 1/256 pixel: that is the model which every drawing of it implements.
class ExactPoints {
 public:
  ExactPoints(const Mesh& mesh, const Transforms& transforms, int width, int height)
      : mesh_(mesh), to_clip_(transforms.to_clip()), width_(width), height_(height) {}

  /// The weights of a triangle's corners at a pixel's centre. For triangles in front of the eye.
  template <class Scalar>
  std::array<OracleNumber<Scalar>, 3> weights(std::uint32_t triangle, int x, int y) const {
    std::array<Eigen::Vector2f, 3> window;
    std::array<Scalar, 3> over_w;
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector4f clip = to_clip(to_clip_, mesh_.positions[mesh_.triangles[triangle][i]]);
      if (!(clip.w() > 0)) throw CheckError("a triangle reaches behind the eye");
      window[i] = to_window(clip, width_, height_).position;
      over_w[i] = 1 / Scalar(clip.w());
    }
    const TriangleEdges edges = make_edges(snap(window));
    Scalar sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      over_w[i] *= static_cast<Scalar>(edges.edges[i].at(x, y));
      sum += over_w[i];
    }
    std::array<OracleNumber<Scalar>, 3> weights;
    for (std::size_t i = 0; i < 3; ++i) weights[i] = OracleNumber<Scalar>(Scalar(over_w[i] / sum));
    return weights;
  }

 private:
  const Mesh& mesh_;
  Eigen::Matrix4f to_clip_;
  int width_;
  int height_;
};

/// A value given in floats at the corners, mixed by weights.
template <class Number>
Vector3<Number> mixed(const std::array<Number, 3>& weights,
                      const std::array<Vector3<Number>, 3>& corners) {
  Vector3<Number> sum = broadcast<Number>(Eigen::Vector3f::Zero());
  for (std::size_t i = 0; i < 3; ++i) {
    for (int c = 0; c < 3; ++c) sum[c] += weights[i] * corners[i][c];
  }
  return sum;
}

}  // namespace rasterlab::bench
