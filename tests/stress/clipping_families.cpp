// Triangles in clip space, in a picture of 64 × 48: the exercise code, the engine, and homogeneous
// edge functions in 128-bit floats.
#include "common/engine/renderer.h"
#include "common/projection/triangle_pixels.h"
#include "common/projection/vertex_stage.h"

#include "tests/stress/family.h"
#include "tests/stress/homogeneous.h"
#include "tests/stress/special_floats.h"
#include "tests/support/snapped_outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <span>

namespace rasterlab::stress {
namespace {

using Truth = HomogeneousTriangle::Truth;

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

void add_exercise_coverage(const ClipTriangle& triangle, Count& count,
                           ClipFunction clip = &clip_homogeneous) {
  TriangleCounts counts;
  for_each_pixel(triangle, width, height, {.clip = clip}, counts,
                 [&](const TrianglePixel& pixel) { ++count.row(pixel.y)[pixel.x]; });
}

struct Drawn {
  Count ids;
  Image<float> depth;
};

Drawn engine_draw(const PreparedMesh& mesh, const Eigen::Matrix4f& matrix, SimdTarget simd) {
  thread_local std::map<SimdTarget, std::unique_ptr<Renderer>> renderers;
  std::unique_ptr<Renderer>& renderer = renderers[simd];
  if (!renderer) {
    renderer = std::make_unique<Renderer>(EngineOptions{.threads = 1, .simd = simd, .skip = {}});
  }
  Framebuffer frame(width, height);
  renderer->draw({.mesh = &mesh, .matrix = matrix}, frame);
  return {frame.ids(), frame.depth()};
}

/// Its vertices are the unit vectors: the columns of the matrix are the corners in clip space.
const PreparedMesh& unit_triangle() {
  static const Mesh mesh = {.positions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                            .normals = {},
                            .colors = {},
                            .texture_coordinates = {},
                            .triangles = {{0, 1, 2}}};
  static const PreparedMesh prepared(mesh);
  return prepared;
}

Eigen::Matrix4f corners_matrix(const ClipTriangle& triangle) {
  Eigen::Matrix4f matrix = Eigen::Matrix4f::Zero();
  for (int i = 0; i < 3; ++i) matrix.col(i) = triangle[static_cast<std::size_t>(i)];
  return matrix;
}

Drawn engine_draw(const ClipTriangle& triangle, SimdTarget simd) {
  return engine_draw(unit_triangle(), corners_matrix(triangle), simd);
}

/// Whether all components stay finite when the matrix of corners is applied: 0 · ∞ is NaN, so the
/// unit vectors cannot bring an infinity to the engine.
bool reaches_engine(const ClipTriangle& triangle) {
  return triangle[0].allFinite() && triangle[1].allFinite() && triangle[2].allFinite();
}

std::string at(int x, int y) {
  return "pixel (" + std::to_string(x) + ", " + std::to_string(y) + ")";
}

/// How far from 1 rounding may move a sample's z/w: five units in the last place of the largest at
/// a corner of what is left of the triangle.
double rounding_of_depth(const ClipTriangle& triangle) {
  double largest = 1;
  for (const ClipVertex& vertex : clip_homogeneous(triangle, guard_band(width, height))) {
    const double depth = std::abs(static_cast<double>(vertex.position.z()) / vertex.position.w());
    if (std::isnan(depth)) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, depth);
  }
  return 6e-7 * largest;
}

/// Exercise and engine cover the same pixels, but where a sample's depth is the far plane's up to
/// rounding: there the one may draw it and the other not. How often they do is told, as an error.
void expect_same_pixels(const ClipTriangle& triangle, const Count& engine_ids, Verdict& verdict) {
  const HomogeneousTriangle exact(triangle, width, height);
  const double rounding = rounding_of_depth(triangle);
  Count count(width, height, 0);
  add_exercise_coverage(triangle, count);
  std::int64_t at_far_plane = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool drawn = engine_ids.row(y)[x] >= 0;
      const bool same = count.row(y)[x] == (drawn ? 1 : 0);
      const bool rounded = !same && exact.near_far_plane(x, y, rounding);
      at_far_plane += rounded ? 1 : 0;
      verdict.expect(same || rounded, [&] {
        return "the exercise covers " + at(x, y) + " " + std::to_string(count.row(y)[x]) +
               " times, the engine " + (drawn ? "once" : "not at all");
      });
    }
  }
  verdict.measure("far plane, engine", width * height, at_far_plane);
}

void check_same_pixels(const ClipTriangle& triangle, Verdict& verdict) {
  if (!reaches_engine(triangle)) return;
  expect_same_pixels(triangle, engine_draw(triangle, best_simd_target()).ids, verdict);
}

