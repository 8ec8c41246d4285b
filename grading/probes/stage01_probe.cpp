// Runs the exercises of stage 01 on made-up segments: every octant, both ends first, points, long
// and short.
#include "common/lines/bresenham.h"
#include "common/lines/bresenham_first_octant.h"
#include "common/lines/draw_line.h"
#include "common/lines/draw_line_gradient.h"
#include "common/lines/draw_wireframe.h"
#include "common/lines/fading_column.h"
#include "common/lines/line_all_octants.h"
#include "common/lines/line_discrete.h"
#include "common/lines/line_interpolation.h"
#include "common/lines/octants.h"
#include "common/lines/red_pixel.h"
#include "common/mesh/shapes.h"

#include "grading/probes/probe.h"

#include <sstream>

namespace rasterlab::grading {
namespace {

struct Segment {
  Point from;
  Point to;
};

/// Segments in all eight octants, then one point, one level, one upright, one diagonal.
std::vector<Segment> segments(SceneInputs& scene, int size) {
  std::vector<Segment> made;
  for (int octant = 0; octant < 8; ++octant) {
    const int along = scene.whole(2, size / 2);
    const int across = scene.whole(0, along - 1);
    Point way = octant % 2 == 0 ? Point(along, across) : Point(across, along);
    if ((octant & 2) != 0) way.x() = -way.x();
    if ((octant & 4) != 0) way.y() = -way.y();
    const Point from = scene.pixel(size, size);
    made.push_back({from, from + way});
  }
  const Point point = scene.pixel(size, size);
  const int length = scene.whole(1, size / 2);
  made.push_back({point, point});
  made.push_back({point, point + Point(length, 0)});
  made.push_back({point, point + Point(0, -length)});
  made.push_back({point, point + Point(-length, -length)});
  return made;
}

std::string name_of(const Segment& segment) {
  std::ostringstream text;
  text << "segment (" << segment.from.x() << ", " << segment.from.y() << ")–(" << segment.to.x()
       << ", " << segment.to.y() << ")";
  return text.str();
}

void add_line(Results& results, const Segment& segment, const LineDiscrete& line,
              bool either_direction = false) {
  results.segment(name_of(segment), {line.begin(), line.end()}, segment.from, segment.to,
                  either_direction);
}

std::vector<double> as_numbers(const LineDiscrete& line) {
  std::vector<double> numbers;
  for (const Point& pixel : line)
    numbers.insert(numbers.end(), {double(pixel.x()), double(pixel.y())});
  return numbers;
}

void red_pixel_scene(SceneInputs& scene, Results& results) {
  const int width = scene.example() ? 100 : scene.whole(5, 60);
  const int height = scene.example() ? 100 : scene.whole(5, 60);
  const int x = scene.example() ? 52 : scene.whole(0, width - 1);
  const int y_up = scene.example() ? 41 : scene.whole(0, height - 1);
  results.picture("the red pixel", red_pixel(width, height, x, y_up));
}

void fading_column_scene(SceneInputs& scene, Results& results) {
  Image<Rgb8> image(scene.whole(3, 30), scene.whole(20, 200), Rgb8{10, 20, 90});
  draw_fading_column(image, scene.whole(0, image.width() - 1));
  results.picture("the fading column", image, 1);
}

void line_discrete_scene(SceneInputs& scene, Results& results) {
  LineDiscrete line;
  for (int i = 0; i < 20; ++i) line.append(scene.pixel(100, 100) - Point(50, 50));
  results.numbers("the pixels in order", as_numbers(line));
  std::vector<double> backwards;
  for (auto pixel = line.rbegin(); pixel != line.rend(); ++pixel)
    backwards.insert(backwards.end(), {double(pixel->x()), double(pixel->y())});
  results.numbers("the pixels backwards", backwards);
  results.numbers("the first and the last by index",
                  {double(line[0].x()), double(line[line.size() - 1].y())});
  std::ostringstream text;
  text << line;
  results.text("the line printed", text.str());
}

void bresenham_scene(SceneInputs& scene, Results& results) {
  std::vector<Segment> made = segments(scene, 60);
  if (scene.example()) made = {{{13, 20}, {80, 40}}, {{20, 13}, {40, 80}}, {{0, 0}, {10, 10}}};
  for (const Segment& segment : made)
    add_line(results, segment, line_bresenham(segment.from, segment.to), true);
}

void first_octant_scene(SceneInputs& scene, Results& results) {
  if (scene.example()) {
    const Segment segment{{5, 5}, {12, 9}};
    add_line(results, segment, bresenham_first_octant(segment.from, segment.to));
    return;
  }
  for (int i = 0; i < 10; ++i) {
    const Point from = scene.pixel(60, 60) - Point(20, 20);
    const int columns = i == 0 ? 0 : scene.whole(1, 50);
    const Segment segment{from, from + Point(columns, scene.whole(0, columns))};
    add_line(results, segment, bresenham_first_octant(segment.from, segment.to));
  }
}

void draw_line_scene(SceneInputs& scene, Results& results) {
  Image<Rgb8> image(48, 40);
  if (scene.example()) {
    draw_line(image, {5, 5}, {12, 9}, {255, 255, 255});
  } else {
    for (const Segment& segment : segments(scene, 48))
      draw_line(image, segment.from, segment.to, to_rgb8(scene.color()));
  }
  results.picture("the lines", image);
}

void octants_scene(SceneInputs& scene, Results& results) {
  const std::vector<Segment> made = segments(scene, 40);
  std::vector<double> symmetric;
  std::vector<double> there_and_back;
  for (int octant = 1; octant <= 8; ++octant) {
    const Point point = scene.pixel(40, 40) - Point(20, 20);
    const Point turned = symmetry_octant(point, octant);
    symmetric.insert(symmetric.end(), {double(turned.x()), double(turned.y())});
    const Point back = symmetry_octant_inverse(turned, octant);
    there_and_back.insert(there_and_back.end(), {double(back.x()), double(back.y())});
  }
  results.numbers("a point turned into the first octant from each", symmetric);
  results.numbers("and turned back", there_and_back);
  // On a border either octant will do, so only segments inside one are asked about.
  std::vector<double> numbers;
  for (int i = 0; i < 8; ++i) {
    Point way(scene.whole(11, 20), scene.whole(1, 10));
    if ((i & 1) != 0) way = {way.y(), way.x()};
    if ((i & 2) != 0) way.x() = -way.x();
    if ((i & 4) != 0) way.y() = -way.y();
    numbers.push_back(octant_number(made[0].from, made[0].from + way));
  }
  results.numbers("the octants' numbers", numbers);
}

void all_octants_scene(SceneInputs& scene, Results& results) {
  for (const Segment& segment : segments(scene, 60))
    add_line(results, segment, line_all_octants(segment.from, segment.to));
}

void octants_and_lines_scene(SceneInputs& scene, Results& results) {
  octants_scene(scene, results);
  all_octants_scene(scene, results);
}

void interpolation_scene(SceneInputs& scene, Results& results) {
  std::vector<Segment> made = segments(scene, 40);
  if (scene.example()) made = {{{5, 5}, {12, 9}}, {{3, 3}, {3, 3}}};
  for (const Segment& segment : made) {
    const LineDiscrete line = line_all_octants(segment.from, segment.to);
    const LineInterpolation weights(line);
    std::vector<double> numbers;
    for (std::size_t i = 0; i < weights.size(); ++i) numbers.push_back(weights[i]);
    results.numbers("the weights of " + name_of(segment), numbers, 1e-9);
  }
  const LineInterpolation quarters(LineDiscrete{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}});
  std::ostringstream text;
  text << quarters;
  results.text("the weights printed", text.str());
}

void gradient_scene(SceneInputs& scene, Results& results) {
  Image<Rgb8> image(48, 40);
  if (scene.example()) {
    draw_line_gradient(image, {5, 5}, {1, 0, 0}, {40, 30}, {0, 0, 1});
  } else {
    for (const Segment& segment : segments(scene, 48)) {
      const Color from = scene.color();
      draw_line_gradient(image, segment.from, from, segment.to, scene.color());
    }
  }
  results.picture("the lines", image, 1);
}

void wireframe_scene(SceneInputs& scene, Results& results) {
  Image<Rgb8> image(scene.whole(60, 120), scene.whole(60, 120));
  Mesh mesh = make_shape(scene.example() ? "icosphere:1" : "torus:6");
  for (Eigen::Vector3f& position : mesh.positions)
    position *= scene.example() ? 1.0F : scene.real(0.9F, 1.1F);
  draw_wireframe(image, mesh, {255, 255, 255});
  results.picture("the wireframe", image);
}

}  // namespace
}  // namespace rasterlab::grading

int main(int argc, char** argv) {
  using namespace rasterlab::grading;
  return run_probe(argc, argv,
                   {{"01.2", red_pixel_scene},
                    {"01.3", fading_column_scene},
                    {"01.4", line_discrete_scene},
                    {"01.5", bresenham_scene},
                    {"01.6", first_octant_scene},
                    {"01.7", draw_line_scene},
                    {"01.8", octants_and_lines_scene},
                    {"01.9", interpolation_scene},
                    {"01.10", gradient_scene},
                    {"01.11", wireframe_scene}});
}
