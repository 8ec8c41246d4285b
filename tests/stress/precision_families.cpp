// Depth and attributes of the engine against 128-bit floats, in a picture of 48 × 48.
#include "common/engine/renderer.h"
#include "common/triangles/rasterize.h"

#include "tests/engine/encode_shader.h"
#include "tests/stress/family.h"

#include <cmath>

namespace rasterlab::stress {
namespace {

__extension__ using Float128 = __float128;

constexpr int size = 48;
constexpr std::size_t per_triangle = 12;
/// What docs/engine.md promises; the picture's 24 bits add half of 2^-24.
constexpr double attribute_allowed = 2.4e-7 + 3e-8;
constexpr double depth_allowed = 3e-7;

using Corners = std::array<Eigen::Vector4f, 3>;

Corners corners_of(const Numbers& numbers, std::size_t first) {
  Corners corners;
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t k = 0; k < 4; ++k) {
      corners[c][static_cast<Eigen::Index>(k)] = static_cast<float>(numbers[first + 4 * c + k]);
    }
  }
  return corners;
}

/// In front of the eye, between near and far, near the picture: nothing is clipped.
bool wholly_seen(const Corners& corners) {
  return std::all_of(corners.begin(), corners.end(), [](const Eigen::Vector4f& p) {
    return p.w() > 0 && std::abs(p.x()) <= 20 * p.w() && std::abs(p.y()) <= 20 * p.w() &&
           std::abs(p.z()) <= p.w();
  });
}

/// The exact depth and, of attributes, value at the centres of pixels.
class Plane {
 public:
  explicit Plane(const Corners& corners) {
    std::array<Eigen::Vector2f, 3> window;
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector4f& p = corners[i];
      window[i] = {(p.x() / p.w() + 1) * (size / 2.0F), (1 - p.y() / p.w()) * (size / 2.0F)};
      w_[i] = p.w();
      depth_[i] = (static_cast<Float128>(p.w()) - p.z()) / 2 / p.w();
      largest_ = std::max(largest_, depth_[i]);
    }
    edges_ = make_edges(snap(window));
  }

  Float128 depth(int x, int y) const {
    Float128 z = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      z += static_cast<Float128>(edges_.edges[i].at(x, y)) * depth_[i] / edges_.twice_area;
    }
    return z;
  }

  Float128 attribute(int x, int y, const std::array<float, 3>& at_corner) const {
    Float128 sum = 0;
    Float128 value = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Float128 weight = static_cast<Float128>(edges_.edges[i].at(x, y)) / w_[i];
      sum += weight;
      value += weight * at_corner[i];
    }
    return value / sum;
  }

  /// Of the corners, nearest being 1.
  Float128 largest_depth() const { return largest_; }

 private:
  TriangleEdges edges_{};
  std::array<Float128, 3> w_;
  std::array<Float128, 3> depth_;
  Float128 largest_ = 0;
};

const Mesh& unit_mesh() {
  static const Mesh mesh = {.positions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                            .normals = {},
                            .colors = {},
                            .texture_coordinates = {},
                            .triangles = {{0, 1, 2}}};
  return mesh;
}

/// The mesh's vertices are the unit vectors: the columns of the matrix are the corners.
void draw(const Corners& corners, const Shading& shading, Framebuffer& frame) {
  static const PreparedMesh prepared(unit_mesh());
  thread_local Renderer renderer({.threads = 1, .skip = {}});
  Eigen::Matrix4f matrix = Eigen::Matrix4f::Zero();
  for (int i = 0; i < 3; ++i) matrix.col(i) = corners[static_cast<std::size_t>(i)];
  renderer.draw({.mesh = &prepared, .matrix = matrix, .shading = shading}, frame);
}

/// Three corners in clip space, then an attribute's value at each.
Numbers w_ratios(Random& random) {
  Numbers numbers;
  const double ratio = random.pick({1, 10, 1e5});
  Eigen::Vector2d first(0, 0);
  Eigen::Vector2d second(0, 0);
  for (int i = 0; i < 3; ++i) {
    Eigen::Vector2d ndc(random.number(-1.5, 1.5), random.number(-1.5, 1.5));
    if (i == 2 && random.chance(0.4)) {  // seen at a grazing angle
      ndc = first + random.number(-0.5, 1.5) * (second - first) +
            Eigen::Vector2d(random.number(-0.03, 0.03), random.number(-0.03, 0.03));
    }
    (i == 0 ? first : second) = ndc;
    const double w = std::exp(random.number(0, std::log(ratio)));
    numbers.insert(numbers.end(), {ndc.x() * w, ndc.y() * w, w - 2 * random.number(0, 1), w});
  }
  for (int i = 0; i < 3; ++i) numbers.push_back(random.number(0, 1));
  return numbers;
}

