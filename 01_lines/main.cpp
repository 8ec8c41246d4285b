// Stage 01: from a single pixel to the wireframe of a mesh. The order is that of the lab sheet,
// README.md.
#include "common/image/check.h"
#include "common/image/files.h"
#include "common/image/operations.h"
#include "common/lines/bresenham_first_octant.h"
#include "common/lines/draw_line.h"
#include "common/lines/draw_line_gradient.h"
#include "common/lines/draw_pixels.h"
#include "common/lines/draw_wireframe.h"
#include "common/lines/fading_column.h"
#include "common/lines/line_all_octants.h"
#include "common/lines/line_discrete.h"
#include "common/lines/line_faults.h"
#include "common/lines/line_interpolation.h"
#include "common/lines/line_ladder.h"
#include "common/lines/octants.h"
#include "common/lines/red_pixel.h"
#include "common/mesh/read_mesh.h"
#include "common/stage/ladder.h"
#include "common/stage/stage.h"

#include "01_lines/own_lines.h"

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include <CLI/CLI.hpp>

namespace rasterlab {
namespace {

constexpr Rgb8 black{0, 0, 0};
constexpr Rgb8 white{255, 255, 255};
constexpr Rgb8 red{255, 0, 0};

// 01.1: reading a pixel that is not there.
void image_container(Run& run) {
  Image<Rgb8> image(90, 10);
  try {
    image(91, 10) = red;
  } catch (const CheckError& error) {
    run.printout("01.1_outside", std::string(error.what()) + "\n");
    run.file("backtrace_log.txt", [error](const std::filesystem::path& path) {
      std::ofstream(path) << error.what() << "\n" << error.call_stack();
    });
  }
}

// 01.2: one pixel, origin at the bottom, in two formats.
void red_pixel_in_files(Run& run) {
  const Image<Rgb8> image = red_pixel(100, 100, 52, 41);
  run.picture("01.2_red_pixel", image);
  run.file("01.2_red_pixel.tga", [image](const auto& path) { write_image(path, image); });
}

// 01.3
void fading_column(Run& run) {
  const Size size = run.size({100, 100});
  Image<Rgb8> image(size.width, size.height, Rgb8{0, 0, 80});
  draw_fading_column(image, size.width / 2);
  run.picture("01.3_fading_column", image);
}

// 01.4: a sequence, there and back.
void line_discrete(Run& run) {
  LineDiscrete line;
  for (int x = 0; x < 5; ++x) line.append({x, x / 2});
  LineDiscrete back;
  for (auto pixel = line.rbegin(); pixel != line.rend(); ++pixel) back.append(*pixel);
  std::ostringstream text;
  text << line << "\n" << back << "\n";
  run.printout("01.4_line_discrete", text.str());
}

// 01.5: the same two segments with every rung.
void segment_ladder(Run& run) {
  std::vector<Image<Rgb8>> pictures;
  for (const LineRung& rung : line_ladder) {
    if (!run.draws(rung.name)) continue;
    Image<Rgb8> image(100, 100);
    for (const auto& [segment, color] :
         {std::pair{Segment{{13, 20}, {80, 40}}, white}, {{{20, 13}, {40, 80}}, red}}) {
      draw_pixels(image, rung.line(segment.p0, segment.p1), color);
    }
    run.picture(std::string("01.5_") + rung.name, image);
    pictures.push_back(enlarged(image, 2));
  }
  if (!run.settings().algorithm.empty()) return;
  run.picture("01.5_side_by_side", side_by_side(pictures, 4, 4, Rgb8{64, 64, 64}));
  run.printout("01.5_faults", line_fault_table());
}

// 01.6
void first_octant(Run& run) {
  std::ostringstream text;
  text << bresenham_first_octant({5, 5}, {12, 9}) << "\n";
  run.printout("01.6_first_octant", text.str());
}

/// The end of a ray from `center` in direction `i` of `count`.
Point ray_end(const Point& center, int i, int count, double length) {
  const double angle = 2 * std::numbers::pi * i / count;
  return center + Point(static_cast<int>(std::lround(length * std::cos(angle))),
                        static_cast<int>(std::lround(length * std::sin(angle))));
}

// 01.7: inside, partly outside, and a single pixel.
void line_of_one_color(Run& run) {
  Image<Rgb8> image(100, 100);
  draw_line(image, {10, 20}, {90, 50}, white);
  draw_line(image, {-50, 60}, {150, 90}, red);
  draw_line(image, {-1000000000, 0}, {1000000000, 99}, Rgb8{0, 255, 0});
  draw_line(image, {50, 10}, {50, 10}, white);
  run.picture("01.7_lines", image);
}

// 01.8: a ray in every direction, each octant in its own colour.
void all_octants(Run& run) {
  const Rgb8 colors[] = {{255, 0, 0},   {255, 160, 0}, {255, 255, 0},  {0, 255, 0},
                         {0, 255, 255}, {0, 96, 255},  {160, 64, 255}, {255, 0, 255}};
  Image<Rgb8> image(201, 201);
  const Point center(100, 100);
  for (int i = 0; i < 48; ++i) {
    const Point end = ray_end(center, i, 48, 95);
    draw_pixels(image, line_all_octants(center, end), colors[octant_number(center, end) - 1]);
  }
  run.picture("01.8_octants", image);
}

// 01.9
void line_interpolation(Run& run) {
  const LineDiscrete line = bresenham_first_octant({5, 5}, {12, 9});
  std::ostringstream text;
  text << line << "\n" << LineInterpolation(line) << "\n";
  run.printout("01.9_line_interpolation", text.str());
}

// 01.10: from white in the middle to the colours of the rainbow.
void line_of_two_colors(Run& run) {
  Image<Rgb8> image(201, 201);
  for (int i = 0; i < 120; ++i) {
    const auto third = [i](int shift) {
      return 0.5F + 0.5F * std::cos(2 * std::numbers::pi_v<float> *
                                    (static_cast<float>(i + shift) / 120.0F));
    };
    draw_line_gradient(image, {100, 100}, Color(1, 1, 1), ray_end({100, 100}, i, 120, 95),
                       Color(third(0), third(80), third(40)));
  }
  run.picture("01.10_rainbow", image);
}

// 01.11
void wireframe(Run& run) {
  const Size size = run.size({800, 800});
  Image<Rgb8> image(size.width, size.height, black);
  draw_wireframe(image, read_mesh(bunny_path()), white);
  run.picture("01.11_bunny", image);
}

// 01_lines convert IN OUT: between any two picture formats.
void add_convert(CLI::App& app) {
  CLI::App* convert =
      app.add_subcommand("convert", "Read a picture and write it in another format");
  auto paths = std::make_shared<std::pair<std::filesystem::path, std::filesystem::path>>();
  convert->add_option("IN", paths->first, "Picture to read")->required();
  convert->add_option("OUT", paths->second, "File to write; its extension chooses the format")
      ->required();
  convert->callback([paths] { write_image(paths->second, read_any_image(paths->first)); });
}

}  // namespace
}  // namespace rasterlab

int main(int argc, char** argv) {
  using namespace rasterlab;
  return run_stage(argc, argv,
                   {.name = "01_lines",
                    .exercises = {{"01.1", &image_container},
                                  {"01.2", &red_pixel_in_files},
                                  {"01.3", &fading_column},
                                  {"01.4", &line_discrete},
                                  {"01.5", &segment_ladder},
                                  {"01.6", &first_octant},
                                  {"01.7", &line_of_one_color},
                                  {"01.8", &all_octants},
                                  {"01.9", &line_interpolation},
                                  {"01.10", &line_of_two_colors},
                                  {"01.11", &wireframe}},
                    .ladders = {ladder_of("01.5", line_ladder)},
                    .own_inputs = {own_lines()},
                    .add_commands = &add_convert});
}
