// Depth and attributes of the engine against 128-bit floats, in a picture of 48 × 48.
#include "common/engine/renderer.h"
#include "common/texture/perspective_ladder.h"
#include "common/triangles/rasterize.h"
#include "common/zbuffer/visibility.h"

#include "tests/engine/encode_shader.h"
#include "tests/stress/family.h"
#include "tests/stress/power_shader.h"

#include <cmath>

namespace rasterlab::stress {
namespace {

__extension__ using Float128 = __float128;

constexpr int size = 48;
constexpr std::size_t per_triangle = 12;
/// What a number written into a picture by encode() may be off by.
constexpr double encoding_error = 9e-8;
/// What docs/engine.md promises, and the picture's 24 bits.
constexpr double attribute_allowed = 2.4e-7 + encoding_error;
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

std::array<Eigen::Vector2f, 3> in_window(const Corners& corners) {
  std::array<Eigen::Vector2f, 3> window;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector4f& p = corners[i];
    window[i] = {(p.x() / p.w() + 1) * (size / 2.0F), (1 - p.y() / p.w()) * (size / 2.0F)};
  }
  return window;
}

/// The exact depth and, of attributes, value at the centres of pixels.
class Plane {
 public:
  explicit Plane(const Corners& corners) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector4f& p = corners[i];
      w_[i] = p.w();
      depth_[i] = (static_cast<Float128>(p.w()) - p.z()) / 2 / p.w();
      largest_ = std::max(largest_, depth_[i]);
    }
    edges_ = make_edges(snap(in_window(corners)));
  }

  Float128 depth(int x, int y) const { return in_picture(x, y, depth_); }

  /// 1/w, which is 1/distance.
  Float128 nearness(int x, int y) const {
    return in_picture(x, y, {1 / w_[0], 1 / w_[1], 1 / w_[2]});
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

  /// Of one of them, where all are alike.
  Float128 corner_depth() const { return depth_[0]; }

  /// Of the corners, nearest being 1.
  Float128 largest_depth() const { return largest_; }

 private:
  Float128 in_picture(int x, int y, const std::array<Float128, 3>& at_corner) const {
    Float128 sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      sum += static_cast<Float128>(edges_.edges[i].at(x, y)) * at_corner[i] / edges_.twice_area;
    }
    return sum;
  }

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

/// How many pixels each rung of the perspective ladder but the last gives an attribute that is off
/// by more than the last one's limit.
void measure_perspective(const Corners& corners, const std::array<float, 3>& attribute,
                         const Plane& plane, Verdict& verdict) {
  std::array<std::vector<Eigen::Vector3d>, size> rows;
  std::array<int, size> first{};
  rasterize_triangle(in_window(corners), size, size, [&](int x, int y, const Eigen::Vector3d& w) {
    const auto row = static_cast<std::size_t>(y);
    if (rows[row].empty()) first[row] = x;
    rows[row].push_back(w);
  });
  const Eigen::Vector3d inverse_w(1.0 / corners[0].w(), 1.0 / corners[1].w(), 1.0 / corners[2].w());
  const Eigen::Vector3d values(attribute[0], attribute[1], attribute[2]);
  const auto& ladder = perspective_ladder();
  for (std::size_t rung = 0; rung + 1 < ladder.size(); ++rung) {
    for (std::size_t row = 0; row < size; ++row) {
      std::vector<Eigen::Vector3d> weights(rows[row].size());
      if (weights.empty()) continue;
      ladder[rung].weights({inverse_w, rows[row]}, weights);
      std::int64_t wrong = 0;
      for (std::size_t i = 0; i < weights.size(); ++i) {
        const auto truth = static_cast<double>(
            plane.attribute(first[row] + static_cast<int>(i), static_cast<int>(row), attribute));
        wrong += std::abs(weights[i].dot(values) - truth) <= attribute_allowed ? 0 : 1;
      }
      verdict.measure(ladder[rung].name, static_cast<std::int64_t>(weights.size()), wrong);
    }
  }
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
  measure_perspective(corners, attribute, plane, verdict);
}

