#include "03_zbuffer/own_triangles.h"

#include "common/lines/number_rows.h"
#include "common/triangles/edge_function.h"
#include "common/triangles/pixel_box.h"
#include "common/triangles/rasterize.h"
#include "common/zbuffer/draw_depth_triangle.h"
#include "common/zbuffer/visibility.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

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

/// What the exercises' depth buffer makes of triangles, as they come.
class DepthDrawing {
 public:
  explicit DepthDrawing(Size size)
      : image_(size.width, size.height), depth_(size.width, size.height) {}

  void draw(const NumberRow&, const std::array<DepthCorner, 3>& corners) {
    draw_depth_triangle(image_, depth_, corners);
  }

  const Image<Rgb8>& finish() const { return image_; }

  std::int64_t pixels_seen() const {
    const std::vector<float>& depths = depth_.depths().pixels();
    return std::count_if(depths.begin(), depths.end(), [](float z) { return z < 1; });
  }

 private:
  Image<Rgb8> image_;
  DepthBuffer depth_;
};

/// What a rung of exercise 03.5 makes of triangles, once it has them all. A rung knows distances
/// from the eye: z is taken as a camera's with the near and far plane of VisibilityScene.
class RungDrawing {
 public:
  RungDrawing(Size size, const VisibilityRung& rung) : rung_(rung) {
    scene_.width = size.width;
    scene_.height = size.height;
  }

  void draw(const NumberRow& row, const std::array<DepthCorner, 3>& corners) {
    VisibilityTriangle& triangle = scene_.triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      if (corners[i].position.cwiseAbs().maxCoeff() > max_coordinate)
        row.fail("expected x and y within ±32768 for --algorithm");
      if (std::abs(corners[i].z) > 1) row.fail("expected z from -1 to 1 for --algorithm");
      triangle.corners[i] = corners[i].position.cast<float>();
      triangle.distances[i] = distance(corners[i].z);
    }
    corners_.push_back(corners);
  }

  Image<Rgb8> finish() {
    const VisibleTriangles seen = rung_.seen(scene_);
    pixels_seen_ = std::count_if(seen.pixels().begin(), seen.pixels().end(),
                                 [](std::int32_t index) { return index >= 0; });
    Image<Rgb8> image(scene_.width, scene_.height);
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const auto& [a, b, c] = corners_[i];
      const Color colors[] = {a.color, b.color, c.color};
      rasterize_triangle(scene_.triangles[i].corners, scene_.width, scene_.height,
                         [&](int x, int y, const Eigen::Vector3d& weights) {
                           if (seen(x, y) != static_cast<std::int32_t>(i)) return;
                           const Eigen::Vector3f w = weights.cast<float>();
                           image(x, y) =
                               to_rgb8(w[0] * colors[0] + w[1] * colors[1] + w[2] * colors[2]);
                         });
    }
    return image;
  }

  std::int64_t pixels_seen() const { return pixels_seen_; }

 private:
  /// The distance of which NDC depth is far/(far − near) · (1 − near/distance), from −1 to 1.
  float distance(float z) const {
    const double near = scene_.near;
    const double far = scene_.far;
    const double depth = (z + 1.0) / 2;
    return static_cast<float>(near * far / (far - depth * (far - near)));
  }

  const VisibilityRung& rung_;
  VisibilityScene scene_;
  std::vector<std::array<DepthCorner, 3>> corners_;
  std::int64_t pixels_seen_ = 0;
};

template <class Drawing>
void draw_file(const std::filesystem::path& file, Run& run, Drawing drawing, Size size) {
  std::int64_t triangles = 0;
  std::map<std::string, std::int64_t> skipped = {
      {"no_area", 0}, {"outside", 0}, {"outside_depth", 0}};
  for_each_row(file, depth_triangle_format, [&](const NumberRow& row) {
    const std::array<DepthCorner, 3> corners = corners_at(row);
    ++triangles;
    if (const std::string reason = reason_for_nothing(corners, size); !reason.empty()) {
      ++skipped[reason];
    } else {
      drawing.draw(row, corners);
    }
  });
  const Image<Rgb8> image = drawing.finish();
  run.statistics()["triangles"] = triangles;
  run.statistics()["skipped"] = skipped;
  run.statistics()["pixels_seen"] = drawing.pixels_seen();
  run.picture("triangles", image);
}

void draw_file(const std::filesystem::path& file, Run& run) {
  const Size size = run.size({640, 480});
  const std::string& name = run.settings().algorithm;
  if (name.empty()) return draw_file(file, run, DepthDrawing(size), size);
  const auto* rung = std::find_if(visibility_ladder.begin(), visibility_ladder.end(),
                                  [&](const VisibilityRung& one) { return one.name == name; });
  if (rung == visibility_ladder.end())
    throw UsageError("--algorithm " + name + ": expected one of --algorithm list");
  draw_file(file, run, RungDrawing(size, *rung), size);
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
