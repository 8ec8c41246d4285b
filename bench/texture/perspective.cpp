#include "bench/texture/perspective.h"

#include "common/texture/perspective_ladder.h"
#include "common/triangles/rasterize.h"

#include "bench/support/quad.h"
#include "bench/texture/attribute_triangles.h"

#include <memory>
#include <string>

namespace rasterlab::bench {
namespace {

struct Row {
  std::size_t triangle;
  int x;
  int y;
  std::vector<Eigen::Vector3d> weights;  ///< on the screen
};

struct Input {
  std::vector<AttributeTriangle> triangles;
  std::vector<Row> rows;
  double pixels = 0;

  explicit Input(double w_ratio) : triangles(attribute_triangles(w_ratio)) {
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const SnappedTriangle& snapped = triangles[i].snapped;
      const TriangleEdges edges = make_edges(snapped);
      for_each_span(snapped, attribute_width, attribute_height, [&](int y, int begin, int end) {
        Row row{i, begin, y, {}};
        visit_span(edges, y, begin, end, [&](int, int, const Eigen::Vector3d& on_screen) {
          row.weights.push_back(on_screen);
        });
        pixels += static_cast<double>(row.weights.size());
        rows.push_back(std::move(row));
      });
    }
  }
};

Eigen::Vector3d inverse_w(const AttributeTriangle& triangle) {
  return {1 / triangle.corners[0].w, 1 / triangle.corners[1].w, 1 / triangle.corners[2].w};
}

/// The runs of each rung of the ladder, in pixels; 0 for none, −1 for a whole row without division.
constexpr std::array<int, 4> run_lengths = {-1, 16, 8, 0};

template <class Number>
Texels<Number> meant(int run_length, const AttributeTriangle& triangle, const Row& row, int x) {
  if (run_length <= 0) return texels_at<Number>(triangle, x, row.y, run_length < 0);
  const int end = row.x + static_cast<int>(row.weights.size());
  return texels_in_runs<Number>(triangle, run_length, row.x, end, x, row.y);
}

Errors errors_of(PerspectiveRung rung, int run_length, const Input& input) {
  MeasuredError model;
  MeasuredError implementation;
  for (std::size_t r = 0; r < input.rows.size(); r += 17) {
    const Row& row = input.rows[r];
    const AttributeTriangle& triangle = input.triangles[row.triangle];
    std::vector<Eigen::Vector3d> on_triangle(row.weights.size());
    rung({inverse_w(triangle), row.weights}, on_triangle);
    for (std::size_t i = 0; i < on_triangle.size(); ++i) {
      const int x = row.x + static_cast<int>(i);
      const Texels<double> by_double = meant<double>(run_length, triangle, row, x);
      const Texels<Quad> by_quad = meant<Quad>(run_length, triangle, row, x);
      const Texels<double> true_double = texels_at<double>(triangle, x, row.y);
      const Texels<Quad> true_quad = texels_at<Quad>(triangle, x, row.y);
      Texels<double> computed = {0, 0};
      for (std::size_t c = 0; c < 3; ++c) {
        const double weight = on_triangle[i][static_cast<Eigen::Index>(c)];
        computed[0] += weight * triangle.corners[c].u;
        computed[1] += weight * triangle.corners[c].v;
      }
      for (std::size_t c = 0; c < 2; ++c) {
        model.add(by_double[c] - true_double[c], by_quad[c] - true_quad[c]);
        implementation.add(computed[c] - by_double[c], Quad{computed[c]} - by_quad[c]);
      }
    }
  }
  return {{"model: largest, texels", model.largest()},
          {"model: RMS, texels", model.root_mean_square()},
          {"implementation: largest, texels", implementation.largest()},
          {"implementation: RMS, texels", implementation.root_mean_square()}};
}

}  // namespace

TimedLadder perspective_ladder_of(double w_ratio) {
  const auto input = std::make_shared<Input>(w_ratio);
  TimedLadder ladder{
      .name = "06.3 perspective, w up to 1:" + std::to_string(static_cast<int>(w_ratio)),
      .stage = "06",
      .unit = "pixel",
      .units = input->pixels,
      .error = "model: largest, texels",
      .rungs = {}};
  for (std::size_t i = 0; i < run_lengths.size(); ++i) {
    const NamedPerspectiveRung& rung = perspective_ladder()[i];
    const auto room = std::make_shared<std::vector<Eigen::Vector3d>>(attribute_width);
    ladder.rungs.push_back(
        {.name = rung.name,
         .fault = rung.known_fault,
         .work =
             [input, room, weights = rung.weights] {
               for (const Row& row : input->rows) {
                 const Eigen::Vector3d over = inverse_w(input->triangles[row.triangle]);
                 weights({over, row.weights}, {room->data(), row.weights.size()});
               }
             },
         .errors = errors_of(rung.weights, run_lengths[i], *input)});
  }
  return ladder;
}

}  // namespace rasterlab::bench
