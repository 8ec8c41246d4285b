// bench_01_lines: the ladder of exercise 01.5, and the quick lines against OpenCV's.
#include "common/lines/bresenham.h"
#include "common/lines/draw_line_list.h"
#include "common/lines/draw_line_runs.h"
#include "common/lines/draw_pixels.h"
#include "common/lines/line_faults.h"
#include "common/lines/line_ladder.h"

#include "bench/lines/peer.h"
#include "bench/support/memory_limit.h"
#include "bench/support/program.h"
#include "bench/support/random_number.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>

namespace rasterlab::bench {
namespace {

constexpr Rgb8 color{10, 20, 30};

double pixels_of(const std::vector<Segment>& segments) {
  double pixels = 0;
  for (const auto& [p0, p1] : segments) pixels += (p1 - p0).cwiseAbs().maxCoeff() + 1;
  return pixels;
}

/// Steps along the major axis for which `line` has no pixel within half a pixel of the segment, and
/// pixels that are none of those, or come again.
double wrong_pixels(const LineDiscrete& line, const Segment& segment) {
  using Vector = Eigen::Matrix<std::int64_t, 2, 1>;
  const Vector way = segment.p1.cast<std::int64_t>() - segment.p0.cast<std::int64_t>();
  const int axis = std::abs(way.y()) > std::abs(way.x()) ? 1 : 0;
  const std::int64_t major = std::abs(way[axis]);
  std::vector<bool> has_pixel(static_cast<std::size_t>(major) + 1, false);
  std::size_t right = 0;
  for (const Point& pixel : line) {
    const Vector off = pixel.cast<std::int64_t>() - segment.p0.cast<std::int64_t>();
    const std::int64_t step = way[axis] < 0 ? -off[axis] : off[axis];
    const std::int64_t distance = std::abs(way.x() * off.y() - way.y() * off.x());  // times major
    if (step < 0 || step > major || 2 * distance > major) continue;
    if (major == 0 && off != Vector::Zero()) continue;
    if (has_pixel[static_cast<std::size_t>(step)]) continue;
    has_pixel[static_cast<std::size_t>(step)] = true;
    ++right;
  }
  return static_cast<double>(has_pixel.size() - right) + static_cast<double>(line.size() - right);
}

Errors errors_of(const LineRung& rung, const std::vector<Segment>& segments) {
  const LineFaults faults = line_faults(rung.line, segments);
  double wrong = 0;
  for (const Segment& segment : segments)
    wrong += wrong_pixels(rung.line(segment.p0, segment.p1), segment);
  const auto per_segment = [&](std::int64_t count) {
    return static_cast<double>(count) / static_cast<double>(segments.size());
  };
  return {{"wrong per million", 1e6 * wrong / pixels_of(segments)},
          {"largest distance", faults.distance},
          {"gaps a line", per_segment(faults.gaps)},
          {"ends missing", per_segment(faults.missing_ends)},
          {"doubled", per_segment(faults.doubled)},
          {"changed by swap", per_segment(faults.changed_by_swap)}};
}

/// Every rung of exercise 01.5: its pixels as a sequence, nothing drawn.
TimedLadder segment_ladder(const std::string& input, const std::vector<Segment>& segments) {
  TimedLadder ladder{.name = "01.5 segments, " + input,
                     .stage = "01",
                     .unit = "pixel",
                     .units = pixels_of(segments),
                     .error = "wrong per million",
                     .rungs = {}};
  for (const LineRung& rung : line_ladder) {
    const auto work = [segments, line = rung.line] {
      std::size_t pixels = 0;
      for (const auto& [p0, p1] : segments) pixels += line(p0, p1).size();
      return pixels;
    };
    ladder.rungs.push_back({.name = rung.name,
                            .fault = rung.known_fault,
                            .work = work,
                            .errors = errors_of(rung, segments)});
  }
  return ladder;
}

enum class Direction { flat, steep, any };

/// Segments of `length` pixels anywhere inside the image.
std::vector<Segment> segments_inside(std::size_t count, int length, Direction direction,
                                     const Image<Rgb8>& image) {
  std::mt19937 random(1);
  std::vector<Segment> segments;
  while (segments.size() < count) {
    const double angle = random_number(random, 0, 2 * std::numbers::pi);
    Eigen::Vector2d way(std::cos(angle), std::sin(angle));
    const bool steep = std::abs(way.y()) > std::abs(way.x());
    if (direction != Direction::any && steep != (direction == Direction::steep)) continue;
    way *= (length - 1) / way.cwiseAbs().maxCoeff();
    const Point p0(static_cast<int>(random_number(random, 0, image.width())),
                   static_cast<int>(random_number(random, 0, image.height())));
    const Point p1 = p0 + way.array().round().matrix().cast<int>();
    if (image.contains(p1.x(), p1.y())) segments.push_back({p0, p1});
  }
  return segments;
}

/// A way as plots and wireframes have them: each segment begins where the last one ended, and turns
/// at the borders of the image.
std::vector<Segment> polyline(std::size_t count, int length, const Image<Rgb8>& image) {
  std::mt19937 random(1);
  std::vector<Segment> segments;
  Point from(0, 0);
  // Too near to the middle no segment has room.
  const auto leads_on = [&](const Point& p) {
    return image.contains(p.x() + length - 1, 0) || image.contains(p.x() - length + 1, 0) ||
           image.contains(0, p.y() + length - 1) || image.contains(0, p.y() - length + 1);
  };
  while (segments.size() < count) {
    const double angle = random_number(random, 0, 2 * std::numbers::pi);
    Eigen::Vector2d way(std::cos(angle), std::sin(angle));
    way *= (length - 1) / way.cwiseAbs().maxCoeff();
    Point step = way.array().round().matrix().cast<int>();
    if (!image.contains(from.x() + step.x(), 0)) step.x() = -step.x();
    if (!image.contains(0, from.y() + step.y())) step.y() = -step.y();
    const Point to = from + step;
    if (!image.contains(to.x(), to.y()) || !leads_on(to)) continue;
    segments.push_back({from, to});
    from = to;
  }
  return segments;
}

/// Pixels that differ from those of the last rung, per million of those.
double difference(const Image<Rgb8>& drawn, const std::vector<Segment>& segments) {
  Image<Rgb8> exact(drawn.width(), drawn.height());
  for (const auto& [p0, p1] : segments) draw_pixels(exact, line_bresenham(p0, p1), color);
  double covered = 0;
  double different = 0;
  for (std::size_t i = 0; i < exact.pixels().size(); ++i) {
    covered += exact.pixels()[i] == color ? 1 : 0;
    different += exact.pixels()[i] == drawn.pixels()[i] ? 0 : 1;
  }
  return 1e6 * different / covered;
}

Errors judged(Image<Rgb8>& image, const std::vector<Segment>& segments,
              const std::function<void()>& draw) {
  image.clear({});
  draw();
  return {{"different pixels per million", difference(image, segments)}};
}

TimedRung peer_rung(Image<Rgb8>& image, const std::vector<Segment>& segments) {
  const std::function<void()> peer = opencv_lines(image, segments, color);
  return {.name = "cv::line",
          .fault = "breaks ties its own way",
          .work = peer,
          .errors = judged(image, segments, peer),
          .role = Role::peer};
}

TimedRung one_by_one_rung(const std::shared_ptr<Image<Rgb8>>& image,
                          const std::vector<Segment>& segments) {
  const auto draw = [image, segments] {
    for (const auto& [p0, p1] : segments) draw_line_runs(*image, p0, p1, color);
  };
  return {.name = "draw_line_runs",
          .fault = "none",
          .work = draw,
          .errors = judged(*image, segments, draw)};
}

/// What the memory alone takes that the segments touch.
TimedRung limit_rung(Image<Rgb8>& image, const std::vector<Segment>& segments) {
  MemoryLimit limit(image);
  for (const auto& [p0, p1] : segments) {
    for (const Point& pixel : line_bresenham(p0, p1))
      limit.add(std::ptrdiff_t{pixel.y()} * image.width() + pixel.x(), 1);
  }
  return {.name = "one byte a cache line",
          .fault = "draws nothing: what the memory takes",
          .work = limit,
          .errors = {},
          .role = Role::limit};
}

/// The quick lines and OpenCV's into one picture, one call a line, and what the picture's memory
/// alone takes. Many lines, lest the processor learn the way of each by heart, but not so many that
/// the list of what they touch would crowd the picture out of the caches.
TimedLadder race_of_calls(int length, Direction direction) {
  const auto image = std::make_shared<Image<Rgb8>>(1920, 1080);
  const std::vector<Segment> segments = segments_inside(
      static_cast<std::size_t>(std::clamp(400000 / length, 400, 4096)), length, direction, *image);
  const char* const directions[] = {"flat", "steep", "any"};
  return {.name = "lines of " + std::to_string(length) + " pixels, " +
                  directions[static_cast<int>(direction)] + " direction",
          .stage = "01",
          .unit = "line",
          .units = static_cast<double>(segments.size()),
          .error = "different pixels per million",
          .rungs = {limit_rung(*image, segments), peer_rung(*image, segments),
                    one_by_one_rung(image, segments)}};
}

/// Every way to draw a list.
std::vector<TimedRung> list_rungs(const std::shared_ptr<Image<Rgb8>>& image,
                                  const std::vector<Segment>& segments) {
  std::vector<TimedRung> rungs;
  for (const LineListWay& way : line_list_ways()) {
    const auto draw = [image, segments, draw_list = way.draw] {
      draw_list(*image, segments, color);
    };
    rungs.push_back({.name = std::string("draw_line_list, ") + way.name,
                     .fault = "none",
                     .work = draw,
                     .errors = judged(*image, segments, draw)});
  }
  return rungs;
}

/// Of segments that lists take by one call: `others`, and every way to draw a list.
TimedLadder race_of_lists(const std::string& name, const std::shared_ptr<Image<Rgb8>>& image,
                          const std::vector<Segment>& segments,
                          const std::vector<TimedRung>& others) {
  TimedLadder ladder{.name = name,
                     .stage = "01",
                     .unit = "line",
                     .units = static_cast<double>(segments.size()),
                     .error = "different pixels per million",
                     .rungs = others};
  const std::vector<TimedRung> lists = list_rungs(image, segments);
  ladder.rungs.insert(ladder.rungs.end(), lists.begin(), lists.end());
  return ladder;
}

/// How many segments have ten million pixels.
std::size_t count_of_long_list(int length) {
  return static_cast<std::size_t>(10'000'000 / length);
}

TimedLadder race_anywhere(int length) {
  const auto image = std::make_shared<Image<Rgb8>>(1920, 1080);
  const std::size_t count = count_of_long_list(length);
  const std::vector<Segment> segments = segments_inside(count, length, Direction::any, *image);
  return race_of_lists("list of " + std::to_string(count) + " lines of " + std::to_string(length) +
                           " pixels, any direction",
                       image, segments, {peer_rung(*image, segments)});
}

/// Segments that follow each other, so that most of what one touches is in the nearest cache.
TimedLadder race_along_a_polyline(int length) {
  const auto image = std::make_shared<Image<Rgb8>>(1920, 1080);
  const std::size_t count = count_of_long_list(length);
  const std::vector<Segment> segments = polyline(count, length, *image);
  // By a part over and over: a list of all that is touched would crowd the picture out of the
  // caches.
  constexpr int parts = 25;
  TimedRung limit =
      limit_rung(*image, {segments.begin(), segments.begin() + std::ssize(segments) / parts});
  limit.work = [once = limit.work] {
    for (int i = 0; i < parts; ++i) once();
  };
  return race_of_lists(
      "polyline of " + std::to_string(count) + " lines of " + std::to_string(length) + " pixels",
      image, segments, {limit, peer_rung(*image, segments), one_by_one_rung(image, segments)});
}

std::vector<MakeLadder> ladders() {
  std::vector<MakeLadder> all = {
      [] { return segment_ladder("all 1681 within 20 pixels", short_segments()); },
      [] { return segment_ladder("1000 within 500 pixels", random_segments(1000, 500)); },
      [] { return segment_ladder("20 within 50000 pixels", random_segments(20, 50000)); }};
  for (const int length : {10, 100, 1000})
    all.emplace_back([length] { return race_anywhere(length); });
  for (const int length : {10, 100, 1000})
    all.emplace_back([length] { return race_along_a_polyline(length); });
  for (const Direction direction : {Direction::any, Direction::flat, Direction::steep}) {
    for (const int length : {10, 100, 1000})
      all.emplace_back([length, direction] { return race_of_calls(length, direction); });
  }
  return all;
}

}  // namespace
}  // namespace rasterlab::bench

int main(int argc, char** argv) {
  using namespace rasterlab::bench;
  return run_program(
      argc, argv,
      {.name = "bench_01_lines",
       .description = "Stage 01: time and error of every way to draw a segment; quick lines "
                      "against OpenCV's",
       .ladders = ladders()});
}
