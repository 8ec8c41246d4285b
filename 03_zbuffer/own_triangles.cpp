#include "03_zbuffer/own_triangles.h"

#include "common/lines/number_rows.h"
#include "common/triangles/edge_function.h"
#include "common/triangles/pixel_box.h"
#include "common/zbuffer/draw_depth_triangle.h"

#include <algorithm>
#include <map>
#include <memory>
#include <string>

namespace rasterlab {
namespace {

const RowFormat depth_triangle_format{
    .description = "x0 y0 z0 x1 y1 z1 x2 y2 z2 [r g b | r g b r g b r g b]", .counts = {9, 12, 18}};

std::array<DepthCorner, 3> corners_at(const NumberRow& row) {
  std::array<DepthCorner, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t own_color = row.numbers.size() == 18 ? 9 + 3 * i : 9;
    corners[i] = {.position = {row.numbers[3 * i], row.numbers[3 * i + 1]},
                  .z = static_cast<float>(row.numbers[3 * i + 2]),
                  .color = row.numbers.size() == 9 ? Color(1, 1, 1) : color_at(row, own_color)};
    if (corners[i].position.cwiseAbs().maxCoeff() > max_wide_coordinate) {
      row.fail("expected x and y within ±1073741824 (2^30)");
    }
  }
  return corners;
}

/// Why not a pixel of a triangle can be seen; empty when one may be.
std::string reason_for_nothing(const std::array<DepthCorner, 3>& corners, Size size) {
  const Corners window = {corners[0].position, corners[1].position, corners[2].position};
  const PixelBox box = pixel_box(window, size.width, size.height);
  if (box.right < box.left || box.bottom < box.top) return "outside";
  const auto [nearest, farthest] = std::minmax({corners[0].z, corners[1].z, corners[2].z});
  if (nearest > 1 || farthest < -1) return "outside_depth";
  const SnappedTriangle snapped = snap(window, max_wide_coordinate);
  return cross<Int128>(snapped[0], snapped[1], snapped[2]) == 0 ? "no_area" : "";
}

void draw_file(const std::filesystem::path& file, Run& run) {
  if (!run.settings().algorithm.empty()) {
    throw UsageError(
        "--algorithm: the rungs of 03.5 draw their own scenes; expected --triangles without it");
  }
  const Size size = run.size({640, 480});
  Image<Rgb8> image(size.width, size.height);
  DepthBuffer depth(size.width, size.height);
  std::int64_t triangles = 0;
  std::map<std::string, std::int64_t> skipped = {
      {"no_area", 0}, {"outside", 0}, {"outside_depth", 0}};
  for_each_row(file, depth_triangle_format, [&](const NumberRow& row) {
    const std::array<DepthCorner, 3> corners = corners_at(row);
    ++triangles;
    if (const std::string reason = reason_for_nothing(corners, size); !reason.empty()) {
      ++skipped[reason];
    } else {
      draw_depth_triangle(image, depth, corners);
    }
  });
  const std::vector<float>& depths = depth.depths().pixels();
  run.statistics()["triangles"] = triangles;
  run.statistics()["skipped"] = skipped;
  run.statistics()["pixels_seen"] =
      std::count_if(depths.begin(), depths.end(), [](float z) { return z < 1; });
  run.picture("triangles", image);
}

}  // namespace

OwnInput own_triangles() {
  struct Flag {
    std::filesystem::path file;
    const CLI::Option* option = nullptr;
  };
  auto flag = std::make_shared<Flag>();
  return {.add_flags =
              [flag](CLI::App& app) {
                flag->option =
                    app.add_option(
                           "--triangles", flag->file,
                           "Draw the triangles of a file instead, one a line, '#' comments: " +
                               depth_triangle_format.description +
                               ", x and y in pixels, z from -1 near to 1 far, colours 0 to 255 "
                               "(default white; three blend)")
                        ->type_name("FILE");
              },
          .given = [flag] { return flag->option->count() > 0; },
          .run = [flag](Run& run) { draw_file(flag->file, run); }};
}

}  // namespace rasterlab