void check_interpolation(const Numbers& numbers, Verdict& verdict) {
  if (numbers.size() != per_triangle + 3) return;
  const Corners corners = corners_of(numbers, 0);
  std::array<float, 3> attribute;
  for (std::size_t i = 0; i < 3; ++i) attribute[i] = static_cast<float>(numbers[per_triangle + i]);
  const bool in_range = std::all_of(attribute.begin(), attribute.end(),
                                    [](float value) { return value >= 0 && value <= 1; });
  if (!wholly_seen(corners) || !in_range) return;
  const EncodeShader shader = {attribute};
  Framebuffer frame(size, size);
  draw(corners, shading(shader), frame);
  const Image<float> depth = frame.depth();
  const Image<std::int32_t> ids = frame.ids();
  const Plane plane(corners);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      if (ids.row(y)[x] < 0) continue;
      const Rgb8& pixel = frame.color().row(y)[x];
      const double attribute_error = std::abs(static_cast<double>(
          decode(pixel.r, pixel.g, pixel.b) - plane.attribute(x, y, attribute)));
      verdict.expect_error(attribute_error, attribute_allowed, [&] {
        return "an attribute is off by " + std::to_string(attribute_error * 1e7) + "e-7";
      });
      const double depth_error = std::abs(static_cast<double>(
          (static_cast<Float128>(depth.row(y)[x]) - plane.depth(x, y)) / plane.largest_depth()));
      verdict.expect_error(depth_error, depth_allowed, [&] {
        return "a depth is off by " + std::to_string(depth_error * 1e7) +
               "e-7 of the largest corner's";
      });
    }
  }
}

/// A triangle, then how much nearer the second one is, as a part of w.
Numbers depth_pairs(Random& random) {
  Numbers numbers;
  const double distance = std::pow(10, random.number(0, 5));
  for (int i = 0; i < 3; ++i) {
    const double w = distance * random.number(1, 1.5);
    numbers.insert(numbers.end(),
                   {random.number(-1.5, 1.5) * w, random.number(-1.5, 1.5) * w, w - 2, w});
  }
  numbers.push_back(std::pow(10, -random.number(1, 7)));
  return numbers;
}

void check_pair(const Numbers& numbers, Verdict& verdict) {
  if (numbers.size() != per_triangle + 1) return;
  const Corners far = corners_of(numbers, 0);
  Corners near = far;
  const auto factor = static_cast<float>(1 - numbers[per_triangle]);
  for (Eigen::Vector4f& p : near) {
    p.head<2>() *= factor;  // the same place in the window, but for rounding
    p.w() *= factor;
    p.z() = p.w() - 2;
  }
  if (!wholly_seen(far) || !wholly_seen(near)) return;
  Framebuffer frame(size, size);
  draw(far, {}, frame);
  const Image<std::int32_t> before = frame.ids();
  draw(near, {}, frame);
  const Image<std::int32_t> after = frame.ids();
  const Plane far_plane(far);
  const Plane near_plane(near);
  Framebuffer alone(size, size);
  draw(near, {}, alone);
  const Image<std::int32_t> covered_by_near = alone.ids();
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      if (before.row(y)[x] < 0 || covered_by_near.row(y)[x] < 0) continue;
      const Float128 gap = near_plane.depth(x, y) - far_plane.depth(x, y);
      const Float128 least =
          depth_allowed * (near_plane.largest_depth() + far_plane.largest_depth());
      if (gap > -least && gap < least) continue;  // nearer than depths are told apart
      const bool second_seen = after.row(y)[x] != before.row(y)[x];
      verdict.expect(second_seen == (gap > 0),
                     [] { return "the triangle that is farther away is seen"; });
    }
  }
}

}  // namespace

std::vector<Family> precision_families() {
  return {
      {"w_ratios",
       "with w ratios to 1e5 and at grazing angles attributes on [0, 1] are right to 2.4e-7, "
       "depths "
       "to 3e-7 of the largest corner's",
       0, 0, w_ratios, check_interpolation},
      {"depth_pairs",
       "of two triangles 1e-1 … 1e-7 of their distance apart the nearer one is seen where their "
       "depths differ by more than depth's error",
       0, 0, depth_pairs, check_pair},
  };
}

}  // namespace rasterlab::stress
