// Runs the exercises of stage 07. The parts of a shader are tried alone, on points made up here:
// compiling whole shaders would take longer than all the rest of a grading.
#include "common/mesh/shapes.h"
#include "common/shaders/culled.h"
#include "common/shaders/draw_shaded.h"
#include "common/shaders/highlights.h"
#include "common/shaders/normal_maps.h"
#include "common/shaders/quantized.h"
#include "common/shaders/surface.h"
#include "common/shaders/vertex_normal.h"

#include "grading/probes/lit_scene.h"
#include "grading/probes/probe.h"

#include <limits>

namespace rasterlab::grading {
namespace {

/// A point of a surface, with the attributes that any part reads.
struct MadeUpPoint {
  using Number = float;

  struct {
    Vector3<float> position;
    Vector3<float> normal;
  } value;
};

/// A colour, normal and light source that say what they were told.
struct MadeUpSource {
  Color color;
  Vector3<float> normal;
  Vector3<float> to_light;

  Vector3<float> color_at(const MadeUpPoint& /*point*/) const { return color; }
  Vector3<float> normal_at(const MadeUpPoint& /*point*/) const { return normal; }
  Shade<float> light_at(const MadeUpPoint& /*point*/, const MadeUpSource& normals) const {
    return {maximum(dot(normals.normal_at({}), to_light), 0.0F)};
  }
};

/// Colours that differ from corner to corner, and holes.
struct Holed {
  template <class Number>
  struct Varyings {
    Vector3<Number> color;
    Vector2<Number> uv;
  };

  Varyings<float> vertex(const Mesh& mesh, std::uint32_t triangle, int corner) const {
    const std::uint32_t vertex = mesh.triangles[triangle][static_cast<std::size_t>(corner)];
    const Color by_corner = Color::Unit(corner) * 0.5F;
    return {by_corner + 0.5F * mesh.normals[vertex].cwiseAbs(), mesh.texture_coordinates[vertex]};
  }

