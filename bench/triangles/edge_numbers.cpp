#include "bench/triangles/edge_numbers.h"

#include "common/image/image.h"
#include "common/triangles/edge_function.h"

#include "bench/support/random_number.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

namespace rasterlab::bench {
namespace {

constexpr int tile_size = 8;

/// As many numbers as every x86-64 and every ARM of 64 bit computes with at once; and of each
/// whether it is so: −1 or 0, as wide as the numbers.
template <class Number>
using Wide [[gnu::vector_size(16)]] = Number;
template <class Number>
using Truths =
    Wide<std::conditional_t<sizeof(Number) == sizeof(std::int32_t), std::int32_t, std::int64_t>>;
template <class Number>
constexpr int lanes = 16 / sizeof(Number);

/// 0, 1 and so on.
template <class Number>
Wide<Number> steps() {
  Wide<Number> numbers{};
  for (int i = 0; i < lanes<Number>; ++i) numbers[i] = static_cast<Number>(i);
  return numbers;
}

/// Where an edge function's constant is computed.
enum class Anchor { origin, vertex, tile };

/// An edge function in one kind of number, in 1/256 pixel: all of its inputs are whole numbers that
/// every kind holds exactly, so that only products and sums are rounded.
template <class Number, Anchor anchor>
class Edge {
 public:
  Edge() = default;
  Edge(const SnappedPoint& a, const SnappedPoint& b, const EdgeFunction& exact)
      : exact_(exact),
        to_right_(static_cast<Number>(a.y() - b.y())),
        down_(static_cast<Number>(b.x() - a.x())),
        from_x_(static_cast<Number>(a.x())),
        from_y_(static_cast<Number>(a.y())),
        constant_(-(to_right_ * from_x_ + down_ * from_y_)),
        threshold_(exact.owns_boundary() ? Number(0) : smallest()) {}

  /// To be called before at() with the first pixel of a tile.
  void enter_tile(int x, int y) {
    if constexpr (anchor == Anchor::tile) {
      constant_ = static_cast<Number>(exact_.at(x, y));
      left_ = x;
      top_ = y;
    }
  }

  /// Of pixels x, x + 1 … of a row, keeps those in `inside` that are on the edge's side.
  void restrict_to(Truths<Number>& inside, int x, int y) const {
    const auto at = [](std::int64_t coordinate) { return static_cast<Number>(coordinate); };
    if constexpr (anchor == Anchor::tile) {
      const Wide<Number> across = (steps<Number>() + at(x - left_)) * at(subpixels);
      inside &= to_right_ * across + (down_ * at(subpixels * (y - top_)) + constant_) >= threshold_;
    } else {
      const Wide<Number> center_x = (steps<Number>() + at(x)) * at(subpixels) + at(subpixels / 2);
      const Number center_y = at(subpixels * y + subpixels / 2);
      if constexpr (anchor == Anchor::vertex) {
        inside &= to_right_ * (center_x - from_x_) + down_ * (center_y - from_y_) >= threshold_;
      } else {
        inside &= to_right_ * center_x + (down_ * center_y + constant_) >= threshold_;
      }
    }
  }

 private:
  /// The smallest value that is not 0: what an edge that does not own its boundary asks for.
  static Number smallest() {
    return std::is_integral_v<Number> ? Number(1) : std::numeric_limits<Number>::denorm_min();
  }

