#include "bench/lighting/shading_models.h"

#include "common/lighting/shading.h"
#include "common/lighting/surface_lighting.h"
#include "common/mesh/shapes.h"
#include "common/projection/look_at.h"
#include "common/projection/perspective.h"

#include "bench/support/exact_points.h"
#include "bench/support/picture_error.h"

#include <algorithm>
#include <memory>
#include <string>

namespace rasterlab::bench {
namespace {

constexpr int size = 192;

/// What all rungs draw. Keeps its mesh, to which `lit_mesh` refers.
struct Subject {
  Mesh mesh;
  LitMesh lit_mesh;

  explicit Subject(int rings)
      : mesh(make_shape("uv_sphere", rings)),
        lit_mesh{.mesh = mesh,
                 .transforms = {.view = look_at({0.4F, 0.8F, 2.4F}, {0, 0, 0}, {0, 1, 0}),
                                .projection = perspective(50, 1, 0.1F, 20)},
                 .light = {.position = {3, 4, 5, 1}},
                 .material = {},
                 .color = Color(0.9F, 0.55F, 0.3F)} {}
};

template <class Number>
SurfaceSample<Number> widened(const SurfaceSample<float>& sample) {
  return {broadcast<Number>(sample.position), broadcast<Number>(sample.normal),
          broadcast<Number>(sample.color)};
}

/// What a rung means to show at a pixel, given the triangle's corners and their weights there.
template <class Number>
struct Models {
  using Corners = std::array<SurfaceSample<float>, 3>;
  using Weights = std::array<Number, 3>;

  static Vector3<Number> flat(const SurfaceLighting& lighting, std::uint32_t triangle,
                              const Weights&) {
    return lighting.light(widened<Number>(lighting.face(triangle)));
  }
  static Vector3<Number> gouraud(const SurfaceLighting& lighting, std::uint32_t triangle,
                                 const Weights& weights) {
    const Corners corners = lighting.corners(triangle);
    return mixed<Number>(weights, {lighting.light(widened<Number>(corners[0])),
                                   lighting.light(widened<Number>(corners[1])),
                                   lighting.light(widened<Number>(corners[2]))});
  }
  static Vector3<Number> phong(const SurfaceLighting& lighting, std::uint32_t triangle,
                               const Weights& weights) {
    const Corners corners = lighting.corners(triangle);
    const auto mix = [&](Eigen::Vector3f SurfaceSample<float>::*member) -> Vector3<Number> {
      return mixed<Number>(
          weights, {broadcast<Number>(corners[0].*member), broadcast<Number>(corners[1].*member),
                    broadcast<Number>(corners[2].*member)});
    };
    using Sample = SurfaceSample<float>;
    return lighting.light(SurfaceSample<Number>{
        mix(&Sample::position), normalized(mix(&Sample::normal)), mix(&Sample::color)});
  }
};

template <class Number>
using Model = Vector3<Number> (*)(const SurfaceLighting&, std::uint32_t,
                                  const std::array<Number, 3>&);

struct BothModels {
  Model<OracleNumber<double>> by_double;
  Model<OracleNumber<Quad>> by_quad;
};

constexpr std::array<BothModels, 3> models = {
    {{&Models<OracleNumber<double>>::flat, &Models<OracleNumber<Quad>>::flat},
     {&Models<OracleNumber<double>>::gouraud, &Models<OracleNumber<Quad>>::gouraud},
     {&Models<OracleNumber<double>>::phong, &Models<OracleNumber<Quad>>::phong}}};

/// A model's picture where `ids` has triangles, black elsewhere.
Image<TrueColor> picture_of(const BothModels& model, const Subject& subject,
                            const Image<std::int32_t>& ids) {
  const SurfaceLighting lighting(subject.lit_mesh);
  const ExactPoints points(subject.mesh, subject.lit_mesh.transforms, size, size);
  Image<TrueColor> picture(size, size, TrueColor::black());
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      if (ids.row(y)[x] < 0) continue;
      const auto triangle = static_cast<std::uint32_t>(ids.row(y)[x]);
      picture.row(y)[x] = {
          model.by_double(lighting, triangle, points.weights<double>(triangle, x, y)),
          model.by_quad(lighting, triangle, points.weights<Quad>(triangle, x, y))};
    }
  }
  return picture;
}

Frame drawn(ShadeFunction shade, const Subject& subject) {
  Frame frame = make_frame(size, size);
  frame.ids = Image<std::int32_t>(size, size, -1);
  shade(subject.lit_mesh, frame);
  return frame;
}

}  // namespace

TimedLadder shading_ladder_of(int rings) {
  const auto subject = std::make_shared<Subject>(rings);
  const Frame first = drawn(shading_ladder[0].shade, *subject);
  const auto covered = std::count_if(first.ids.pixels().begin(), first.ids.pixels().end(),
                                     [](std::int32_t id) { return id >= 0; });
  TimedLadder ladder{.name = "05.5 shading, a sphere of " + std::to_string(rings) + " rings",
                     .stage = "05",
                     .unit = "visible pixel",
                     .units = static_cast<double>(covered),
                     .error = "model: RMSE, codes",
                     .rungs = {}};
  const Image<TrueColor> truth = picture_of(models.back(), *subject, first.ids);
  for (std::size_t i = 0; i < models.size(); ++i) {
    const ShadingRung& rung = shading_ladder[i];
    const Image<TrueColor> meant = picture_of(models[i], *subject, first.ids);
    Errors errors = picture_errors("model", meant, truth);
    const Image<Color> picture = to_colors(drawn(rung.shade, *subject).color);
    const Errors implementation = picture_errors("implementation", picture, meant);
    errors.insert(errors.end(), implementation.begin(), implementation.end());
    const auto frame = std::make_shared<Frame>(make_frame(size, size));
    ladder.rungs.push_back({.name = rung.name,
                            .fault = rung.known_fault,
                            .work =
                                [subject, frame, shade = rung.shade] {
                                  clear(*frame);
                                  shade(subject->lit_mesh, *frame);
                                },
                            .errors = errors});
  }
  return ladder;
}

}  // namespace rasterlab::bench