/// A triangle, then how much nearer the second one is, as a part of w.
Numbers depth_pairs(Random& random) {
  Numbers numbers;
  const double distance = std::pow(10, random.number(0, 5));
  const bool facing = random.chance(0.4);  // all corners at one distance
  for (int i = 0; i < 3; ++i) {
    const double w = facing ? distance : distance * random.number(1, 1.5);
    numbers.insert(numbers.end(),
                   {random.number(-1.5, 1.5) * w, random.number(-1.5, 1.5) * w, w - 2, w});
  }
  numbers.push_back(std::pow(10, -random.number(1, 7)));
  return numbers;
}

/// Which of two triangles each rung of the ladder has in front, in either order.
void measure_visibility(const Corners& far, const Corners& near, Verdict& verdict) {
  VisibilityScene scene{.width = size, .height = size, .near = 1, .far = 1e6F, .triangles = {}};
  for (const Corners& corners : {far, near}) {
    scene.triangles.push_back(
        {in_window(corners), {corners[0].w(), corners[1].w(), corners[2].w()}});
  }
  Image<int> covered(size, size, 0);
  for (const VisibilityTriangle& triangle : scene.triangles) {
    rasterize_triangle(triangle.corners, size, size,
                       [&](int x, int y, const Eigen::Vector3d&) { ++covered(x, y); });
  }
  const Plane far_plane(far);
  const Plane near_plane(near);
  Image<std::int8_t> nearer(size, size, 0);  // 1 where `near` is, −1 where it is not, 0: no matter
  std::int64_t samples = 0;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      if (covered(x, y) < 2) continue;
      const Float128 gap = near_plane.nearness(x, y) - far_plane.nearness(x, y);
      nearer(x, y) = gap > 0 ? 1 : gap < 0 ? -1 : 0;
      samples += gap != 0 ? 1 : 0;
    }
  }
  for (const int near_at : {1, 0}) {
    for (const VisibilityRung& rung : visibility_ladder) {
      const VisibleTriangles seen = rung.seen(scene);
      std::int64_t wrong = 0;
      for (std::size_t i = 0; i < seen.pixels().size(); ++i) {
        const std::int8_t wanted = nearer.pixels()[i];
        wrong += wanted != 0 && (seen.pixels()[i] == near_at) != (wanted > 0) ? 1 : 0;
      }
      verdict.measure(rung.name, samples, wrong);
    }
    std::swap(scene.triangles[0], scene.triangles[1]);
  }
}

/// Whether the depth is the same all over the triangle, so that it is rounded once and for all.
bool faces_the_eye(const Corners& corners) {
  return std::all_of(corners.begin(), corners.end(), [&](const Eigen::Vector4f& p) {
    return p.w() == corners[0].w() && p.z() == corners[0].z();
  });
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
  const bool flat = faces_the_eye(far);
  const Float128 largest_error =
      depth_allowed * (near_plane.largest_depth() + far_plane.largest_depth());
  const auto stored = [](Float128 depth) { return static_cast<float>(static_cast<double>(depth)); };
  Framebuffer alone(size, size);
  draw(near, {}, alone);
  const Image<std::int32_t> covered_by_near = alone.ids();
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      if (before.row(y)[x] < 0 || covered_by_near.row(y)[x] < 0) continue;
      const Float128 far_depth = flat ? far_plane.corner_depth() : far_plane.depth(x, y);
      const Float128 near_depth = flat ? near_plane.corner_depth() : near_plane.depth(x, y);
      const Float128 gap = near_depth - far_depth;
      if (!flat && gap > -largest_error && gap < largest_error) continue;
      const bool second_is_nearer = flat ? stored(near_depth) > stored(far_depth) : gap > 0;
      const bool second_seen = after.row(y)[x] != before.row(y)[x];
      verdict.expect(second_seen == second_is_nearer,
                     [] { return "the triangle that is farther away is seen"; });
    }
  }
  measure_visibility(far, near, verdict);
}

