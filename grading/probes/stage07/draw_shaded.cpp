// Exercise 07.1.
#include "common/shaders/draw_shaded.h"

#include "common/mesh/shapes.h"

#include "grading/probes/lit_scene.h"

namespace rasterlab::grading {
namespace {

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

}  // namespace

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

}  // namespace rasterlab::grading
