// Which pixels triangles cover, in a picture of 256 × 256: against 128-bit integers.
#include "common/engine/renderer.h"
#include "common/triangles/coverage.h"
#include "common/triangles/rasterize.h"

#include "tests/oracle/exact_triangle.h"
#include "tests/stress/family.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace rasterlab::stress {
namespace {

constexpr int side = 256;
constexpr std::size_t per_triangle = 6;
using Triangle = std::array<Eigen::Vector2f, 3>;

struct Covered {
  Image<int> count = Image<int>(side, side, 0);   ///< how many triangles cover a pixel
  Image<int> first = Image<int>(side, side, -1);  ///< the first of them

  void add(int x, int y, int triangle) {
    if (++count.row(y)[x] == 1) first.row(y)[x] = triangle;
  }
};

std::vector<Triangle> triangles_of(const Numbers& numbers) {
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i + per_triangle <= numbers.size(); i += per_triangle) {
    Triangle triangle;
    for (std::size_t c = 0; c < 3; ++c) {
      triangle[c] = {static_cast<float>(numbers[i + 2 * c]),
                     static_cast<float>(numbers[i + 2 * c + 1])};
    }
    triangles.push_back(triangle);
  }
  return triangles;
}

/// The pixels that can be covered, and one more all round.
struct Box {
  int left, right, top, bottom;
};
Box box_of(const Triangle& t) {
  const auto pixel = [](float coordinate, int more) {
    return static_cast<int>(std::clamp(std::floor(coordinate) + static_cast<float>(more), 0.0F,
                                       static_cast<float>(side)));
  };
  return {pixel(std::min({t[0].x(), t[1].x(), t[2].x()}), -1),
          pixel(std::max({t[0].x(), t[1].x(), t[2].x()}), 2),
          pixel(std::min({t[0].y(), t[1].y(), t[2].y()}), -1),
          pixel(std::max({t[0].y(), t[1].y(), t[2].y()}), 2)};
}

Corners corners_of(const Triangle& t) {
  return {t[0].cast<double>(), t[1].cast<double>(), t[2].cast<double>()};
}

Covered true_coverage(const std::vector<Triangle>& triangles, Verdict& verdict) {
  Covered truth;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[i];
    const oracle::GridTriangle exact = oracle::to_grid(corners_of(t));
    const Box box = box_of(t);
    for (int y = box.top; y < box.bottom; ++y) {
      for (int x = box.left; x < box.right; ++x) {
        if (oracle::covers(exact, x, y)) truth.add(x, y, static_cast<int>(i));
        ++verdict.samples;
      }
    }
  }
  return truth;
}

Covered exercise_coverage(const std::vector<Triangle>& triangles) {
  Covered coverage;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    rasterize_triangle(triangles[i], side, side, [&](int x, int y, const Eigen::Vector3d&) {
      coverage.add(x, y, static_cast<int>(i));
    });
  }
  return coverage;
}

Covered coverage_by(FillTriangle fill, const std::vector<Triangle>& triangles) {
  Covered covered;
  Image<Rgb8> scratch(side, side);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for_each_drawn_pixel(fill, corners_of(triangles[i]), scratch,
                         [&](int x, int y) { covered.add(x, y, static_cast<int>(i)); });
  }
  return covered;
}

/// How many pixels are covered too often or not often enough by each rung of the ladder but the
/// last.
void measure_rungs(const std::vector<Triangle>& triangles, const Covered& truth,
                   std::int64_t samples, Verdict& verdict) {
  for (const FillRung& rung : std::span(fill_ladder).first(fill_ladder.size() - 1)) {
    const Covered found = coverage_by(rung.fill, triangles);
    std::int64_t wrong = 0;
    for (std::size_t i = 0; i < found.count.pixels().size(); ++i) {
      wrong += std::abs(found.count.pixels()[i] - truth.count.pixels()[i]);
    }
    verdict.measure(rung.name, samples, wrong);
  }
}

/// Window coordinates that are multiples of 1/256 px and within the guard band reach the engine
/// exactly: a picture's side is a power of two.
bool exact_in_engine(const std::vector<Triangle>& triangles) {
  return std::all_of(triangles.begin(), triangles.end(), [](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [](const Eigen::Vector2f& p) {
      return p.cwiseAbs().maxCoeff() < 16000 &&
             (p * 256).array().round().isApprox((p * 256).array(), 0);
    });
  });
}