  EdgeFunction exact_;
  Number to_right_ = 0;  ///< per 1/256 pixel
  Number down_ = 0;
  Number from_x_ = 0;
  Number from_y_ = 0;
  Number constant_ = 0;
  Number threshold_ = 0;
  int left_ = 0;
  int top_ = 0;
};

/// The pixels whose centres the box around a triangle holds, widened to whole tiles.
struct Tiles {
  int left, top, right, bottom;
};

Tiles tiles_of(const SnappedTriangle& corners) {
  const auto down = [](std::int64_t coordinate) {
    return static_cast<int>(coordinate >> 8) & -tile_size;
  };
  const auto [left, right] = std::minmax({corners[0].x(), corners[1].x(), corners[2].x()});
  const auto [top, bottom] = std::minmax({corners[0].y(), corners[1].y(), corners[2].y()});
  return {down(left), down(top), down(right), down(bottom)};
}

/// Calls `visit(x, y, inside)` for a few pixels of a row at a time of every tile about the
/// triangle; inside[i] says whether pixel (x + i, y) is covered. Counter-clockwise triangles cover
/// nothing.
template <class Number, Anchor anchor, class Visit>
void cover(const SnappedTriangle& corners, Visit visit) {
  const TriangleEdges exact = make_edges(corners);
  std::array<Edge<Number, anchor>, 3> edges;
  for (std::size_t i = 0; i < 3; ++i)
    edges[i] = {corners[(i + 1) % 3], corners[(i + 2) % 3], exact.edges[i]};
  const Tiles tiles = tiles_of(corners);
  for (int top = tiles.top; top <= tiles.bottom; top += tile_size) {
    for (int left = tiles.left; left <= tiles.right; left += tile_size) {
      for (auto& edge : edges) edge.enter_tile(left, top);
      for (int y = top; y < top + tile_size; ++y) {
        for (int x = left; x < left + tile_size; x += lanes<Number>) {
          Truths<Number> inside = ~Truths<Number>{};
          for (const auto& edge : edges) edge.restrict_to(inside, x, y);
          visit(x, y, inside);
        }
      }
    }
  }
}

/// A grid of clockwise triangles (y down) without gaps whose inner vertices are anywhere near where
/// a regular grid has them, many of them on pixels' centres.
std::vector<SnappedTriangle> jittered_grid(const Grid& grid) {
  std::mt19937 random(17);
  std::vector<SnappedPoint> vertices;
  for (int row = 0; row <= grid.cells; ++row) {
    for (int column = 0; column <= grid.cells; ++column) {
      const bool on_center = random() % 4 == 0;
      const auto jitter = [&](int index) -> std::int64_t {
        if (index == 0 || index == grid.cells) return 0;
        const double most = 0.2 * static_cast<double>(subpixels) * grid.cell_pixels;
        const auto off = static_cast<std::int64_t>(random_number(random, -most, most));
        return on_center ? (off & -256) + 128 : off;
      };
      const auto at = [&](int index) {
        return subpixels * (grid.place + grid.cell_pixels * index);
      };
      const std::int64_t x = at(column) + jitter(column);
      vertices.emplace_back(x, at(row) + jitter(row));
    }
  }
  std::vector<SnappedTriangle> triangles;
  const auto add = [&](int a, int b, int c) {
    const auto vertex = [&](int i) { return vertices[static_cast<std::size_t>(i)]; };
    triangles.push_back({vertex(a), vertex(b), vertex(c)});
  };
  for (int row = 0; row < grid.cells; ++row) {
    for (int column = 0; column < grid.cells; ++column) {
      const int a = row * (grid.cells + 1) + column;
      const int c = a + grid.cells + 1;
      add(a, a + 1, c + 1);
      add(a, c + 1, c);
    }
  }
  return triangles;
}

template <class Number, Anchor anchor>
Errors errors_of(const std::vector<SnappedTriangle>& triangles, const Grid& grid) {
  double missing = 0;
  double extra = 0;
  double covered = 0;
  Image<int> times(grid.side(), grid.side());
  for (const SnappedTriangle& corners : triangles) {
    const BasicTriangleEdges<Int128> exact = make_edges<Int128>(corners);
    cover<Number, anchor>(corners, [&](int x, int y, const Truths<Number>& inside) {
      for (int i = 0; i < lanes<Number>; ++i) {
        const bool shown = inside[i] != 0;
        const bool right =
            std::all_of(exact.edges.begin(), exact.edges.end(),
                        [&](const auto& edge) { return edge.at(x + i, y) >= edge.threshold(); });
        missing += right && !shown ? 1 : 0;
        extra += shown && !right ? 1 : 0;
        covered += right ? 1 : 0;
        if (shown && times.contains(x + i - grid.place, y - grid.place))
          ++times.row(y - grid.place)[x + i - grid.place];
      }
    });
  }
  const auto doubled = static_cast<double>(std::count_if(
      times.pixels().begin(), times.pixels().end(), [](int count) { return count > 1; }));
  const double scale = 1e6 / covered;
  return {{"missing + extra per million", scale * (missing + extra)},
          {"missing per million", scale * missing},
          {"extra per million", scale * extra},
          {"doubled per million", scale * doubled}};
}

template <class Number, Anchor anchor>
void add(TimedLadder& ladder, const std::vector<SnappedTriangle>& triangles, const Grid& grid,
         const char* name, const char* fault) {
  const auto sum = std::make_shared<std::int64_t>(0);
  ladder.rungs.push_back(
      {.name = name,
       .fault = fault,
       .work =
           [triangles, sum] {
             Truths<Number> count{};
             for (const SnappedTriangle& corners : triangles) {
               cover<Number, anchor>(
                   corners, [&](int, int, const Truths<Number>& inside) { count -= inside; });
             }
             for (int i = 0; i < lanes<Number>; ++i) *sum += count[i];
           },
       .errors = errors_of<Number, anchor>(triangles, grid)});
}

template <class Number>
void add_anchors(TimedLadder& ladder, const std::vector<SnappedTriangle>& triangles,
                 const Grid& grid, const std::string& name, const char* at_origin,
                 const char* at_vertex, const char* at_tile) {
  add<Number, Anchor::origin>(ladder, triangles, grid, (name + ", origin").c_str(), at_origin);
  add<Number, Anchor::vertex>(ladder, triangles, grid, (name + ", vertex").c_str(), at_vertex);
  add<Number, Anchor::tile>(ladder, triangles, grid, (name + ", tile").c_str(), at_tile);
}

}  // namespace

TimedLadder edge_number_ladder(const Grid& grid) {
  const std::vector<SnappedTriangle> triangles = jittered_grid(grid);
  double samples = 0;
  for (const SnappedTriangle& corners : triangles) {
    const Tiles tiles = tiles_of(corners);
    samples += (tiles.right - tiles.left + tile_size) * (tiles.bottom - tiles.top + tile_size);
  }
  TimedLadder ladder{.name = "edge functions, triangles of " + std::to_string(grid.cell_pixels) +
                             " pixels from pixel " + std::to_string(grid.place) + " on",
                     .stage = "02",
                     .unit = "tested sample",
                     .units = samples,
                     .error = "missing + extra per million",
                     .rungs = {}};
  add_anchors<float>(ladder, triangles, grid, "float",
                     "large terms cancel, and take the digits along",
                     "an edge has another value from its other end: gaps and doubles",
                     "rounds what is near an edge of long triangles");
  add_anchors<double>(ladder, triangles, grid, "double", "none within 2^26 pixels",
                      "none within 2^26 pixels", "none within 2^26 pixels");
  add_anchors<std::int64_t>(ladder, triangles, grid, "int64", "none", "none", "none");
  return ladder;
}

}  // namespace rasterlab::bench
