// bench_02_triangles: the ladder of exercise 02.4, and the quick fill against OpenCV's.
#include "common/triangles/fill_edge_functions.h"
#include "common/triangles/fill_faults.h"
#include "common/triangles/fill_ladder.h"
#include "common/triangles/fill_spans.h"
#include "common/triangles/fill_triangle_list.h"
#include "common/triangles/spans.h"

#include "bench/support/memory_limit.h"
#include "bench/support/program.h"
#include "bench/support/random_number.h"
#include "bench/triangles/edge_numbers.h"
#include "bench/triangles/peer.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <random>

namespace rasterlab::bench {
namespace {

constexpr Rgb8 color{10, 20, 30};

Errors errors_of(const FillFaults& faults) {
  return {{"missing per million", faults.missing},
          {"extra per million", faults.extra},
          {"doubled per million", faults.doubled},
          {"wrong per million", faults.missing + faults.extra + faults.doubled},
          {"changed by order", faults.order},
          {"by translation", faults.translation},
          {"by rotation", faults.rotation}};
}

/// Every rung of exercise 02.4 and the quick fill on one of the inputs that exercise 02.6 measures.
TimedLadder fill_ladder_on(std::size_t index) {
  const TriangleSample sample = fill_samples()[index];
  const Coverage truth = exact_coverage(sample);
  TimedLadder ladder{.name = "02.4 fill, " + sample.name,
                     .stage = "02",
                     .unit = "covered pixel",
                     .units = std::accumulate(truth.pixels().begin(), truth.pixels().end(), 0.0),
                     .error = "wrong per million",
                     .rungs = {}};
  const auto add = [&](const char* name, FillTriangle fill, const char* fault) {
    const auto image = std::make_shared<Image<Rgb8>>(sample.size, sample.size);
    ladder.rungs.push_back({.name = name,
                            .fault = fault,
                            .work =
                                [image, fill, triangles = sample.triangles] {
                                  for (const Corners& corners : triangles)
                                    fill(*image, corners, color);
                                },
                            .errors = errors_of(fill_faults(fill, sample))});
  };
  for (const FillRung& rung : fill_ladder) add(rung.name, rung.fill, rung.known_fault);
  add(
      "spans",
      [](Image<Rgb8>& image, const Corners& corners, const Rgb8& c) {
        fill_spans(image, corners, c);
      },
      "none");
  return ladder;
}

/// Triangles of one area and any shape that is not too thin, anywhere inside the image.
std::vector<Corners> triangles_inside(std::size_t count, double area, const Image<Rgb8>& image) {
  std::mt19937 random(1);
  std::vector<Corners> triangles;
  while (triangles.size() < count) {
    Corners corners;
    for (Eigen::Vector2d& corner : corners) {
      corner.x() = random_number(random, 0, 1);
      corner.y() = random_number(random, 0, 1);
    }
    const Eigen::Vector2d place(random_number(random, 0, image.width()),
                                random_number(random, 0, image.height()));
    const Eigen::Vector2d a = corners[1] - corners[0];
    const Eigen::Vector2d b = corners[2] - corners[0];
    const double shape = std::abs(a.x() * b.y() - a.y() * b.x()) / 2;
    if (shape < 0.05) continue;
    bool inside = true;
    for (Eigen::Vector2d& corner : corners) {
      corner = ((place + corner * std::sqrt(area / shape)) * 256).array().round() / 256;
      inside &=
          corner.minCoeff() >= 0 && corner.x() <= image.width() && corner.y() <= image.height();
    }
    if (inside) triangles.push_back(corners);
  }
  return triangles;
}

/// Pixels that differ from those of the last rung, per million of those.
double difference(const Image<Rgb8>& drawn, const std::vector<Corners>& triangles) {
  Image<Rgb8> exact(drawn.width(), drawn.height());
  for (const Corners& corners : triangles) fill_edge_functions(exact, corners, color);
  double covered = 0;
  double different = 0;
  for (std::size_t i = 0; i < exact.pixels().size(); ++i) {
    covered += exact.pixels()[i] == color ? 1 : 0;
    different += exact.pixels()[i] == drawn.pixels()[i] ? 0 : 1;
  }
  return 1e6 * different / covered;
}

Errors judged(Image<Rgb8>& image, const std::vector<Corners>& triangles,
              const std::function<void()>& draw) {
  image.clear({});
  draw();
  return {{"different pixels per million", difference(image, triangles)}};
}

TimedRung peer_rung(Image<Rgb8>& image, const std::vector<Corners>& triangles) {
  const std::function<void()> peer = opencv_triangles(image, triangles, color);
  return {.name = "cv::fillConvexPoly",
          .fault = "draws its boundary too: up to a pixel too large",
          .work = peer,
          .errors = judged(image, triangles, peer),
          .role = Role::peer};
}

TimedRung quick_rung(const std::string& name, Image<Rgb8>& image,
                     const std::vector<Corners>& triangles, const std::function<void()>& draw) {
  return {.name = name, .fault = "none", .work = draw, .errors = judged(image, triangles, draw)};
}

/// The quick fill and OpenCV's into one picture, one call a triangle, and what the picture's memory
/// alone takes. Many triangles, lest the processor learn the way of each by heart.
TimedLadder race_of_calls(int area) {
  const auto image = std::make_shared<Image<Rgb8>>(1920, 1080);
  const std::vector<Corners> triangles = triangles_inside(4096, area, *image);
  MemoryLimit limit(*image);
  for (const Corners& corners : triangles) {
    for_each_span(snap(corners), image->width(), image->height(), [&](int y, int begin, int end) {
      limit.add(std::ptrdiff_t{y} * image->width() + begin, end - begin);
    });
  }
  TimedLadder ladder{.name = "triangles of " + std::to_string(area) + " pixels",
                     .stage = "02",
                     .unit = "triangle",
                     .units = static_cast<double>(triangles.size()),
                     .error = "different pixels per million",
                     .rungs = {{.name = "one byte a cache line",
                                .fault = "draws nothing: what the memory takes",
                                .work = limit,
                                .errors = {},
                                .role = Role::limit},
                               peer_rung(*image, triangles)}};
  for (const SpanFill& way : span_fills()) {
    const auto quick = [image, triangles, fill = way.fill] {
      for (const Corners& corners : triangles) fill(*image, corners, color);
    };
    ladder.rungs.push_back(
        quick_rung(std::string("fill_spans, ") + way.name, *image, triangles, quick));
  }
  return ladder;
}

/// The same of lists, which are drawn by one call, too.
TimedLadder race_of_lists(std::size_t count, int area) {
  const auto image = std::make_shared<Image<Rgb8>>(1920, 1080);
  const std::vector<Corners> triangles = triangles_inside(count, area, *image);
  TimedLadder ladder{.name = "list of " + std::to_string(count) + " triangles of " +
                             std::to_string(area) + " pixels",
                     .stage = "02",
                     .unit = "triangle",
                     .units = static_cast<double>(triangles.size()),
                     .error = "different pixels per million",
                     .rungs = {peer_rung(*image, triangles)}};
  for (const TriangleListWay& way : triangle_list_ways()) {
    const auto quick = [image, triangles, fill = way.fill] { fill(*image, triangles, color); };
    ladder.rungs.push_back(
        quick_rung(std::string("fill_triangle_list, ") + way.name, *image, triangles, quick));
  }
  return ladder;
}

std::vector<MakeLadder> ladders() {
  std::vector<MakeLadder> all;
  for (const std::size_t index : {0U, 1U, 2U, 3U})
    all.emplace_back([index] { return fill_ladder_on(index); });
  for (const Grid& grid : {Grid{0, 16, 16}, {16000, 16, 16}, {16000, 3, 512}})
    all.emplace_back([grid] { return edge_number_ladder(grid); });
  for (const int area : {10, 100, 1000, 10000}) {
    for (const int count : {4096, 10'000'000 / area}) {
      all.emplace_back(
          [count, area] { return race_of_lists(static_cast<std::size_t>(count), area); });
    }
  }
  for (const int area : {10, 100, 1000, 10000})
    all.emplace_back([area] { return race_of_calls(area); });
  return all;
}

}  // namespace
}  // namespace rasterlab::bench

int main(int argc, char** argv) {
  using namespace rasterlab::bench;
  return run_program(
      argc, argv,
      {.name = "bench_02_triangles",
       .description = "Stage 02: time and error of every way to fill a triangle; the quick fill "
                      "against OpenCV's",
       .ladders = ladders()});
}
