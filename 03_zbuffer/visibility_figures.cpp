#include "common/image/convert.h"
#include "common/image/operations.h"
#include "common/zbuffer/draw_depth_line.h"
#include "common/zbuffer/visibility.h"
#include "common/zbuffer/visibility_faults.h"

#include "03_zbuffer/figures.h"
#include "03_zbuffer/inputs.h"

namespace rasterlab {
namespace {

constexpr int side = 200;      ///< of the scene seen from above
constexpr int row_height = 8;  ///< a one-row image, enlarged to be seen

/// The depth at which something at y is: 0 is near, the scene's far end is far.
float flat_depth(int y) {
  return 2 * static_cast<float>(y) / side - 1;
}

/// The outlines of the shapes as drawn on a sheet of paper, the eye below the lower edge looking
/// up: near is below.
Image<Rgb8> picture_from_above() {
  Image<Rgb8> image(side, side);
  for (const FlatShape& shape : scene_from_above()) {
    DepthBuffer depth(side, side);
    for (std::size_t i = 0; i < shape.corners.size(); ++i) {
      const auto end = [&](std::size_t corner) {
        const Point& p = shape.corners[corner % shape.corners.size()];
        return LineEnd{{p.x(), side - 1 - p.y()}, 0, shape.color};
      };
      draw_depth_line(image, depth, end(i), end(i + 1));
    }
  }
  return image;
}

/// What the eye sees of a shape in its one row of pixels: each side is a segment in that row.
void draw_in_row(Image<Rgb8>& row, DepthBuffer& depth, const FlatShape& shape) {
  for (std::size_t i = 0; i < shape.corners.size(); ++i) {
    const auto end = [&](std::size_t corner) {
      const Point& p = shape.corners[corner % shape.corners.size()];
      return LineEnd{{p.x(), 0}, flat_depth(p.y()), shape.color};
    };
    draw_depth_line(row, depth, end(i), end(i + 1));
  }
}

/// After each shape, the row and under it its depths, near white.
Image<Rgb8> picture_of_steps() {
  Image<Rgb8> row(side, 1);
  DepthBuffer depth(side, 1);
  const int step_height = 3 * row_height;
  Image<Rgb8> picture(side, step_height * static_cast<int>(scene_from_above().size()),
                      {40, 40, 40});
  int top = 0;
  for (const FlatShape& shape : scene_from_above()) {
    draw_in_row(row, depth, shape);
    paste(resized(row, side, row_height), 0, top, picture);
    const Image<Rgb8> depths = convert<Rgb8>(grey_picture(depth.depths(), 1.0F, -1.0F));
    paste(resized(depths, side, row_height), 0, top + row_height, picture);
    top += step_height;
  }
  return picture;
}

/// The triangles in turn in red, blue and green, or in fewer colours.
Image<Rgb8> picture_of(const VisibleTriangles& seen, std::int32_t color_count) {
  static const std::array<Rgb8, 3> colors = {{{235, 90, 60}, {70, 140, 240}, {90, 200, 90}}};
  Image<Rgb8> picture(seen.width(), seen.height());
  for (std::size_t i = 0; i < seen.pixels().size(); ++i) {
    const std::int32_t index = seen.pixels()[i];
    if (index >= 0) picture.pixels()[i] = colors[static_cast<std::size_t>(index % color_count)];
  }
  return picture;
}

}  // namespace

void draw_visibility_ladder(Run& run) {
  if (run.settings().algorithm.empty()) {
    run.picture("03.5_from_above", picture_from_above());
    run.picture("03.5_one_row", picture_of_steps());
    run.printout("03.5_faults", visibility_fault_table());
  }
  for (const VisibilityRung& rung : visibility_ladder) {
    if (!run.draws(rung.name)) continue;
    const Image<Rgb8> crossing = picture_of(rung.seen(interpenetrating_scene()), 3);
    const Image<Rgb8> pairs = picture_of(rung.seen(nearly_coplanar_pairs()), 2);
    Image<Rgb8> both(crossing.width() + 8 + pairs.width(), crossing.height());
    paste(crossing, 0, 0, both);
    paste(pairs, crossing.width() + 8, (crossing.height() - pairs.height()) / 2, both);
    run.picture(std::string("03.5_") + rung.name, both);
  }
}

}  // namespace rasterlab
