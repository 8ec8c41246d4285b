#include "bench/texture/attributes.h"

#include "common/engine/simd_target.h"
#include "common/image/check.h"
#include "common/triangles/edge_function.h"
#include "common/triangles/spans.h"

#include "bench/support/quad.h"
#include "bench/texture/attribute_rows.h"
#include "bench/texture/attribute_triangles.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace rasterlab::bench {
namespace {

constexpr int tile_size = AttributeRow::most;

/// A row of pixels as the rungs see it, and where it is.
struct Row {
  AttributeRow row;
  std::size_t triangle;
  int x;
  int y;
};

/// The value over w of each corner as a plane in the window, its constant at pixel (x, y)'s
/// corner. Set up in doubles, rounded once: as a triangle's set-up can afford it.
Plane plane_over_w(const AttributeTriangle& triangle, double AttributeCorner::*value, double x,
                   double y) {
  const TriangleEdges edges = make_edges(triangle.snapped);
  double a = 0;
  double b = 0;
  double c = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const AttributeCorner& corner = triangle.corners[i];
    const double numerator = value == &AttributeCorner::w ? 1 : corner.*value;
    const double share = numerator / corner.w / static_cast<double>(edges.twice_area);
    const EdgeFunction& edge = edges.edges[i];
    const auto step_x = static_cast<double>(edge.step_x);
    const auto step_y = static_cast<double>(edge.step_y);
    a += share * step_x;
    b += share * step_y;
    c += share * (static_cast<double>(edge.at_first) + (x - 0.5) * step_x + (y - 0.5) * step_y);
  }
  return {static_cast<float>(a), static_cast<float>(b), static_cast<float>(c)};
}

AttributeRow make_row(const AttributeTriangle& triangle, int x, int y, int count) {
  const int left = x / tile_size * tile_size;
  const int top = y / tile_size * tile_size;
  AttributeRow row;
  row.x = static_cast<float>(x) + 0.5F;
  row.y = static_cast<float>(y) + 0.5F;
  row.x_in_tile = static_cast<float>(x - left) + 0.5F;
  row.y_in_tile = static_cast<float>(y - top) + 0.5F;
  row.count = count;
  const std::array<double AttributeCorner::*, 3> values = {&AttributeCorner::u, &AttributeCorner::v,
                                                           &AttributeCorner::w};
  for (std::size_t i = 0; i < 3; ++i) {
    row.from_origin[i] = plane_over_w(triangle, values[i], 0, 0);
    row.from_tile[i] = plane_over_w(triangle, values[i], left, top);
    row.u[i] = static_cast<float>(triangle.corners[i].u);
    row.v[i] = static_cast<float>(triangle.corners[i].v);
  }
  const TriangleEdges edges = make_edges(triangle.snapped);
  row.edge1 = static_cast<double>(edges.edges[1].at(x, y));
  row.edge2 = static_cast<double>(edges.edges[2].at(x, y));
  row.area = static_cast<double>(edges.twice_area);
  row.step1 = static_cast<double>(edges.edges[1].step_x);
  row.step2 = static_cast<double>(edges.edges[2].step_x);
  row.ratio1 = static_cast<float>(triangle.corners[0].w / triangle.corners[1].w);
  row.ratio2 = static_cast<float>(triangle.corners[0].w / triangle.corners[2].w);
  return row;
}

std::vector<Row> make_rows(const std::vector<AttributeTriangle>& triangles) {
  std::vector<Row> rows;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for_each_span(triangles[i].snapped, attribute_width, attribute_height,
                  [&](int y, int begin, int end) {
                    for (int x = begin; x < end;) {
                      const int stop = std::min(end, (x / tile_size + 1) * tile_size);
                      rows.push_back({make_row(triangles[i], x, y, stop - x), i, x, y});
                      x = stop;
                    }
                  });
  }
  return rows;
}

struct Input {
  std::vector<AttributeTriangle> triangles;
  std::vector<Row> rows;

  explicit Input(double w_ratio)
      : triangles(attribute_triangles(w_ratio)), rows(make_rows(triangles)) {}

  double pixels() const {
    double sum = 0;
    for (const Row& row : rows) sum += row.row.count;
    return sum;
  }
};

double last_place(double value) {
  return std::ldexp(1.0, std::max(std::ilogb(value), -126) - 23);
}

/// Room for one row, and for the vector that goes on beyond it.
using RowOfNumbers = std::array<float, AttributeRow::most + 16>;

