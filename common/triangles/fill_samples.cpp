#include "common/triangles/fill_faults.h"

#include <cmath>
#include <numbers>
#include <random>

namespace rasterlab {
namespace {

/// Numbers that are the same everywhere: std::uniform_real_distribution's differ between libraries.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}

  /// A multiple of 1/256 in [low, high).
  double on_grid(int low, int high) {
    return low + static_cast<double>(engine_() % static_cast<unsigned>((high - low) * subpixels)) /
                     subpixels;
  }

 private:
  std::mt19937 engine_;
};

double on_grid(double pixels) {
  return std::round(pixels * subpixels) / subpixels;
}

constexpr int tiles = 12;
constexpr int tile = 48;

/// One triangle in each square of a board, made by `make(corner of the square)`.
template <class Make>
TriangleSample one_by_one(const char* name, Make make) {
  TriangleSample sample{.name = name, .size = tiles * tile, .triangles = {}};
  for (int y = 0; y < tiles; ++y) {
    for (int x = 0; x < tiles; ++x)
      sample.triangles.push_back(make(Eigen::Vector2d(x * tile + 2, y * tile + 2)));
  }
  return sample;
}

TriangleSample random_triangles() {
  Random random(1);
  return one_by_one("random triangles", [&](const Eigen::Vector2d& corner) {
    Corners corners;
    for (auto& point : corners)
      point = corner + Eigen::Vector2d(random.on_grid(0, tile - 4), random.on_grid(0, tile - 4));
    return corners;
  });
}

TriangleSample slivers() {
  Random random(2);
  return one_by_one("slivers", [&](const Eigen::Vector2d& corner) {
    const Eigen::Vector2d a =
        corner + Eigen::Vector2d(random.on_grid(0, tile - 5), random.on_grid(0, tile - 5));
    const Eigen::Vector2d b =
        corner + Eigen::Vector2d(random.on_grid(0, tile - 5), random.on_grid(0, tile - 5));
    return Corners{a, b, a + Eigen::Vector2d(random.on_grid(0, 1), random.on_grid(0, 1))};
  });
}

TriangleSample disc() {
  constexpr int sectors = 60;
  constexpr int rings = 8;
  const auto point = [](int sector, int ring) {
    const double angle = 2 * std::numbers::pi * (sector % sectors) / sectors;
    const double radius = 14.0 * ring;
    return Eigen::Vector2d(on_grid(120.3 + radius * std::cos(angle)),
                           on_grid(119.8 + radius * std::sin(angle)));
  };
  TriangleSample sample{.name = "disc", .size = 240, .triangles = {}};
  for (int ring = 0; ring < rings; ++ring) {
    for (int sector = 0; sector < sectors; ++sector) {
      const Eigen::Vector2d a = point(sector, ring);
      const Eigen::Vector2d b = point(sector, ring + 1);
      const Eigen::Vector2d c = point(sector + 1, ring + 1);
      sample.triangles.push_back({a, b, c});
      if (ring > 0) sample.triangles.push_back({a, c, point(sector + 1, ring)});
    }
  }
  return sample;
}

TriangleSample shaken_grid() {
  constexpr int cells = 22;
  Random random(3);
  std::vector<Eigen::Vector2d> vertices;
  for (int y = 0; y <= cells; ++y) {
    for (int x = 0; x <= cells; ++x) {
      const bool border = x == 0 || y == 0 || x == cells || y == cells;
      Eigen::Vector2d shake(random.on_grid(-3, 3), random.on_grid(-3, 3));
      if (border)
        shake = {0.25, 0.25};  // no centre is on the outline, so that its owner is no question
      if (!border && (x + y) % 2 == 0) shake = shake.array().floor() + 0.5;
      vertices.emplace_back(Eigen::Vector2d(10 + 10 * x, 10 + 10 * y) + shake);
    }
  }
  TriangleSample sample{.name = "grid on centres", .size = 240, .triangles = {}};
  for (int y = 0; y < cells; ++y) {
    for (int x = 0; x < cells; ++x) {
      const auto vertex = [&](int right, int down) {
        const int index = (y + down) * (cells + 1) + x + right;
        return vertices[static_cast<std::size_t>(index)];
      };
      sample.triangles.push_back({vertex(0, 0), vertex(0, 1), vertex(1, 1)});
      sample.triangles.push_back({vertex(1, 1), vertex(1, 0), vertex(0, 0)});
    }
  }
  return sample;
}

}  // namespace

std::vector<TriangleSample> fill_samples() {
  return {random_triangles(), disc(), shaken_grid(), slivers()};
}

}  // namespace rasterlab