  Fragment<float> fragment(const SurfacePoint<Varyings, float>& point) const {
    const auto odd = [](float coordinate) {
      return static_cast<int>(std::floor(coordinate * 12)) % 2 != 0;
    };
    const Vector3<float> seen = point.front_facing ? point.value.color : Color(1, 1, 1);
    return {seen, odd(point.value.uv.x()) && odd(point.value.uv.y())};
  }
};

void loop_scene(SceneInputs& scene, Results& results) {
  const Mesh mesh = make_shape(scene.example() ? "icosphere:1" : "torus:6");
  const Transforms transforms = lit_mesh(scene, mesh).transforms;
  const std::string names[] = {"all faces", "without backs", "without fronts"};
  for (const Cull cull : {Cull::none, Cull::back, Cull::front}) {
    Frame frame = make_frame(72, 60);
    draw_shaded(mesh, transforms, cull, Holed{}, frame);
    const std::string& name = names[static_cast<std::size_t>(cull)];
    results.picture(name, frame.color, 1, 4);
    results.values("depth of " + name, frame.depth.depths(), 1e-5, 4);
  }
}

void add(std::vector<double>& numbers, const Vector3<float>& vector) {
  for (const float number : vector) numbers.push_back(double(number));
}

void surface_scene(SceneInputs& scene, Results& results) {
  std::vector<double> colors;
  for (int i = 0; i < 40; ++i) {
    const Color color = scene.color();
    const MadeUpSource source{color, scene.direction(), scene.direction()};
    add(colors, surface_color(MadeUpPoint{}, source, source, source));
  }
  results.numbers("the colours", colors, 1e-6);
}

void quantize_scene(SceneInputs& scene, Results& results) {
  for (const int levels : {5, scene.whole(2, 4), scene.whole(6, 9)}) {
    std::vector<double> shades;
    for (const float value : {0.0F, 1.0F, -0.3F, 1.7F})
      shades.push_back(double(quantize(value, levels)));
    shades.push_back(double(quantize(std::numeric_limits<float>::quiet_NaN(), levels)));
    // Between the ends of the bands, where rounding decides nothing.
    const int parts = 8 * levels;
    for (int part = 0; part < parts; ++part) {
      const float value = (static_cast<float>(part) + 0.5F) / static_cast<float>(parts);
      shades.push_back(double(quantize(value, levels)));
    }
    results.numbers("in " + std::to_string(levels) + " levels", shades, 1e-6);
  }
}

void tangent_space_scene(SceneInputs& scene, Results& results) {
  std::vector<double> normals;
  for (int i = 0; i < 40; ++i) {
    const Vector3<float> local = scene.direction();
    Vector3<float> normal = scene.direction();
    normal *= scene.real(0.5F, 1);
    Vector3<float> tangent = scene.direction();
    if (i % 8 == 7) normal = 0.5F * Vector3<float>::UnitZ();  // where parallel means exactly so
    if (i % 8 == 7) tangent = Vector3<float>::UnitZ();
    const float handedness = i % 2 == 0 ? 1.0F : -1.0F;
    add(normals, normal_from_tangent_space(local, normal, tangent, handedness));
  }
  results.numbers("the normals", normals, 2e-5);
}

void cull_scene(SceneInputs& scene, Results& results) {
  const std::string names[] = {"none", "back", "front"};
  for (const Cull cull : {Cull::none, Cull::back, Cull::front}) {
    std::vector<double> seen;
    for (const bool front : {false, true}) {
      for (const bool discarded : {false, true}) {
        const Fragment<float> fragment =
            cull_fragment(Fragment<float>{scene.color(), discarded}, front, cull);
        seen.push_back(fragment.discarded ? 0 : 1);
        add(seen, fragment.color);
      }
    }
    results.numbers("1 for drawn, and the colour, where " + names[static_cast<std::size_t>(cull)] +
                        " is culled",
                    seen);
  }
}

void highlights_scene(SceneInputs& scene, Results& results) {
  const Mesh mesh = make_shape("wall:1");
  const LitMesh lit = lit_mesh(scene, mesh);
  ShaderInputs inputs{.mesh = mesh, .transforms = lit.transforms};
  inputs.light = lit.light;
  inputs.material = lit.material;
  const auto add_model = [&](const std::string& name, const auto& model) {
    std::vector<double> parts;
    for (int i = 0; i < 40; ++i) {
      MadeUpPoint point{};
      point.value.position = scene.vector(-1, 1);
      // Half of the normals are near the direction where highlights are.
      const Vector3<float> to_light = direction_to(inputs.light.position, point.value.position);
      const Vector3<float> to_eye = direction_to(eye_of(inputs.transforms), point.value.position);
      const Vector3<float> normal =
          i % 2 == 0 ? Vector3<float>(scene.direction())
                     : normalized(Vector3<float>(to_light + to_eye + 0.3F * scene.direction()));
      const MadeUpSource normals{{}, normal, {}};
      const Reflection<float> reflection = model.light_at(point, normals);
      parts.insert(parts.end(), {double(reflection.ambient), double(reflection.diffuse),
                                 double(reflection.specular)});
    }
    results.numbers(name + ": ambient, diffuse, specular", parts, 1e-4);
  };
  add_model("Phong", Phong(inputs));
  add_model("Blinn-Phong", BlinnPhong(inputs));
}

void normal_scene(SceneInputs& scene, Results& results) {
  const Mesh mesh = make_shape("wall:1");
  const VertexNormal source(ShaderInputs{.mesh = mesh});
  std::vector<double> normals;
  for (int i = 0; i < 40; ++i) {
    MadeUpPoint point{};
    const Vector3<float> one = scene.direction();
    point.value.normal = one + scene.real(0, 1) * (scene.direction() - one);
    if (i == 7) point.value.normal = Vector3<float>::Zero();
    add(normals, source.normal_at(point));
  }
  results.numbers("the normals", normals, 1e-6);
}

}  // namespace
}  // namespace rasterlab::grading

int main(int argc, char** argv) {
  using namespace rasterlab::grading;
  return run_probe(argc, argv,
                   {{"07.1", loop_scene},
                    {"07.2", surface_scene},
                    {"07.3", quantize_scene},
                    {"07.4", tangent_space_scene},
                    {"07.5", cull_scene},
                    {"07.6", highlights_scene},
                    {"07.8", normal_scene}});
}