/// What a rung means to compute at pixel x of a row.
template <class Number>
Texels<Number> meant(const AttributeRung& rung, const AttributeTriangle& triangle, const Row& row,
                     int x) {
  if (rung.run_length == 0) return texels_at<Number>(triangle, x, row.y);
  const int end = row.x + row.row.count;
  return texels_in_runs<Number>(triangle, rung.run_length, row.x, end, x, row.y);
}

/// The error against the same model, and, where that may not be perspective itself, the model's
/// own. Of every 17th row: quads are slow.
Errors errors_of(const AttributeRung& rung, const Input& input, bool with_model) {
  MeasuredError distance;
  MeasuredError places;
  MeasuredError model;
  RowOfNumbers u;
  RowOfNumbers v;
  for (std::size_t r = 0; r < input.rows.size(); r += 17) {
    const Row& row = input.rows[r];
    const AttributeTriangle& triangle = input.triangles[row.triangle];
    rung.evaluate(row.row, u.data(), v.data());
    for (int i = 0; i < row.row.count; ++i) {
      const int x = row.x + i;
      const Texels<double> by_double = meant<double>(rung, triangle, row, x);
      const Texels<Quad> by_quad = meant<Quad>(rung, triangle, row, x);
      const Texels<float> computed = {u[static_cast<std::size_t>(i)],
                                      v[static_cast<std::size_t>(i)]};
      for (std::size_t c = 0; c < 2; ++c) {
        const double off_double = double{computed[c]} - by_double[c];
        const Quad off_quad = Quad{computed[c]} - by_quad[c];
        const double place = last_place(static_cast<double>(by_quad[c]));
        distance.add(off_double, off_quad);
        places.add(off_double / place, off_quad / place);
      }
      if (!with_model) continue;
      const Texels<double> true_double = texels_at<double>(triangle, x, row.y);
      const Texels<Quad> true_quad = texels_at<Quad>(triangle, x, row.y);
      for (std::size_t c = 0; c < 2; ++c)
        model.add(by_double[c] - true_double[c], by_quad[c] - true_quad[c]);
    }
  }
  Errors errors;
  if (with_model) {
    errors = {{"model: largest, texels", model.largest()},
              {"model: RMS, texels", model.root_mean_square()}};
  }
  errors.insert(errors.end(), {{"implementation: largest, texels", distance.largest()},
                               {"implementation: RMS, texels", distance.root_mean_square()},
                               {"implementation: largest, ULP", places.largest()},
                               {"implementation: RMS, ULP", places.root_mean_square()}});
  return errors;
}

TimedLadder make_ladder(const std::string& name, double w_ratio,
                        std::span<const AttributeRung> rungs, bool with_model) {
  const auto input = std::make_shared<Input>(w_ratio);
  TimedLadder ladder{
      .name = name + ", w up to 1:" + std::to_string(static_cast<int>(w_ratio)),
      .stage = "06",
      .unit = "pixel",
      .units = input->pixels(),
      .error = with_model ? "model: largest, texels" : "implementation: largest, texels",
      .rungs = {}};
  for (const AttributeRung& rung : rungs) {
    const auto u = std::make_shared<RowOfNumbers>();
    const auto v = std::make_shared<RowOfNumbers>();
    ladder.rungs.push_back({.name = rung.name,
                            .fault = rung.known_fault,
                            .work =
                                [input, u, v, evaluate = rung.evaluate] {
                                  for (const Row& row : input->rows)
                                    evaluate(row.row, u->data(), v->data());
                                },
                            .errors = errors_of(rung, *input, with_model)});
  }
  return ladder;
}

/// The rungs for the widest instruction set this machine has.
struct Rungs {
  std::span<const AttributeRung> each;
  std::span<const AttributeRung> affine;
};

Rungs best_rungs() {
  switch (best_simd_target()) {
#define RASTERLAB_CASE(simd) \
  case SimdTarget::simd:     \
    return {simd_##simd::attribute_rungs(), simd_##simd::affine_rungs()};
    RASTERLAB_EACH_SIMD_TARGET(RASTERLAB_CASE)
#undef RASTERLAB_CASE
    default:
      throw CheckError("this build has no instruction set that this machine can run");
  }
}

}  // namespace

TimedLadder attribute_ladder(double w_ratio) {
  return make_ladder("attributes", w_ratio, best_rungs().each, false);
}

TimedLadder affine_run_ladder(double w_ratio) {
  return make_ladder("affine runs", w_ratio, best_rungs().affine, true);
}

}  // namespace rasterlab::bench
