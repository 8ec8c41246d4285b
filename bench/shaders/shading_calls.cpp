#include "bench/shaders/shading_calls.h"

#include "common/engine/simd_target.h"
#include "common/image/check.h"

#include "bench/shaders/wide_calls.h"
#include "bench/support/picture_error.h"
#include "bench/support/random_number.h"

#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <string>

namespace rasterlab::bench {
namespace {

constexpr int side = 64;
static_assert(side * side == ShadedPoints::count);

/// A sphere's, seen from the front, with some unevenness.
ShadedPoints make_points() {
  std::mt19937 random(37);
  ShadedPoints points;
  for (auto& array : points.varyings) array.resize(ShadedPoints::count);
  for (auto& array : points.color) array.resize(ShadedPoints::count);
  for (int i = 0; i < ShadedPoints::count; ++i) {
    const int column = i % side;
    const int row = i / side;
    const double x = (column + 0.5) / side * 1.4 - 0.7 + random_number(random, -0.02, 0.02);
    const double y = (row + 0.5) / side * 1.4 - 0.7 + random_number(random, -0.02, 0.02);
    const Eigen::Vector3d place(x, y, std::sqrt(std::max(1 - x * x - y * y, 0.01)));
    for (std::size_t c = 0; c < 6; ++c) {
      points.varyings[c][static_cast<std::size_t>(i)] =
          static_cast<float>(place[static_cast<Eigen::Index>(c % 3)]);
    }
  }
  return points;
}

template <class Shader, class Number>
SurfacePoint<Shader::template Varyings, Number> point_at(const ShadedPoints& points,
                                                         std::size_t index) {
  SurfacePoint<Shader::template Varyings, Number> point;
  constexpr auto count = static_cast<std::size_t>(number_count<Shader::template Varyings>());
  for (std::size_t n = 0; n < count; ++n) {
    numbers<Shader::template Varyings, Number>(point.value)[n] = points.varyings[n][index];
  }
  return point;
}

/// Calls `fragment` for every point. Not inlined, so that it sees no more of what it calls than a
/// renderer that was compiled before the shader was written.
template <class Shader, class Fragment>
[[gnu::noinline]] void shade_each(const Fragment& fragment, ShadedPoints& points) {
  for (std::size_t i = 0; i < ShadedPoints::count; ++i) {
    const Eigen::Vector3f color = fragment(point_at<Shader, float>(points, i));
    for (std::size_t c = 0; c < 3; ++c) points.color[c][i] = color[static_cast<Eigen::Index>(c)];
  }
}

template <class Shader>
using Point = SurfacePoint<Shader::template Varyings, float>;

template <class Shader>
struct Virtual {
  virtual ~Virtual() = default;
  virtual Eigen::Vector3f fragment(const Point<Shader>& point) const = 0;
};

template <class Shader>
struct Overridden : Virtual<Shader> {
  Shader shader;
  Eigen::Vector3f fragment(const Point<Shader>& point) const override {
    return shader.fragment(point);
  }
};

template <class Shader>
using WideCall = void (*)(const Shader& shader, ShadedPoints& points);

template <class Shader>
struct WideCalls {
  WideCall<Shader> one_vector;
  WideCall<Shader> two_vectors;
};

/// For the widest instruction set this machine has.
template <class Shader>
WideCalls<Shader> best_calls() {
  switch (best_simd_target()) {
#define RASTERLAB_CASE(simd) \
  case SimdTarget::simd:     \
    return {&simd_##simd::shade_wide, &simd_##simd::shade_in_pairs};
    RASTERLAB_EACH_SIMD_TARGET(RASTERLAB_CASE)
#undef RASTERLAB_CASE
    default:
      throw CheckError("this build has no instruction set that this machine can run");
  }
}

template <class Shader>
Image<TrueColor> true_picture(const Shader& shader, const ShadedPoints& points) {
  Image<TrueColor> picture(side, side, TrueColor::black());
  for (std::size_t i = 0; i < ShadedPoints::count; ++i) {
    picture.pixels()[i] = {shader.fragment(point_at<Shader, OracleNumber<double>>(points, i)),
                           shader.fragment(point_at<Shader, OracleNumber<Quad>>(points, i))};
  }
  return picture;
}

Image<Color> picture_of(const ShadedPoints& points) {
  Image<Color> picture(side, side);
  for (std::size_t i = 0; i < ShadedPoints::count; ++i)
    picture.pixels()[i] = {points.color[0][i], points.color[1][i], points.color[2][i]};
  return picture;
}

template <class Shader>
TimedLadder call_ladder(const std::string& name) {
  const Shader shader{{.eye = {0.1F, 0.2F, 3}}};
  const auto points = std::make_shared<ShadedPoints>(make_points());
  const Image<TrueColor> truth = true_picture(shader, *points);
  TimedLadder ladder{.name = "calling " + name,
                     .stage = "07",
                     .unit = "pixel",
                     .units = ShadedPoints::count,
                     .error = "implementation: RMSE, codes",
                     .rungs = {}};
  const auto add = [&](const char* rung, const char* fault, std::function<void()> work) {
    work();
    ladder.rungs.push_back(
        {.name = rung,
         .fault = fault,
         .work = std::move(work),
         .errors = picture_errors("implementation", picture_of(*points), truth)});
  };
  const std::function<Eigen::Vector3f(const Point<Shader>&)> stored =
      [shader](const Point<Shader>& point) { return shader.fragment(point); };
  add("std::function", "a call through a pointer for each pixel",
      [points, stored] { shade_each<Shader>(stored, *points); });
  const auto overridden = std::make_shared<Overridden<Shader>>();
  overridden->shader = shader;
  add("virtual", "a call through a pointer for each pixel", [points, overridden] {
    const Virtual<Shader>& base = *overridden;
    shade_each<Shader>([&base](const Point<Shader>& point) { return base.fragment(point); },
                       *points);
  });
  add("static", "a copy of the loop for each shader", [points, shader] {
    shade_each<Shader>([&shader](const Point<Shader>& point) { return shader.fragment(point); },
                       *points);
  });
  const WideCalls<Shader> wide = best_calls<Shader>();
  add("wide", "a copy for each shader and instruction set",
      [points, shader, call = wide.one_vector] { call(shader, *points); });
  add("wide, two vectors", "a copy for each shader and instruction set",
      [points, shader, call = wide.two_vectors] { call(shader, *points); });
  return ladder;
}

}  // namespace

TimedLadder flat_call_ladder() {
  return call_ladder<FlatShader>("a shader of a dozen operations");
}

TimedLadder phong_call_ladder() {
  return call_ladder<PhongShader>("Phong's shader");
}

}  // namespace rasterlab::bench
