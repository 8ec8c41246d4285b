// Triangles in clip space, in a picture of 64 × 48: the exercise code, the engine, and homogeneous
// edge functions in 128-bit floats.
#include "common/engine/renderer.h"
#include "common/mesh/shapes.h"
#include "common/projection/draw_mesh.h"
#include "common/projection/look_at.h"
#include "common/projection/perspective.h"

#include "tests/stress/family.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>

namespace rasterlab::stress {
namespace {

__extension__ using Float128 = __float128;

constexpr int width = 64;
constexpr int height = 48;
constexpr std::size_t per_triangle = 12;

using Count = Image<std::int32_t>;

std::vector<ClipTriangle> clip_triangles(const Numbers& numbers) {
  std::vector<ClipTriangle> triangles;
  for (std::size_t i = 0; i + per_triangle <= numbers.size(); i += per_triangle) {
    ClipTriangle triangle;
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t k = 0; k < 4; ++k) {
        triangle[c][static_cast<Eigen::Index>(k)] = static_cast<float>(numbers[i + 4 * c + k]);
      }
    }
    triangles.push_back(triangle);
  }
  return triangles;
}

void add_exercise_coverage(const ClipTriangle& triangle, Count& count) {
  for_each_pixel(triangle, width, height,
                 [&](const TrianglePixel& pixel) { ++count.row(pixel.y)[pixel.x]; });
}

struct Drawn {
  Count ids;
  Image<float> depth;
};

/// The mesh's vertices are the unit vectors: the columns of the matrix are the corners.
Drawn engine_draw(const ClipTriangle& triangle, SimdTarget simd) {
  static const Mesh mesh = {.positions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                            .normals = {},
                            .colors = {},
                            .texture_coordinates = {},
                            .triangles = {{0, 1, 2}}};
  static const PreparedMesh prepared(mesh);
  thread_local std::map<SimdTarget, std::unique_ptr<Renderer>> renderers;
  std::unique_ptr<Renderer>& renderer = renderers[simd];
  if (!renderer) {
    renderer = std::make_unique<Renderer>(EngineOptions{.threads = 1, .simd = simd, .skip = {}});
  }
  Eigen::Matrix4f matrix = Eigen::Matrix4f::Zero();
  for (int i = 0; i < 3; ++i) matrix.col(i) = triangle[static_cast<std::size_t>(i)];
  Framebuffer frame(width, height);
  renderer->draw({.mesh = &prepared, .matrix = matrix}, frame);
  return {frame.ids(), frame.depth()};
}

/// Whether all components stay finite when the matrix of corners is applied: 0 · ∞ is NaN, so the
/// unit vectors cannot bring an infinity to the engine.
bool reaches_engine(const ClipTriangle& triangle) {
  return triangle[0].allFinite() && triangle[1].allFinite() && triangle[2].allFinite();
}

std::string at(int x, int y) {
  return "pixel (" + std::to_string(x) + ", " + std::to_string(y) + ")";
}

/// Where a point of the window lies in a triangle whose corners may be behind the eye.
class HomogeneousTriangle {
 public:
  explicit HomogeneousTriangle(const ClipTriangle& corners) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector4f& a = corners[(i + 1) % 3];
      const Eigen::Vector4f& b = corners[(i + 2) % 3];
      const auto minor = [&](int j, int k) {
        return static_cast<Float128>(a[j]) * b[k] - static_cast<Float128>(a[k]) * b[j];
      };
      edge_[i] = {minor(1, 3), minor(3, 0), minor(0, 1)};
      z_[i] = corners[i].z();
      w_[i] = corners[i].w();
    }
    determinant_ =
        edge_[0][0] * corners[0].x() + edge_[0][1] * corners[0].y() + edge_[0][2] * corners[0].w();
  }

  /// At a point of the window, in pixels: whether it is in front of all of the edges, and of the
  /// near and behind the far plane, by `margin` of w.
  struct Place {
    std::array<bool, 3> inside;
    bool in_front;
    bool behind_near;
    bool beyond_far;
  };
  Place place(double x, double y, double margin) const {
    const Float128 nx = static_cast<Float128>(x) / (width / 2) - 1;
    const Float128 ny = 1 - static_cast<Float128>(y) / (height / 2);
    Place place{};
    Float128 z = 0;
    Float128 w = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Float128 weight = (edge_[i][0] * nx + edge_[i][1] * ny + edge_[i][2]) / determinant_;
      place.inside[i] = weight > 0;
      z += weight * z_[i];
      w += weight * w_[i];
    }
    place.in_front = z > (margin - 1) * w && z < (1 - margin) * w;
    place.behind_near = z < (-1 - margin) * w;
    place.beyond_far = z > (1 + margin) * w;
    return place;
  }

  /// Whether positions are well enough determined for the pixel's surroundings to say anything.
  bool usable() const { return determinant_ != 0; }

 private:
  std::array<std::array<Float128, 3>, 3> edge_;
  std::array<Float128, 3> z_;
  std::array<Float128, 3> w_;
  Float128 determinant_;
};