constexpr int powers_per_side = 16;

/// Base and exponent for each of 16 × 16 pixels.
Numbers powers(Random& random) {
  Numbers numbers;
  for (int i = 0; i < powers_per_side * powers_per_side; ++i) {
    numbers.push_back(random.chance(0.1)   ? random.pick({0, -0.0, 1, 0x1p-126, 0x1p-100, -1, 0.5})
                      : random.chance(0.5) ? 1 - std::pow(10, -random.number(0, 7))
                                           : random.number(0, 1));
    numbers.push_back(random.chance(0.2) ? random.pick({0, 1, 2, 10, 1e6})
                                         : std::pow(10, random.number(-1, 6)));
  }
  return numbers;
}

/// A mesh of one triangle in each pixel.
Mesh triangle_per_pixel() {
  Mesh mesh;
  for (std::uint32_t i = 0; i < powers_per_side * powers_per_side; ++i) {
    const std::uint32_t column = i % powers_per_side;
    const std::uint32_t row = i / powers_per_side;
    const float left = 2 * static_cast<float>(column) / powers_per_side - 1;
    const float top = 1 - 2 * static_cast<float>(row) / powers_per_side;
    constexpr float pixel = 2.0F / powers_per_side;
    mesh.positions.emplace_back(left, top, 0);
    mesh.positions.emplace_back(left + 1.5F * pixel, top, 0);
    mesh.positions.emplace_back(left, top - 1.5F * pixel, 0);
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

void check_powers(const Numbers& numbers, Verdict& verdict) {
  if (numbers.size() != 2 * powers_per_side * powers_per_side) return;
  static const Mesh mesh = triangle_per_pixel();
  static const PreparedMesh prepared(mesh);
  PowerShader shader;
  for (const double number : numbers) shader.numbers.push_back(static_cast<float>(number));
  for (const SimdTarget simd : supported_simd_targets()) {
    Framebuffer frame(powers_per_side, powers_per_side);
    Renderer({.threads = 1, .simd = simd, .skip = {}})
        .draw({.mesh = &prepared, .shading = shading(shader)}, frame);
    const Image<std::int32_t> ids = frame.ids();
    for (int y = 0; y < powers_per_side; ++y) {
      for (int x = 0; x < powers_per_side; ++x) {
        const auto i = 2 * static_cast<std::size_t>(ids.row(y)[x]);
        const long double base = shader.numbers[i];
        const long double exponent = shader.numbers[i + 1];
        if (!(base <= 1 && exponent >= 0) || (base > 0 && base < 0x1p-126L)) continue;
        const long double truth = base > 0 ? std::pow(base, exponent) : exponent == 0 ? 1 : 0;
        // What simd.h promises of log_2 and exp_2; their product is rounded once.
        const long double steps = base > 0 ? -std::log2(base) : 0;
        const long double relative =
            3e-7L + 0.7L * exponent * (2e-7L + 1e-7L * steps + 6e-8L * steps);
        const auto allowed = static_cast<double>(std::expm1(relative) * truth + encoding_error);
        const Rgb8& pixel = frame.color().row(y)[x];
        const double found = decode(pixel.r, pixel.g, pixel.b);
        const auto error = static_cast<double>(std::abs(found - truth));
        verdict.expect_error(error, allowed, [&] {
          return std::to_string(static_cast<double>(base)) + " to the power of " +
                 std::to_string(static_cast<double>(exponent)) + " is off by " +
                 std::to_string(error * 1e7) + "e-7";
        });
      }
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
       "depths differ by more than depth's error, and wherever two facing the eye have depths that "
       "round to different floats",
       0, 0, depth_pairs, check_pair},
      {"powers",
       "a shader's powers of 0 and [2^-126, 1] with exponents 0 … 1e6 are right to what logarithm "
       "and "
       "exponential promise, under every SIMD target",
       0, 0, powers, check_powers},
  };
}

}  // namespace rasterlab::stress