void check_same_bytes(const PreparedMesh& mesh, const Eigen::Matrix4f& matrix, Verdict& verdict) {
  const Drawn expected = engine_draw(mesh, matrix, SimdTarget::scalar);
  for (const SimdTarget simd : supported_simd_targets()) {
    const Drawn found = engine_draw(mesh, matrix, simd);
    for (std::size_t i = 0; i < expected.ids.pixels().size(); ++i) {
      verdict.expect(found.ids.pixels()[i] == expected.ids.pixels()[i] &&
                         found.depth.pixels()[i] == expected.depth.pixels()[i],
                     [&] { return "SIMD targets differ in pixel " + std::to_string(i); });
      verdict.expect(found.depth.pixels()[i] >= 0 && std::isfinite(found.depth.pixels()[i]),
                     [&] { return "a depth is " + std::to_string(found.depth.pixels()[i]); });
    }
  }
}

/// In front of the near plane and within the guard band: nothing is cut.
bool stays_whole(const ClipTriangle& triangle) {
  const Eigen::Vector2f guard = guard_band(width, height);
  return std::all_of(triangle.begin(), triangle.end(), [&](const Eigen::Vector4f& p) {
    return p.w() > 0 && p.z() >= -p.w() && std::abs(p.x()) <= guard.x() * p.w() &&
           std::abs(p.y()) <= guard.y() * p.w();
  });
}

/// Cuts of such triangles may be nothing but rounding; those that need none must be right.
void check_extremes(const Numbers& numbers, Verdict& verdict) {
  for (const ClipTriangle& triangle : clip_triangles(numbers)) {
    check_same_bytes(unit_triangle(), corners_matrix(triangle), verdict);
    if (stays_whole(triangle)) {
      check_same_pixels(triangle, verdict);
    } else if (reaches_engine(triangle)) {
      Verdict cut;  // no promise: told as an error
      check_same_pixels(triangle, cut);
      verdict.measure("cuts, engine", cut.samples, cut.violations);
    } else {
      Count count(width, height, 0);
      add_exercise_coverage(triangle, count);  // must return
    }
  }
}

/// How far from an edge, in pixels, nothing is said.
constexpr double reach_of_rounding = 1.0 / 64;

void check_against_truth(const Numbers& numbers, Verdict& verdict) {
  for (const ClipTriangle& corners : clip_triangles(numbers)) {
    check_same_pixels(corners, verdict);
    const HomogeneousTriangle triangle(corners, width, height);
    if (!triangle.usable()) continue;
    std::array<Count, clip_ladder.size()> counts;
    for (std::size_t rung = 0; rung < counts.size(); ++rung) {
      counts[rung] = Count(width, height, 0);
      add_exercise_coverage(corners, counts[rung], clip_ladder[rung].clip);
    }
    std::int64_t known = 0;
    std::array<std::int64_t, clip_ladder.size()> wrong{};
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const Truth truth = triangle.truth_at(x, y, reach_of_rounding);
        if (truth == Truth::too_close) continue;
        ++known;
        const int wanted = truth == Truth::covered ? 1 : 0;
        for (std::size_t i = 0; i < counts.size(); ++i) wrong[i] += counts[i].row(y)[x] != wanted;
        const int found = counts.back().row(y)[x];
        verdict.expect(found == wanted, [&] {
          return at(x, y) + " is covered " + std::to_string(found) + " times, and is " +
                 (wanted == 1 ? "inside" : "outside");
        });
      }
    }
    for (std::size_t i = 0; i + 1 < counts.size(); ++i) {
      verdict.measure(clip_ladder[i].name, known, wrong[i]);
    }
  }
}

/// Up to six of the numbers become special floats.
void make_some_special(Random& random, Numbers& numbers) {
  const auto any_index = [&](std::size_t size) {
    return static_cast<std::size_t>(random.whole(0, static_cast<std::int64_t>(size) - 1));
  };
  for (std::int64_t changes = random.whole(1, 6); changes > 0; --changes) {
    const std::size_t i = any_index(numbers.size());
    numbers[i] = special_floats[any_index(special_floats.size())];
  }
}

void push_corner(Random& random, Numbers& numbers, double w) {
  for (int axis = 0; axis < 2; ++axis) numbers.push_back(random.number(-2, 2));
  numbers.push_back(random.number(-1, 1));
  numbers.push_back(w);
}

Numbers special_corners(Random& random) {
  Numbers numbers;
  for (int i = 0; i < 3; ++i) push_corner(random, numbers, random.number(0.5, 2));
  make_some_special(random, numbers);
  return numbers;
}

/// Three positions, then a matrix column by column: the special floats reach the engine as they
/// stand.
Numbers special_meshes(Random& random) {
  Numbers numbers;
  for (int i = 0; i < 9; ++i) numbers.push_back(random.number(-1, 1));
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      numbers.push_back((row == column ? 1 : 0) + random.number(-0.3, 0.3));
    }
  }
  make_some_special(random, numbers);
  return numbers;
}