void check_same_pixels(const ClipTriangle& triangle, Verdict& verdict) {
  Count count(width, height, 0);
  add_exercise_coverage(triangle, count);
  if (!reaches_engine(triangle)) {
    verdict.samples += width * height;
    return;
  }
  const Count ids = engine_draw(triangle, best_simd_target()).ids;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool same = count.row(y)[x] == (ids.row(y)[x] >= 0 ? 1 : 0);
      verdict.expect(same, [&] {
        return "the exercise covers " + at(x, y) + " " + std::to_string(count.row(y)[x]) +
               " times, the engine " + (ids.row(y)[x] >= 0 ? "once" : "not at all");
      });
    }
  }
}

/// In front of the near plane, within the guard band, and nearer than the far plane by more than a
/// depth's rounding: nothing is cut.
bool stays_whole(const ClipTriangle& triangle) {
  const Eigen::Vector2f guard = guard_band(width, height);
  return std::all_of(triangle.begin(), triangle.end(), [&](const Eigen::Vector4f& p) {
    return p.w() > 0 && p.z() >= -p.w() && p.z() <= 0.999F * p.w() &&
           std::abs(p.x()) <= guard.x() * p.w() && std::abs(p.y()) <= guard.y() * p.w();
  });
}

void check_same_bytes(const ClipTriangle& triangle, Verdict& verdict) {
  const Drawn expected = engine_draw(triangle, SimdTarget::scalar);
  for (const SimdTarget simd : supported_simd_targets()) {
    const Drawn found = engine_draw(triangle, simd);
    for (std::size_t i = 0; i < expected.ids.pixels().size(); ++i) {
      verdict.expect(found.ids.pixels()[i] == expected.ids.pixels()[i] &&
                         found.depth.pixels()[i] == expected.depth.pixels()[i],
                     [&] { return "SIMD targets differ in pixel " + std::to_string(i); });
      verdict.expect(found.depth.pixels()[i] >= 0 && std::isfinite(found.depth.pixels()[i]),
                     [&] { return "a depth is " + std::to_string(found.depth.pixels()[i]); });
    }
  }
}

/// Cuts of such triangles may be nothing but rounding; those that need none must be right.
void check_extremes(const Numbers& numbers, Verdict& verdict) {
  for (const ClipTriangle& triangle : clip_triangles(numbers)) {
    check_same_bytes(triangle, verdict);
    Count count(width, height, 0);
    add_exercise_coverage(triangle, count);  // must return
    if (stays_whole(triangle)) check_same_pixels(triangle, verdict);
  }
}

enum class Truth { covered, not_covered, too_close };

/// `reach`: how far from an edge, in pixels, nothing is said; single-precision cuts and snapping
/// move an edge.
Truth truth_at(const HomogeneousTriangle& triangle, int x, int y, double reach) {
  std::array<int, 3> inside{};
  int in_front = 0;
  int cut_away = 0;
  for (const double dx : {-reach, reach}) {
    for (const double dy : {-reach, reach}) {
      const auto place = triangle.place(x + 0.5 + dx, y + 0.5 + dy, 1e-4);
      for (std::size_t i = 0; i < 3; ++i) inside[i] += place.inside[i] ? 1 : 0;
      in_front += place.in_front ? 1 : 0;
      cut_away += place.behind_near || place.beyond_far ? 1 : 0;
    }
  }
  if (inside == std::array<int, 3>{4, 4, 4} && in_front == 4) return Truth::covered;
  if (inside[0] == 0 || inside[1] == 0 || inside[2] == 0 || cut_away == 4) {
    return Truth::not_covered;
  }
  return Truth::too_close;
}