Image<std::int32_t> engine_ids(const std::vector<Triangle>& triangles) {
  Mesh mesh;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const float depth = -1.0F + 1.9F * static_cast<float>(i) / static_cast<float>(triangles.size());
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Eigen::Vector2f& p : triangles[i]) {
      mesh.positions.emplace_back(2 * p.x() / side - 1, 1 - 2 * p.y() / side, depth);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  thread_local Renderer renderer({.threads = 1, .skip = {}});
  const PreparedMesh prepared(mesh);
  Framebuffer frame(side, side);
  renderer.draw({.mesh = &prepared}, frame);
  return frame.ids();
}

std::string at(int x, int y) {
  return "pixel (" + std::to_string(x) + ", " + std::to_string(y) + ")";
}

/// The samples have been counted with the truth.
void expect_same(const Covered& found, const Covered& truth, Verdict& verdict) {
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const int wanted = truth.count.row(y)[x];
      const int times = found.count.row(y)[x];
      if (times == wanted) continue;
      verdict.expect(false, [&] {
        return at(x, y) + " is covered " + std::to_string(times) + " times, not " +
               std::to_string(wanted);
      });
    }
  }
}

/// The exercise's last rung covers each pixel as often as it should, and the engine shows the first
/// triangle there.
Covered check_coverage(const std::vector<Triangle>& triangles, Verdict& verdict) {
  const std::int64_t samples_before = verdict.samples;
  Covered truth = true_coverage(triangles, verdict);
  measure_rungs(triangles, truth, verdict.samples - samples_before, verdict);
  const Covered exercise = exercise_coverage(triangles);
  const bool with_engine = exact_in_engine(triangles);
  const Image<std::int32_t> ids =
      with_engine ? engine_ids(triangles) : Image<std::int32_t>(side, side, -1);
  expect_same(exercise, truth, verdict);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      if (with_engine && ids.row(y)[x] != truth.first.row(y)[x]) {
        verdict.expect(false, [&] {
          return "the engine shows triangle " + std::to_string(ids.row(y)[x]) + " at " + at(x, y) +
                 ", not " + std::to_string(truth.first.row(y)[x]);
        });
      }
    }
  }
  return truth;
}

void check_triangles(const Numbers& numbers, Verdict& verdict) {
  check_coverage(triangles_of(numbers), verdict);
}

double snapped(double pixels) {
  return std::round(pixels * 256) / 256;
}

void push(Numbers& numbers, double x, double y) {
  numbers.push_back(x);
  numbers.push_back(y);
}

Numbers slivers(Random& random) {
  Numbers numbers;
  for (int i = 0; i < 40; ++i) {
    const double x0 = snapped(random.number(-20, side + 20));
    const double y0 = snapped(random.number(-20, side + 20));
    const double reach = random.pick({3, 30, 300});
    const double dx = snapped(random.number(-reach, reach));
    const double dy = snapped(random.number(-reach, reach));
    const double t = random.number(-0.2, 1.2);
    const std::size_t turn = static_cast<std::size_t>(random.whole(0, 2));
    const std::array<std::array<double, 2>, 3> corners = {
        {{x0, y0},
         {x0 + dx, y0 + dy},
         {snapped(x0 + t * dx) + static_cast<double>(random.whole(-2, 2)) / 256,
          snapped(y0 + t * dy) + static_cast<double>(random.whole(-2, 2)) / 256}}};
    for (std::size_t c = 0; c < 3; ++c) {
      push(numbers, corners[(c + turn) % 3][0], corners[(c + turn) % 3][1]);
    }
  }
  return numbers;
}

Numbers collinear(Random& random) {
  Numbers numbers;
  for (int i = 0; i < 40; ++i) {
    const double x = snapped(random.number(0, side));
    const double y = snapped(random.number(0, side));
    const double dx = static_cast<double>(random.whole(-200, 200)) / 256;
    const double dy = static_cast<double>(random.whole(-200, 200)) / 256;
    for (int c = 0; c < 3; ++c) {
      const auto steps = static_cast<double>(random.whole(-100, 100));
      push(numbers, x + steps * dx, y + steps * dy);
    }
    if (random.chance(0.3)) {  // a vertex repeated, two or three times
      const auto last = numbers.end() - 2;
      std::copy(last, numbers.end(), last - 2);
      if (random.chance(0.3)) std::copy(last, numbers.end(), last - 4);
    }
  }
  return numbers;
}