void check_special_mesh(const Numbers& n, Verdict& verdict) {
  if (n.size() != 25) return;
  const auto number = [&](std::size_t i) { return static_cast<float>(n[i]); };
  Mesh mesh;
  for (std::size_t i = 0; i < 9; i += 3) {
    mesh.positions.emplace_back(number(i), number(i + 1), number(i + 2));
  }
  mesh.triangles = {{0, 1, 2}};
  Eigen::Matrix4f matrix;
  for (std::size_t i = 0; i < 16; ++i) {
    matrix(static_cast<Eigen::Index>(i % 4), static_cast<Eigen::Index>(i / 4)) = number(9 + i);
  }
  const PreparedMesh prepared(mesh);
  check_same_bytes(prepared, matrix, verdict);
  ClipTriangle corners;
  for (std::size_t i = 0; i < 3; ++i) corners[i] = to_clip(matrix, mesh.positions[i]);
  if (reaches_engine(corners) && stays_whole(corners)) {
    expect_same_pixels(corners, engine_draw(prepared, matrix, best_simd_target()).ids, verdict);
  } else {
    Count count(width, height, 0);
    add_exercise_coverage(corners, count);  // must return
  }
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

/// Moves the first two of three corners, keeping z and w, onto a line through many samples.
void put_edge_on_samples(Random& random, Numbers& numbers) {
  const auto column = static_cast<double>(random.whole(0, width - 1));
  const auto row = static_cast<double>(random.whole(0, height - 1));
  const auto columns = static_cast<double>(random.whole(-3, 3));
  const auto rows = static_cast<double>(random.whole(-3, 3));
  for (std::size_t corner = 0; corner < 2; ++corner) {
    const double steps = random.number(-20, 20) * random.pick({1, 1, 1000});
    const double w = numbers[4 * corner + 3];
    numbers[4 * corner] = w * (2 * (column + steps * columns + 0.5) / width - 1);
    numbers[4 * corner + 1] = w * (1 - 2 * (row + steps * rows + 0.5) / height);
  }
}

/// A triangle, and how the fourth corner is made of its three: two triangles on either side of an
/// edge.
Numbers shared_edges(Random& random) {
  Numbers numbers;
  const double reach = random.pick({1, 3, 300, 1e4});  // the guard band begins at 511 and 682
  for (int i = 0; i < 3; ++i) {
    push_corner(random, numbers, random.number(-1, 2));
    for (std::size_t axis = 0; axis < 2; ++axis) numbers[numbers.size() - 4 + axis] *= reach;
  }
  if (random.chance(0.6)) put_edge_on_samples(random, numbers);
  numbers.push_back(random.number(0, 1));
  numbers.push_back(random.number(0, 1));
  numbers.push_back(random.number(0.1, 1));
  return numbers;
}

using TrianglePair = std::array<ClipTriangle, 2>;

/// What each rung makes of a pair that shares an edge, and the engine of both at once.
void check_pair(const TrianglePair& pair, const Image<Truth>& truth,
                std::span<const ClipRung> rungs, Verdict& verdict) {
  for (const ClipRung& rung : rungs) {
    Count count(width, height, 0);
    for (const ClipTriangle& triangle : pair) add_exercise_coverage(triangle, count, rung.clip);
    std::int64_t wrong = 0;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const int found = count.row(y)[x];
        const bool gap = truth.row(y)[x] == Truth::covered && found == 0;
        wrong += gap || found > 1 ? 1 : 0;
        if (&rung != &clip_ladder.back()) continue;
        verdict.expect(found <= 1, [&] { return at(x, y) + " by a shared edge is covered twice"; });
        verdict.expect(!gap, [&] { return at(x, y) + " by a shared edge is not covered"; });
      }
    }
    if (&rung != &clip_ladder.back()) verdict.measure(rung.name, width * height, wrong);
  }
  std::array<Count, 2> ids;
  for (std::size_t i = 0; i < 2; ++i) ids[i] = engine_draw(pair[i], best_simd_target()).ids;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int found = (ids[0].row(y)[x] >= 0 ? 1 : 0) + (ids[1].row(y)[x] >= 0 ? 1 : 0);
      verdict.expect(found <= 1 && (found == 1 || truth.row(y)[x] != Truth::covered), [&] {
        return "the engine covers " + at(x, y) + " by a shared edge " + std::to_string(found) +
               " times";
      });
    }
  }
}