void check_against_truth(const Numbers& numbers, Verdict& verdict) {
  for (const ClipTriangle& corners : clip_triangles(numbers)) {
    check_same_pixels(corners, verdict);
    const HomogeneousTriangle triangle(corners);
    if (!triangle.usable()) continue;
    Count count(width, height, 0);
    add_exercise_coverage(corners, count);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const Truth truth = truth_at(triangle, x, y, 1.0 / 64);
        if (truth == Truth::too_close) continue;
        verdict.expect(count.row(y)[x] == (truth == Truth::covered ? 1 : 0), [&] {
          return at(x, y) + " is covered " + std::to_string(count.row(y)[x]) + " times, and is " +
                 (truth == Truth::covered ? "inside" : "outside");
        });
      }
    }
  }
}

double special(Random& random) {
  using Limits = std::numeric_limits<float>;
  return random.pick({0, -0.0, 1, -1, Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(),
                      Limits::max(), -Limits::max(), Limits::min(), -Limits::min(),
                      Limits::denorm_min(), -Limits::denorm_min(), 0x1p-24, -0x1p-24, 0x1p24});
}

void push_corner(Random& random, Numbers& numbers, double w) {
  for (int axis = 0; axis < 2; ++axis) numbers.push_back(random.number(-2, 2));
  numbers.push_back(random.number(-1, 1));
  numbers.push_back(w);
}

Numbers special_floats(Random& random) {
  Numbers numbers;
  for (int i = 0; i < 3; ++i) push_corner(random, numbers, random.number(0.5, 2));
  for (std::int64_t changes = random.whole(1, 6); changes > 0; --changes) {
    numbers[static_cast<std::size_t>(random.whole(0, 11))] = special(random);
  }
  return numbers;
}

Numbers beyond_range(Random& random) {
  Numbers numbers;
  for (int i = 0; i < 3; ++i) {
    const double reach = random.pick({1, 1e3, 1e7, 1e30, 0x1p124});  // the last is FLT_MAX/16
    const double w = random.pick({1, 1, 1, 1e-3, 1e7});
    for (int axis = 0; axis < 3; ++axis) {
      numbers.push_back(random.number(-1, 1) * (random.chance(0.7) ? reach : w));
    }
    numbers.push_back(w);
  }
  return numbers;
}

Numbers w_through_zero(Random& random) {
  Numbers numbers;
  for (int i = 0; i < 3; ++i) {
    const double w = random.chance(0.5)
                         ? random.number(-2, 2)
                         : random.pick({-1, -0x1p-24, 0, -0.0, 0x1p-24, 1, 0x1p-149});
    push_corner(random, numbers, w);
  }
  return numbers;
}

/// A triangle, and how the fourth corner is made of its three: two triangles on either side of an
/// edge.
Numbers shared_edges(Random& random) {
  Numbers numbers;
  const double reach = random.pick({1, 3, 300});
  for (int i = 0; i < 3; ++i) {
    push_corner(random, numbers, random.number(-1, 2));
    for (std::size_t axis = 0; axis < 2; ++axis) numbers[numbers.size() - 4 + axis] *= reach;
  }
  numbers.push_back(random.number(0, 1));
  numbers.push_back(random.number(0, 1));
  numbers.push_back(random.number(0.1, 1));
  return numbers;
}

void check_shared_edge(const Numbers& numbers, Verdict& verdict) {
  if (numbers.size() != per_triangle + 3 || !(numbers.back() > 0)) return;
  const ClipTriangle t = clip_triangles(numbers).front();
  const auto part = [&](std::size_t i) { return static_cast<float>(numbers[per_triangle + i]); };
  const Eigen::Vector4f fourth = part(0) * t[0] + part(1) * t[1] - part(2) * t[2];
  const HomogeneousTriangle first(t);
  const HomogeneousTriangle second({t[1], t[0], fourth});
  if (!first.usable() || !second.usable()) return;
  for (const bool turned : {false, true}) {
    Count count(width, height, 0);
    add_exercise_coverage(t, count);
    add_exercise_coverage(
        turned ? ClipTriangle{t[0], t[1], fourth} : ClipTriangle{fourth, t[1], t[0]}, count);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        verdict.expect(count.row(y)[x] <= 1,
                       [&] { return at(x, y) + " by a shared edge is covered twice"; });
        const bool covered = truth_at(first, x, y, 1.0 / 64) == Truth::covered ||
                             truth_at(second, x, y, 1.0 / 64) == Truth::covered;
        verdict.expect(!covered || count.row(y)[x] == 1,
                       [&] { return at(x, y) + " by a shared edge is not covered"; });
      }
    }
  }
}

/// Eye, centre and how far from the origin both are moved with the mesh; then the camera's angle.
Numbers cameras_far_out(Random& random) {
  const double away = random.pick({0, 1e2, 1e4, 1e6, 1e7});
  return {random.number(-3, 3),
          random.number(-3, 3),
          random.number(-3, 3),
          random.number(-1, 1),
          random.number(-1, 1),
          random.number(-1, 1),
          away,
          random.number(5, 120)};
}

