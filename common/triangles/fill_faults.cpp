#include "common/triangles/fill_faults.h"

#include "common/image/check.h"
#include "common/triangles/pixel_box.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <numeric>

namespace rasterlab {
// <solution>
namespace {

// The side of the line from a to b on which p is once it has been moved right by next to nothing,
// and down by next to nothing of that: the top-left rule, in other words and other arithmetic than
// the rung it judges.
int side(const SnappedPoint& a, const SnappedPoint& b, const SnappedPoint& p) {
  const auto sign = [](Int128 value) { return value > 0 ? 1 : value < 0 ? -1 : 0; };
  const Int128 dx = b.x() - a.x();
  const Int128 dy = b.y() - a.y();
  const int there = sign(dx * (p.y() - a.y()) - dy * (p.x() - a.x()));
  if (there != 0) return there;
  return dy != 0 ? -sign(dy) : sign(dx);
}

bool covers(const SnappedTriangle& corners, int x, int y) {
  const auto& [a, b, c] = corners;
  const SnappedPoint center(x * subpixels + subpixels / 2, y * subpixels + subpixels / 2);
  const int first = side(a, b, center);
  return first != 0 && first == side(b, c, center) && first == side(c, a, center);
}

/// The triangles, each corner where `move` puts it.
template <class Move>
std::vector<Corners> moved(const TriangleSample& sample, Move move) {
  std::vector<Corners> triangles = sample.triangles;
  for (Corners& corners : triangles) {
    for (auto& corner : corners) corner = move(corner);
  }
  return triangles;
}

/// The sum over the sample's pixels of how much two counts differ, `b_at(b, x, y)` being the
/// second.
template <class BAt>
std::int64_t difference(const Coverage& a, const Coverage& b, int size, BAt b_at) {
  std::int64_t sum = 0;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) sum += std::abs(a(x, y) - b_at(b, x, y));
  }
  return sum;
}

std::int64_t changed_by_order(FillTriangle fill, const TriangleSample& sample,
                              const Coverage& drawn) {
  std::array<std::size_t, 3> order = {0, 1, 2};
  std::int64_t worst = 0;
  while (std::next_permutation(order.begin(), order.end())) {
    std::vector<Corners> triangles;
    for (const Corners& corners : sample.triangles) {
      triangles.push_back({corners[order[0]], corners[order[1]], corners[order[2]]});
    }
    const Coverage other = coverage(fill, triangles, sample.size, sample.size);
    worst = std::max(worst, difference(drawn, other, sample.size,
                                       [](const Coverage& b, int x, int y) { return b(x, y); }));
  }
  return worst;
}

std::int64_t changed_by_translation(FillTriangle fill, const TriangleSample& sample,
                                    const Coverage& drawn) {
  static constexpr int right = 37;
  static constexpr int down = 19;
  const auto triangles = moved(sample, [](const Eigen::Vector2d& p) -> Eigen::Vector2d {
    return p + Eigen::Vector2d(int{right}, int{down});
  });
  const Coverage other = coverage(fill, triangles, sample.size + right, sample.size + down);
  return difference(drawn, other, sample.size,
                    [](const Coverage& b, int x, int y) { return b(x + right, y + down); });
}

std::int64_t changed_by_rotation(FillTriangle fill, const TriangleSample& sample,
                                 const Coverage& drawn) {
  const int size = sample.size;
  const auto triangles = moved(
      sample, [size](const Eigen::Vector2d& p) { return Eigen::Vector2d(size - p.y(), p.x()); });
  const Coverage other = coverage(fill, triangles, size, size);
  return difference(drawn, other, size,
                    [size](const Coverage& b, int x, int y) { return b(size - 1 - y, x); });
}

}  // namespace
// </solution>

Coverage exact_coverage(const TriangleSample& sample) {
  // <solution>
  Coverage count(sample.size, sample.size);
  for (const Corners& corners : sample.triangles) {
    const SnappedTriangle snapped = snap(corners);
    const PixelBox box = pixel_box(corners, sample.size, sample.size);
    for (int y = box.top; y <= box.bottom; ++y) {
      for (int x = box.left; x <= box.right; ++x) {
        if (covers(snapped, x, y)) ++count(x, y);
      }
    }
  }
  return count;
  // <starter> throw NotWritten("02.6", sample);
  // </solution>
}

FillFaults fill_faults(FillTriangle fill, const TriangleSample& sample) {
  // <solution>
  const Coverage exact = exact_coverage(sample);
  const Coverage drawn = coverage(fill, sample.triangles, sample.size, sample.size);
  std::int64_t covered = 0;
  std::int64_t missing = 0;
  std::int64_t extra = 0;
  std::int64_t doubled = 0;
  for (std::size_t i = 0; i < exact.pixels().size(); ++i) {
    const int surplus = drawn.pixels()[i] - exact.pixels()[i];
    covered += exact.pixels()[i];
    missing += std::max(-surplus, 0);
    (exact.pixels()[i] == 0 ? extra : doubled) += std::max(surplus, 0);
  }
  const auto per_million = [&](std::int64_t pixels) {
    return 1e6 * static_cast<double>(pixels) /
           static_cast<double>(std::max<std::int64_t>(covered, 1));
  };
  return {.missing = per_million(missing),
          .extra = per_million(extra),
          .doubled = per_million(doubled),
          .order = per_million(changed_by_order(fill, sample, drawn)),
          .translation = per_million(changed_by_translation(fill, sample, drawn)),
          .rotation = per_million(changed_by_rotation(fill, sample, drawn))};
  // <starter> throw NotWritten("02.6", fill, sample);
  // </solution>
}

Image<Rgb8> fault_picture(const Coverage& drawn, const Coverage& exact) {
  Image<Rgb8> picture(exact.width(), exact.height());
  for (int y = 0; y < exact.height(); ++y) {
    for (int x = 0; x < exact.width(); ++x) {
      if (drawn(x, y) == exact(x, y)) {
        if (exact(x, y) > 0) picture(x, y) = Rgb8{255, 255, 255};
      } else if (drawn(x, y) < exact(x, y)) {
        picture(x, y) = Rgb8{255, 0, 0};
      } else {
        picture(x, y) = exact(x, y) > 0 ? Rgb8{255, 200, 0} : Rgb8{0, 96, 255};
      }
    }
  }
  return picture;
}

std::string fill_fault_table() {
  std::string table = "per million pixels that are exactly covered\n";
  char row[160];
  for (const TriangleSample& sample : fill_samples()) {
    table += sample.name + "\n";
    std::snprintf(row, sizeof row, "  %-20s %9s %9s %9s %9s %12s %9s\n", "rung", "missing", "extra",
                  "doubled", "order", "translation", "rotation");
    table += row;
    for (const FillRung& rung : fill_ladder) {
      const FillFaults faults = fill_faults(rung.fill, sample);
      std::snprintf(row, sizeof row, "  %-20s %9.0f %9.0f %9.0f %9.0f %12.0f %9.0f\n", rung.name,
                    faults.missing, faults.extra, faults.doubled, faults.order, faults.translation,
                    faults.rotation);
      table += row;
    }
  }
  return table;
}

}  // namespace rasterlab
