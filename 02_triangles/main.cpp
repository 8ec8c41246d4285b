// Stage 02: from three lines to the faces of a mesh. The order is that of the lab sheet, README.md.
#include "common/image/operations.h"
#include "common/mesh/read_mesh.h"
#include "common/stage/ladder.h"
#include "common/stage/stage.h"
#include "common/triangles/draw_flat_faces.h"
#include "common/triangles/draw_random_faces.h"
#include "common/triangles/draw_triangle_wireframe.h"
#include "common/triangles/fill_faults.h"
#include "common/triangles/fill_ladder.h"
#include "common/triangles/fill_scanline.h"
#include "common/triangles/fill_triangle_gradient.h"
#include "common/triangles/interpolate_attributes.h"
#include "common/triangles/rasterize.h"
#include "common/triangles/triangle_scanline.h"

#include "02_triangles/own_triangles.h"

#include <cmath>
#include <sstream>

namespace rasterlab {
namespace {

constexpr Rgb8 red{255, 0, 0};
constexpr Rgb8 green{0, 255, 0};
constexpr Rgb8 white{255, 255, 255};
constexpr Rgb8 grey{64, 64, 64};

/// The three triangles of course B, in 200 × 200.
struct ColoredTriangle {
  std::array<Point, 3> corners;
  Rgb8 color;
};
const ColoredTriangle three_triangles[] = {{{{{10, 70}, {50, 160}, {70, 80}}}, red},
                                           {{{{180, 50}, {150, 1}, {70, 180}}}, white},
                                           {{{{180, 150}, {120, 160}, {130, 180}}}, green}};

/// The small triangle of course A.
const std::array<Point, 3> small_triangle = {{{15, 12}, {2, 17}, {6, 3}}};

Corners to_corners(const std::array<Point, 3>& pixels) {
  return {pixels[0].cast<double>(), pixels[1].cast<double>(), pixels[2].cast<double>()};
}

// 02.1
void wireframe(Run& run) {
  Image<Rgb8> image(200, 200);
  for (const auto& [corners, color] : three_triangles)
    draw_triangle_wireframe(image, corners, color);
  run.picture("02.1_three_wireframes", image);
}

// 02.2: rows down with numbers, with colours, and up again.
void scanline(Run& run) {
  const auto numbers = make_triangle_scanline<float>(small_triangle, {0, 1, 2});
  const auto colors = make_triangle_scanline<Color>(
      small_triangle, {Color(1, 0, 0), Color(0, 1, 0), Color(0, 0, 1)});
  std::ostringstream text;
  text << numbers << "\n" << colors << "\nfrom below:";
  for (auto row = numbers.rbegin(); row != numbers.rend(); ++row) text << " " << row->y;
  text << "\n";
  run.printout("02.2_scanline", text.str());
}

// 02.3
void fill(Run& run) {
  Image<Rgb8> plain(20, 20);
  fill_triangle(plain, small_triangle, white);
  run.picture("02.3_one_color", enlarged(plain, 10));
  Image<Rgb8> gradient(200, 200);
  fill_triangle_gradient(gradient, {{{190, 120}, {10, 180}, {60, 10}}},
                         {Color(1, 0, 0), Color(0, 1, 0), Color(0, 0, 1)});
  run.picture("02.3_three_colors", gradient);
}

// 02.4: the same three triangles with every rung.
void ladder(Run& run) {
  std::vector<Image<Rgb8>> pictures;
  for (const FillRung& rung : fill_ladder) {
    if (!run.draws(rung.name)) continue;
    Image<Rgb8> image(200, 200);
    for (const auto& [corners, color] : three_triangles)
      rung.fill(image, to_corners(corners), color);
    run.picture(std::string("02.4_") + rung.name, image);
    pictures.push_back(image);
  }
  if (run.settings().algorithm.empty()) {
    run.picture("02.4_side_by_side", side_by_side(pictures, 3, 4, grey));
  }
}

// 02.5: five attributes at each corner: a colour, and where in a pattern it is.
void attributes(Run& run) {
  Eigen::MatrixX3d at_corners(5, 3);
  at_corners << 1.0, 0.2, 0.2,  // red
      0.2, 1.0, 0.2,            // green
      0.2, 0.2, 1.0,            // blue
      0.0, 8.0, 0.0,            // u
      0.0, 0.0, 8.0;            // v
  const Size size = run.size({200, 200});
  const auto point = [&](float x, float y) {
    return Eigen::Vector2f(x * static_cast<float>(size.width), y * static_cast<float>(size.height));
  };
  Image<Rgb8> image(size.width, size.height);
  rasterize_triangle(
      {point(0.95F, 0.6F), point(0.05F, 0.9F), point(0.3F, 0.05F)}, size.width, size.height,
      [&](int x, int y, const Eigen::Vector3d& weights) {
        const Eigen::VectorXd here = interpolate_attributes(at_corners, weights);
        const bool dark =
            (std::lround(std::floor(here[3])) + std::lround(std::floor(here[4]))) % 2 != 0;
        image(x, y) = to_rgb8(here.head<3>().cast<float>() * (dark ? 0.4F : 1.0F));
      });
  run.picture("02.5_attributes", image);
}

// 02.6: how well each rung does what was hoped for, and where it does not.
void faults(Run& run) {
  const TriangleSample grid = fill_samples()[2];
  const Coverage exact = exact_coverage(grid);
  std::vector<Image<Rgb8>> pictures;
  for (const FillRung& rung : fill_ladder) {
    pictures.push_back(
        fault_picture(coverage(rung.fill, grid.triangles, grid.size, grid.size), exact));
  }
  run.picture("02.6_faults", side_by_side(pictures, 3, 4, grey));
  run.printout("02.6_faults", fill_fault_table());
}

// 02.7
void faces(Run& run) {
  const Mesh bunny = read_mesh(bunny_path());
  const Size size = run.size({800, 800});
  Image<Rgb8> random(size.width, size.height);
  draw_random_faces(random, bunny, 1);
  run.picture("02.7_random", random);
  Image<Rgb8> flat(size.width, size.height);
  draw_flat_faces(flat, bunny);
  run.picture("02.7_flat", flat);
}

}  // namespace
}  // namespace rasterlab

int main(int argc, char** argv) {
  using namespace rasterlab;
  return run_stage(argc, argv,
                   {.name = "02_triangles",
                    .exercises = {{"02.1", &wireframe},
                                  {"02.2", &scanline},
                                  {"02.3", &fill},
                                  {"02.4", &ladder},
                                  {"02.5", &attributes},
                                  {"02.6", &faults},
                                  {"02.7", &faces}},
                    .ladders = {ladder_of("02.4", fill_ladder)},
                    .own_inputs = {own_triangles()}});
}
