#include "common/lines/line_faults.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <random>
#include <utility>

namespace rasterlab {
namespace {

using Pixels = std::vector<std::pair<int, int>>;

/// The pixels of a line in a fixed order, each once.
Pixels distinct_pixels(const LineDiscrete& line) {
  Pixels pixels;
  for (const Point& pixel : line) pixels.emplace_back(pixel.x(), pixel.y());
  std::sort(pixels.begin(), pixels.end());
  pixels.erase(std::unique(pixels.begin(), pixels.end()), pixels.end());
  return pixels;
}

double distance_along_minor_axis(const Point& pixel, const Segment& segment) {
  using Vector = Eigen::Matrix<std::int64_t, 2, 1>;
  const Vector way = segment.p1.cast<std::int64_t>() - segment.p0.cast<std::int64_t>();
  const Vector off = pixel.cast<std::int64_t>() - segment.p0.cast<std::int64_t>();
  const std::int64_t major = std::max(std::abs(way.x()), std::abs(way.y()));
  if (major == 0) return static_cast<double>(off.cwiseAbs().maxCoeff());
  const std::int64_t cross = way.x() * off.y() - way.y() * off.x();
  return static_cast<double>(std::abs(cross)) / static_cast<double>(major);
}

void add(LineFaults& sum, const LineFaults& faults) {
  sum.distance = std::max(sum.distance, faults.distance);
  sum.gaps += faults.gaps;
  sum.missing_ends += faults.missing_ends;
  sum.doubled += faults.doubled;
  sum.changed_by_swap += faults.changed_by_swap;
}

}  // namespace

LineFaults line_faults(LineDiscrete (*line)(const Point&, const Point&), const Segment& segment) {
  const LineDiscrete drawn = line(segment.p0, segment.p1);
  LineFaults faults;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    faults.distance = std::max(faults.distance, distance_along_minor_axis(drawn[i], segment));
    if (i > 0 && (drawn[i] - drawn[i - 1]).cwiseAbs().maxCoeff() > 1) ++faults.gaps;
  }
  for (const Point& end : {segment.p0, segment.p1}) {
    if (std::find(drawn.begin(), drawn.end(), end) == drawn.end()) ++faults.missing_ends;
  }
  const Pixels there = distinct_pixels(drawn);
  const Pixels back = distinct_pixels(line(segment.p1, segment.p0));
  faults.doubled = static_cast<std::int64_t>(drawn.size() - there.size());
  Pixels changed;
  std::set_symmetric_difference(there.begin(), there.end(), back.begin(), back.end(),
                                std::back_inserter(changed));
  faults.changed_by_swap = static_cast<std::int64_t>(changed.size());
  return faults;
}

LineFaults line_faults(LineDiscrete (*line)(const Point&, const Point&),
                       const std::vector<Segment>& segments) {
  LineFaults sum;
  for (const Segment& segment : segments) add(sum, line_faults(line, segment));
  return sum;
}

std::vector<Segment> short_segments() {
  std::vector<Segment> segments;
  for (int y = -20; y <= 20; ++y) {
    for (int x = -20; x <= 20; ++x) segments.push_back({{0, 0}, {x, y}});
  }
  return segments;
}

std::vector<Segment> random_segments(int count, int reach) {
  std::mt19937 random(1965);
  // Not std::uniform_int_distribution, whose values differ between libraries.
  const auto coordinate = [&] {
    return static_cast<int>(random() % (2 * static_cast<unsigned>(reach) + 1)) - reach;
  };
  std::vector<Segment> segments(static_cast<std::size_t>(count));
  for (Segment& segment : segments) {
    for (int* value : {&segment.p0.x(), &segment.p0.y(), &segment.p1.x(), &segment.p1.y()})
      *value = coordinate();
  }
  return segments;
}

std::string line_fault_table() {
  const std::pair<const char*, std::vector<Segment>> samples[] = {
      {"all 1681 segments from (0,0) within +-20", short_segments()},
      {"1000 random segments within +-500", random_segments(1000, 500)},
      {"20 random segments within +-50000", random_segments(20, 50000)}};
  std::string table;
  char row[160];
  for (const auto& [title, segments] : samples) {
    table += std::string(title) + "\n";
    std::snprintf(row, sizeof row, "  %-16s %12s %10s %12s %10s %16s\n", "rung", "distance", "gaps",
                  "ends missing", "doubled", "changed by swap");
    table += row;
    for (const LineRung& rung : line_ladder) {
      const LineFaults faults = line_faults(rung.line, segments);
      std::snprintf(row, sizeof row, "  %-16s %12.6g %10lld %12lld %10lld %16lld\n", rung.name,
                    faults.distance, static_cast<long long>(faults.gaps),
                    static_cast<long long>(faults.missing_ends),
                    static_cast<long long>(faults.doubled),
                    static_cast<long long>(faults.changed_by_swap));
      table += row;
    }
  }
  return table;
}

}  // namespace rasterlab