void check_nothing_covered(const Numbers& numbers, Verdict& verdict) {
  const std::vector<Triangle> triangles = triangles_of(numbers);
  for (const Triangle& t : triangles) {
    const Eigen::Vector2d a = (t[1] - t[0]).cast<double>();
    const Eigen::Vector2d b = (t[2] - t[0]).cast<double>();
    if (a.x() * b.y() != a.y() * b.x()) return;  // another family's
  }
  const Covered truth = check_coverage(triangles, verdict);
  for (const int count : truth.count.pixels()) {
    verdict.expect(count == 0, [] { return "a triangle without area covers a pixel"; });
  }
}

Numbers centers(Random& random) {
  Numbers numbers;
  for (int i = 0; i < 40; ++i) {
    const double x = static_cast<double>(random.whole(0, 2 * side)) / 2;
    const double y = static_cast<double>(random.whole(0, 2 * side)) / 2;
    const std::int64_t reach = random.whole(1, 60);
    for (int c = 0; c < 3; ++c) {
      push(numbers, x + static_cast<double>(random.whole(-reach, reach)) / 2,
           y + static_cast<double>(random.whole(-reach, reach)) / 2);
    }
  }
  return numbers;
}

/// The centre, then where each of the fan's spokes ends, in units of its angle.
Numbers fan(Random& random) {
  const double x = static_cast<double>(random.whole(100, 150)) + 0.5;
  Numbers numbers = {x, static_cast<double>(random.whole(100, 150)) + 0.5,
                     random.pick({1, 5, 60, 90})};
  for (int i = 0; i < 1000; ++i) numbers.push_back(random.number(0, 1));
  return numbers;
}

void check_fan(const Numbers& numbers, Verdict& verdict) {
  if (numbers.size() < 7) return;
  const Eigen::Vector2d center(numbers[0], numbers[1]);
  const double radius = numbers[2];
  // Four spokes always, so that no triangle reaches around the centre.
  Numbers angles = {0, 0.25, 0.5, 0.75};
  angles.insert(angles.end(), numbers.begin() + 3, numbers.end());
  std::sort(angles.begin(), angles.end());
  const auto spoke = [&](double angle) {
    const Eigen::Vector2d at =
        center + radius * Eigen::Vector2d(std::cos(2 * M_PI * angle), std::sin(2 * M_PI * angle));
    return Eigen::Vector2f(static_cast<float>(snapped(at.x())),
                           static_cast<float>(snapped(at.y())));
  };
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    triangles.push_back(
        {center.cast<float>(), spoke(angles[i]), spoke(angles[(i + 1) % angles.size()])});
  }
  const Covered truth = check_coverage(triangles, verdict);
  verdict.expect(truth.count(static_cast<int>(center.x()), static_cast<int>(center.y())) == 1,
                 [] { return "the sample all triangles meet in is not covered once"; });
  for (const int count : truth.count.pixels()) {
    verdict.expect(count <= 1, [] { return "a sample of a fan is covered twice"; });
  }
}

constexpr int cells = 16;
constexpr double cell = 14;
constexpr int grid_first = 16;

/// How far each inner vertex is moved, and which diagonal each cell has.
Numbers grid(Random& random) {
  Numbers numbers;
  for (int i = 0; i < (cells - 1) * (cells - 1); ++i) {
    const bool on_center = random.chance(0.5);
    for (int axis = 0; axis < 2; ++axis) {
      const double moved = random.number(-0.24 * cell, 0.24 * cell);
      numbers.push_back(on_center ? std::trunc(moved) + 0.5 : snapped(moved));
    }
  }
  for (int i = 0; i < cells * cells; ++i) numbers.push_back(random.chance(0.5) ? 1 : 0);
  return numbers;
}

