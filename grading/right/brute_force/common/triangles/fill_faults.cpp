// A right answer written differently: on which side of each edge the centre is, the two that tie
// told apart by hand.
#include "common/triangles/fill_faults.h"

#include "common/image/check.h"
#include "common/triangles/edge_function.h"
#include "common/triangles/pixel_box.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <utility>
#include <vector>

namespace rasterlab {
namespace {

// Of a triangle whose corners go clockwise, seen with y down.
bool inside(SnappedTriangle corners, int x, int y) {
  const SnappedPoint center(x * subpixels + subpixels / 2, y * subpixels + subpixels / 2);
  const Int128 area = cross<Int128>(corners[0], corners[1], corners[2]);
  if (area == 0) return false;
  if (area < 0) std::swap(corners[1], corners[2]);
  for (std::size_t i = 0; i < 3; ++i) {
    const SnappedPoint &a = corners[i], &b = corners[(i + 1) % 3];
    const Int128 where = cross<Int128>(a, b, center);
    const bool is_top = a.y() == b.y() && b.x() > a.x();
    const bool is_left = b.y() < a.y();
    if (where < 0 || (where == 0 && !is_top && !is_left)) return false;
  }
  return true;
}

/// What is drawn when each corner is moved by `corner_to`, looked up where `pixel_to` says.
template <class CornerTo, class PixelTo>
double changed(FillTriangle fill, const TriangleSample& sample, int size, const Coverage& drawn,
               CornerTo corner_to, PixelTo pixel_to) {
  std::vector<Corners> triangles;
  for (const Corners& corners : sample.triangles) {
    triangles.push_back({corner_to(corners, 0), corner_to(corners, 1), corner_to(corners, 2)});
  }
  const Coverage other = coverage(fill, triangles, size, size);
  double sum = 0;
  for (int y = 0; y < sample.size; ++y) {
    for (int x = 0; x < sample.size; ++x) {
      const auto [column, row] = pixel_to(x, y);
      sum += std::abs(double(drawn(x, y)) - double(other(column, row)));
    }
  }
  return sum;
}

}  // namespace

Coverage exact_coverage(const TriangleSample& sample) {
  Coverage count(sample.size, sample.size);
  for (const Corners& corners : sample.triangles) {
    const SnappedTriangle snapped = snap(corners);
    for (int y = 0; y < sample.size; ++y) {
      for (int x = 0; x < sample.size; ++x) {
        if (inside(snapped, x, y)) count_up(count(x, y));
      }
    }
  }
  return count;
}

FillFaults fill_faults(FillTriangle fill, const TriangleSample& sample) {
  const Coverage exact = exact_coverage(sample);
  const Coverage drawn = coverage(fill, sample.triangles, sample.size, sample.size);

  double covered = 0, missing = 0, extra = 0, doubled = 0;
  for (int y = 0; y < sample.size; ++y) {
    for (int x = 0; x < sample.size; ++x) {
      covered += exact(x, y);
      missing += std::max(exact(x, y) - drawn(x, y), 0);
      const double surplus = std::max(drawn(x, y) - exact(x, y), 0);
      if (exact(x, y) == 0) {
        extra += surplus;
      } else {
        doubled += surplus;
      }
    }
  }

  const auto same_pixel = [](int x, int y) { return std::pair(x, y); };
  double order = 0;
  for (const auto& way : {std::array{0, 2, 1}, std::array{1, 0, 2}, std::array{1, 2, 0},
                          std::array{2, 0, 1}, std::array{2, 1, 0}}) {
    const auto other_corner = [&](const Corners& corners, std::size_t i) {
      return corners[static_cast<std::size_t>(way[i])];
    };
    order = std::max(order, changed(fill, sample, sample.size, drawn, other_corner, same_pixel));
  }
  const Eigen::Vector2d offset(11, 11);
  const double translation = changed(
      fill, sample, sample.size + 11, drawn,
      [&](const Corners& corners, std::size_t i) { return Eigen::Vector2d(corners[i] + offset); },
      [](int x, int y) { return std::pair(x + 11, y + 11); });
  const double size = sample.size;
  const double rotation = changed(
      fill, sample, sample.size, drawn,
      [&](const Corners& corners, std::size_t i) {
        return Eigen::Vector2d(size - corners[i].y(), corners[i].x());
      },
      [&](int x, int y) { return std::pair(sample.size - 1 - y, x); });
  const double scale = 1e6 / std::max(covered, 1.0);
  FillFaults result;
  result.missing = missing * scale;
  result.extra = extra * scale;
  result.doubled = doubled * scale;
  result.order = order * scale;
  result.translation = translation * scale;
  result.rotation = rotation * scale;
  return result;
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
