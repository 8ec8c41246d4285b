// Exercise 02.2.
#include "common/triangles/triangle_scanline.h"

#include "grading/probes/probe.h"

#include <algorithm>

namespace rasterlab::grading {
namespace {

/// Left and right pixel of every row, and the values at them.
void add_rows(Results& results, const std::string& name, const TriangleScanline<float>& scanline) {
  std::vector<double> pixels;
  std::vector<double> values;
  for (const auto& row : scanline) {
    pixels.insert(pixels.end(), {double(row.y), double(row.left), double(row.right)});
    values.insert(values.end(), {double(row.left_value), double(row.right_value)});
  }
  results.numbers(name + ": row, left and right pixel", pixels);
  // Near a corner a pixel may be of two sides, and have the value of either.
  results.numbers(name + ": values at the left and right", values, 0.12);
}

}  // namespace

void scanline_scene(SceneInputs& scene, Results& results) {
  if (scene.example()) {
    const std::array<Point, 3> corners = {Point(15, 12), Point(2, 17), Point(6, 3)};
    add_rows(results, "(15,12)(2,17)(6,3)",
             make_triangle_scanline<float>(corners, {0.0F, 1.0F, 2.0F}));
    return;
  }
  for (int i = 0; i < 5; ++i) {
    const Point top = scene.pixel(40, 5);
    std::array<Point, 3> corners = {top, top + Point(scene.whole(25, 45), scene.whole(18, 30)),
                                    top + Point(-scene.whole(5, 30), scene.whole(35, 50))};
    std::array<float, 3> values = {0, 1, 2};
    for (int turns = scene.whole(0, 2); turns > 0; --turns) {
      std::rotate(corners.begin(), corners.begin() + 1, corners.end());
      std::rotate(values.begin(), values.begin() + 1, values.end());
    }
    const std::string name = "triangle " + std::to_string(i + 1);
    add_rows(results, name, make_triangle_scanline<float>(corners, values));
    add_rows(results, name + " within rows 10 to 20",
             make_triangle_scanline<float>(corners, values, {10, 20}));
  }
}

}  // namespace rasterlab::grading