void check_grid(const Numbers& numbers, Verdict& verdict) {
  constexpr std::size_t inner = (cells - 1) * (cells - 1);
  if (numbers.size() != 2 * inner + cells * cells) return;
  const auto vertex = [&](int column, int row) {
    Eigen::Vector2f at(static_cast<float>(grid_first + cell * column),
                       static_cast<float>(grid_first + cell * row));
    if (column % cells != 0 && row % cells != 0) {
      const auto i = static_cast<std::size_t>((row - 1) * (cells - 1) + column - 1);
      at += Eigen::Vector2f(static_cast<float>(numbers[2 * i]),
                            static_cast<float>(numbers[2 * i + 1]));
    }
    return at;
  };
  std::vector<Triangle> triangles;
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      const Eigen::Vector2f a = vertex(column, row);
      const Eigen::Vector2f b = vertex(column + 1, row);
      const Eigen::Vector2f c = vertex(column, row + 1);
      const Eigen::Vector2f d = vertex(column + 1, row + 1);
      if (numbers[2 * inner + static_cast<std::size_t>(row * cells + column)] != 0) {
        triangles.insert(triangles.end(), {Triangle{a, b, c}, Triangle{b, c, d}});
      } else {
        triangles.insert(triangles.end(), {Triangle{a, b, d}, Triangle{a, c, d}});
      }
    }
  }
  check_coverage(triangles, verdict);
  const Covered drawn = exercise_coverage(triangles);
  const auto grid_last = static_cast<int>(grid_first + cell * cells);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const bool inside = x >= grid_first && x < grid_last && y >= grid_first && y < grid_last;
      verdict.expect(drawn.count(x, y) == (inside ? 1 : 0),
                     [&] { return at(x, y) + " of a grid is not covered exactly once"; });
    }
  }
}

Numbers far_away(Random& random) {
  Numbers numbers;
  for (int i = 0; i < 20; ++i) {
    const double reach = random.pick({500, 5000, 32768});
    for (int c = 0; c < 6; ++c) numbers.push_back(snapped(random.number(-reach, reach)));
  }
  return numbers;
}

Numbers far_beyond(Random& random) {
  Numbers numbers;
  for (int i = 0; i < 20; ++i) {
    const double reach = random.pick({4e4, 1e7, 0x1p30, 1e30, 0x1p124});  // the last: FLT_MAX/16
    for (int c = 0; c < 6; ++c) {
      const bool near = random.chance(0.3);
      numbers.push_back(near ? snapped(random.number(0, side)) : random.number(-reach, reach));
    }
  }
  return numbers;
}

/// What takes any coordinates to ±2^30 px, and refuses what is beyond.
void check_far_beyond(const Numbers& numbers, Verdict& verdict) {
  std::vector<Triangle> in_range;
  Covered found;
  for (const Triangle& t : triangles_of(numbers)) {
    bool refused = false;
    try {
      const auto index = static_cast<int>(in_range.size());
      rasterize_wide_triangle(corners_of(t), side, side,
                              [&](int x, int y, const auto&) { found.add(x, y, index); });
      in_range.push_back(t);
    } catch (const CheckError&) {
      refused = true;
    }
    verdict.expect(refused != within(t, max_wide_coordinate), [&] {
      return std::string("a triangle is ") + (refused ? "" : "not ") + "refused";
    });
  }
  const std::int64_t samples_before = verdict.samples;
  const Covered truth = true_coverage(in_range, verdict);
  expect_same(found, truth, verdict);
  measure_rungs(in_range, truth, verdict.samples - samples_before, verdict);
}

}  // namespace

std::vector<Family> coverage_families() {
  const std::string exact =
      "the last rung and the engine cover exactly the samples that 128-bit "
      "integers say";
  return {
      {"slivers", exact + ", where the third vertex is 1 or 2 sub-pixels off an edge", per_triangle,
       0, slivers, check_triangles},
      {"collinear", "triangles without area cover no sample", per_triangle, 0, collinear,
       check_nothing_covered},
      {"centres", exact + ", where edges and corners run through samples", per_triangle, 0, centers,
       check_triangles},
      {"fans", "of 1000 triangles around one sample exactly one covers it, and none twice", 1, 3,
       fan, check_fan},
      {"grids", "a jittered grid without T-junctions covers each sample exactly once", 0, 0, grid,
       check_grid},
      {"far_away", exact + ", with coordinates to ±32768 px", per_triangle, 0, far_away,
       check_triangles},
      {"far_beyond",
       "wide edge functions cover exactly the samples that 128-bit integers say with coordinates "
       "to "
       "±2^30 px, and refuse those of 1e30 and FLT_MAX/16",
       per_triangle, 0, far_beyond, check_far_beyond},
  };
}

}  // namespace rasterlab::stress
