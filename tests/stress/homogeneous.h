// Which pixels a triangle in clip space covers, in 128-bit floats and without clipping it: by its
// edge functions in homogeneous coordinates (Olano and Greer, "Triangle Scan Conversion using 2D
// Homogeneous Coordinates", 1997).
#pragma once

#include "common/projection/clip.h"

#include <algorithm>
#include <array>

namespace rasterlab::stress {

__extension__ using Float128 = __float128;

/// A function of the window that is linear in its pixels: a·x + b·y + c.
struct WindowFunction {
  Float128 a = 0;
  Float128 b = 0;
  Float128 c = 0;

  Float128 at_center(int x, int y) const { return a * (x + 0.5) + b * (y + 0.5) + c; }

  /// Its sign everywhere within `reach` of the centre of pixel (x, y); 0 where it has both.
  int sign_around(int x, int y, double reach) const {
    const Float128 value = at_center(x, y);
    const Float128 change = reach * ((a < 0 ? -a : a) + (b < 0 ? -b : b));
    return value > change ? 1 : value < -change ? -1 : 0;
  }
};

/// A triangle, seen in a picture of width × height, whose corners may be behind the eye.
class HomogeneousTriangle {
 public:
  using Corner = std::array<Float128, 4>;

  HomogeneousTriangle(const std::array<Corner, 3>& corners, int width, int height) {
    std::array<std::array<Float128, 3>, 3> edge;  // times (x, y, w) of a point: which side it is on
    for (std::size_t i = 0; i < 3; ++i) {
      const Corner& a = corners[(i + 1) % 3];
      const Corner& b = corners[(i + 2) % 3];
      const auto minor = [&](std::size_t j, std::size_t k) { return a[j] * b[k] - a[k] * b[j]; };
      edge[i] = {minor(1, 3), minor(3, 0), minor(0, 1)};
    }
    const Float128 determinant =
        edge[0][0] * corners[0][0] + edge[0][1] * corners[0][1] + edge[0][2] * corners[0][3];
    orientation_ = determinant > 0 ? 1 : determinant < 0 ? -1 : 0;
    for (std::size_t i = 0; i < 3; ++i) {
      if (determinant < 0) edge[i] = {-edge[i][0], -edge[i][1], -edge[i][2]};
      edges_[i] = in_window(edge[i], width, height);
    }
    // z and w at a point of the window, but for the same positive factor, are mixed of the corners'
    // by what the edge functions are there.
    const auto mixed = [&](Float128 of_z, Float128 of_w) {
      WindowFunction sum;
      for (std::size_t i = 0; i < 3; ++i) {
        const Float128 at_corner = of_z * corners[i][2] + of_w * corners[i][3];
        sum.a += at_corner * edges_[i].a;
        sum.b += at_corner * edges_[i].b;
        sum.c += at_corner * edges_[i].c;
      }
      return sum;
    };
    z_ = mixed(1, 0);
    w_ = mixed(0, 1);
    constexpr double margin = 1e-4;  // of w: how far from the planes nothing is said
    inside_planes_ = {mixed(1, 1 - margin), mixed(-1, 1 - margin)};
    outside_planes_ = {mixed(-1, -1 - margin), mixed(1, -1 - margin)};
  }

  HomogeneousTriangle(const ClipTriangle& corners, int width, int height)
      : HomogeneousTriangle(
            std::array<Corner, 3>{exact(corners[0]), exact(corners[1]), exact(corners[2])}, width,
            height) {}

  /// 1 where its corners go counter-clockwise as seen, −1 clockwise, 0 where the eye is in its
  /// plane and nothing else here means anything.
  int orientation() const { return orientation_; }
  bool usable() const { return orientation_ != 0; }

  /// Whether z/w is within `margin` of the far plane's 1 at the centre of pixel (x, y).
  bool near_far_plane(int x, int y, double margin) const {
    const Float128 w = w_.at_center(x, y);
    const Float128 beyond = z_.at_center(x, y) - w;
    const Float128 reach = margin * (w < 0 ? -w : w);
    return !(beyond > reach || beyond < -reach);
  }

  /// Whether the centre of pixel (x, y) is more than `reach` pixels inside the first edges, of
  /// which edge i lies across from corner i, and between near and far plane.
  bool clearly_inside(int x, int y, double reach, std::size_t edges = 3) const {
    for (std::size_t i = 0; i < edges; ++i) {
      if (edges_[i].sign_around(x, y, reach) <= 0) return false;
    }
    return std::all_of(inside_planes_.begin(), inside_planes_.end(),
                       [&](const auto& plane) { return plane.sign_around(x, y, reach) > 0; });
  }

  enum class Truth { covered, not_covered, too_close };

  /// `reach`: how far from an edge, in pixels, nothing is said, because single-precision cuts and
  /// snapping move an edge.
  Truth truth_at(int x, int y, double reach) const {
    for (const WindowFunction& edge : edges_) {
      if (edge.sign_around(x, y, reach) < 0) return Truth::not_covered;
    }
    for (const WindowFunction& plane : outside_planes_) {
      if (plane.sign_around(x, y, reach) > 0) return Truth::not_covered;
    }
    return clearly_inside(x, y, reach) ? Truth::covered : Truth::too_close;
  }

 private:
  static Corner exact(const Eigen::Vector4f& p) { return {p.x(), p.y(), p.z(), p.w()}; }

  /// Of x/w = x·2/width − 1 and y/w = 1 − y·2/height.
  static WindowFunction in_window(const std::array<Float128, 3>& of_point, int width, int height) {
    return {of_point[0] * 2 / width, -of_point[1] * 2 / height,
            of_point[2] - of_point[0] + of_point[1]};
  }

  std::array<WindowFunction, 3> edges_;
  WindowFunction z_, w_;
  std::array<WindowFunction, 2> inside_planes_;   ///< above 0: clearly between near and far
  std::array<WindowFunction, 2> outside_planes_;  ///< above 0: clearly cut away by near, by far
  int orientation_ = 0;
};

}  // namespace rasterlab::stress