void check_mesh(const Mesh& mesh, const Transforms& transforms, int columns, int rows,
                Verdict& verdict) {
  Frame frame = make_frame(columns, rows);
  frame.ids = Image<std::int32_t>(columns, rows, -1);
  draw_mesh(mesh, transforms, Cull::none, frame,
            [](std::uint32_t, const TrianglePixel&) { return Color(1, 1, 1); });
  thread_local Renderer renderer({.threads = 1, .skip = {}});
  const PreparedMesh prepared(mesh);
  Framebuffer engine(columns, rows);
  renderer.draw({.mesh = &prepared, .matrix = transforms.to_clip()}, engine);
  const Count ids = engine.ids();
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      verdict.expect((ids.row(y)[x] >= 0) == (frame.ids.row(y)[x] >= 0), [&] {
        return "exercise and engine differ in whether " + at(x, y) + " is covered";
      });
    }
  }
}

void check_camera(const Numbers& n, Verdict& verdict) {
  if (n.size() != 8) return;
  static const Mesh mesh = make_shape("icosphere:2");
  const auto vector = [&](std::size_t i) {
    return Eigen::Vector3f(static_cast<float>(n[i]), static_cast<float>(n[i + 1]),
                           static_cast<float>(n[i + 2]));
  };
  const Eigen::Vector3f away = Eigen::Vector3f(1, 0.5F, -0.7F) * static_cast<float>(n[6]);
  Transforms transforms;
  transforms.model.topRightCorner<3, 1>() = away;
  transforms.view = look_at(vector(0) + away, vector(3) + away, Eigen::Vector3f::UnitY());
  transforms.projection = perspective(static_cast<float>(n[7]), 4.0F / 3, 0.1F, 100);
  check_mesh(mesh, transforms, width, height, verdict);
}

Numbers odd_pictures(Random& random) {
  return {random.pick({1, 1, 2, 3, 5, 16384}),
          random.pick({1, 2, 7}),
          random.chance(0.5) ? 1.0 : 0.0,
          random.number(-3, 3),
          random.number(-3, 3),
          random.number(-3, 3)};
}

void check_picture(const Numbers& n, Verdict& verdict) {
  if (n.size() != 6) return;
  static const Mesh mesh = make_shape("torus_knot:4");
  const auto side = [](double number) {
    return static_cast<int>(std::clamp(number, 1.0, 16384.0));
  };
  const int columns = side(n[2] != 0 ? n[0] : n[1]);
  const int rows = side(n[2] != 0 ? n[1] : n[0]);
  Transforms transforms;
  transforms.view = look_at(
      Eigen::Vector3f(static_cast<float>(n[3]), static_cast<float>(n[4]), static_cast<float>(n[5])),
      Eigen::Vector3f::Zero(), Eigen::Vector3f::UnitY());
  transforms.projection =
      perspective(70, static_cast<float>(columns) / static_cast<float>(rows), 0.1F, 20);
  check_mesh(mesh, transforms, columns, rows, verdict);
}

}  // namespace

std::vector<Family> clipping_families() {
  return {
      {"special_floats",
       "with any float in any component all SIMD targets draw the same bytes and finite depths, "
       "and "
       "uncut triangles where the exercise code does",
       per_triangle, 0, special_floats, check_extremes},
      {"beyond_range",
       "with coordinates to FLT_MAX/16 all SIMD targets draw the same bytes and finite depths, and "
       "uncut triangles where the exercise code does",
       per_triangle, 0, beyond_range, check_extremes},
      {"w_through_zero",
       "exercise and engine draw the same pixels, and those farther than 1/64 px from an edge are "
       "what homogeneous edge functions in 128-bit floats say",
       per_triangle, 0, w_through_zero, check_against_truth},
      {"shared_edges",
       "two triangles on either side of an edge that goes through the near plane or the guard band "
       "leave neither gap nor double along it",
       0, 0, shared_edges, check_shared_edge},
      {"cameras_far_out",
       "up to 1e7 units from the origin exercise and engine cover the same pixels", 0, 0,
       cameras_far_out, check_camera},
      {"odd_pictures",
       "in pictures of 1 × 1 to 1 × 16384 exercise and engine cover the same pixels", 0, 0,
       odd_pictures, check_picture},
  };
}

}  // namespace rasterlab::stress