void check_shared_edge(const Numbers& numbers, Verdict& verdict) {
  if (numbers.size() != per_triangle + 3 || !(numbers.back() > 0)) return;
  const ClipTriangle t = clip_triangles(numbers).front();
  const auto part = [&](std::size_t i) { return static_cast<float>(numbers[per_triangle + i]); };
  const Eigen::Vector4f fourth = part(0) * t[0] + part(1) * t[1] - part(2) * t[2];
  const HomogeneousTriangle first(t, width, height);
  const HomogeneousTriangle second(ClipTriangle{t[1], t[0], fourth}, width, height);
  if (!first.usable() || !second.usable()) return;
  Image<Truth> truth(width, height, Truth::too_close);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto inside = [&](const HomogeneousTriangle& triangle, std::size_t edges) {
        return triangle.clearly_inside(x, y, reach_of_rounding, edges);
      };
      // Within both but for the edge they share, the last one of either: it does not matter where.
      if (inside(first, 3) || inside(second, 3) || (inside(first, 2) && inside(second, 2))) {
        truth.row(y)[x] = Truth::covered;
      }
    }
  }
  check_pair({t, {fourth, t[1], t[0]}}, truth, clip_ladder, verdict);
  const auto last_rung = std::span(clip_ladder).last(1);
  check_pair({t, {t[0], t[1], fourth}}, truth, last_rung, verdict);  // the other winding
  check_pair({ClipTriangle{t[2], t[1], t[0]}, {fourth, t[1], t[0]}}, truth, last_rung, verdict);
}

/// Corners next to a line through many samples, and a point inside that splits them in three.
Numbers cut_slivers(Random& random) {
  Numbers numbers;
  const auto row = static_cast<double>(random.whole(0, height - 1));
  const auto slope = static_cast<double>(random.whole(-2, 2));
  for (int i = 0; i < 3; ++i) {
    const double w = random.chance(0.8) ? random.number(-1, 2) : random.pick({-0x1p-24, 0, 1e-3});
    const double x = random.number(-width / 2.0, width * 1.5);
    const double y = row + 0.5 + slope * (x - width / 2.0 - 0.5) + random.number(-1, 1) / 128;
    numbers.push_back(w * (x / (width / 2.0) - 1));
    numbers.push_back(w * (1 - y / (height / 2.0)));
    numbers.push_back(w - random.number(0.05, 2));
    numbers.push_back(w);
  }
  for (int i = 0; i < 3; ++i) numbers.push_back(random.number(0.05, 1));
  return numbers;
}

void check_slivers(const Numbers& numbers, Verdict& verdict) {
  if (numbers.size() != per_triangle + 3) return;
  const ClipTriangle t = clip_triangles(numbers).front();
  Eigen::Vector4f inside = Eigen::Vector4f::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    inside += static_cast<float>(numbers[per_triangle + i]) * t[i];
  }
  for (const ClipTriangle& part :
       {ClipTriangle{t[0], t[1], inside}, {t[1], t[2], inside}, {t[2], t[0], inside}}) {
    check_same_pixels(part, verdict);
    const std::optional<SnappedOutline> outline = snapped_outline(part, width, height);
    const int side = exact_side(part);
    if (!outline || outline->empty() || side == 0) continue;
    Count count(width, height, 0);
    add_exercise_coverage(part, count);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const int winds = side * winding(*outline, x, y);
        verdict.expect(count.row(y)[x] == (winds > 0 ? 1 : 0), [&] {
          return at(x, y) + " is covered " + std::to_string(count.row(y)[x]) +
                 " times, and the outline winds round it " + std::to_string(winds) + " times";
        });
      }
    }
  }
}

}  // namespace

std::vector<Family> clipping_families() {
  const std::string extremes =
      " all SIMD targets draw the same bytes and finite depths, and where nothing is cut, but for "
      "rounding at the far plane, the exercise code's pixels";
  return {
      {"special_floats", "with any float in any component" + extremes, per_triangle, 0,
       special_corners, check_extremes},
      {"special_meshes", "with any float in any position and matrix entry" + extremes, 0, 0,
       special_meshes, check_special_mesh},
      {"beyond_range", "with coordinates to FLT_MAX/16" + extremes, per_triangle, 0, beyond_range,
       check_extremes},
      {"w_through_zero",
       "exercise and engine cover the same pixels but for rounding at the far plane, and those "
       "farther than 1/64 px from an edge are what homogeneous edge functions in 128-bit floats "
       "say",
       per_triangle, 0, w_through_zero, check_against_truth},
      {"shared_edges",
       "two triangles on either side of an edge that goes through the near plane or the guard band "
       "leave neither gap nor double along it",
       0, 0, shared_edges, check_shared_edge},
      {"cut_slivers",
       "of triangles a few 1/256 px thin exercise and engine cover the same pixels, "
       "and just those that the snapped outline winds round as the triangle is seen",
       0, 0, cut_slivers, check_slivers},
  };
}

}  // namespace rasterlab::stress
