// The engine covers what the exercise code covers.
#include "common/engine/renderer.h"
#include "common/mesh/shapes.h"
#include "common/projection/draw_mesh.h"
#include "common/projection/look_at.h"
#include "common/projection/perspective.h"

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

struct Difference {
  int coverage = 0;
  int triangle = 0;
};

Difference compare(const Mesh& mesh, const Transforms& transforms, Cull cull, int width,
                   int height) {
  Frame expected = make_frame(width, height);
  expected.ids = Image<std::int32_t>(width, height, -1);
  draw_mesh(mesh, transforms, cull, expected,
            [](std::uint32_t, const TrianglePixel&) { return Color(1, 1, 1); });
  Framebuffer actual(width, height);
  actual.clear();
  const PreparedMesh prepared(mesh);
  Renderer().draw({.mesh = &prepared, .matrix = transforms.to_clip(), .cull = cull}, actual);
  const Image<std::int32_t> ids = actual.ids();
  Difference difference;
  for (std::size_t i = 0; i < ids.pixels().size(); ++i) {
    const std::int32_t a = ids.pixels()[i];
    const std::int32_t b = expected.ids.pixels()[i];
    difference.coverage += (a < 0) != (b < 0) ? 1 : 0;
    difference.triangle += a != b ? 1 : 0;
  }
  return difference;
}

TEST(engine_exercise, same_pixels_from_everywhere) {
  for (const char* shape : {"cube:3", "uv_sphere:60", "torus_knot:20", "wall:1", "grid:7"}) {
    const Mesh mesh = make_shape(shape);
    for (int i = 0; i < 40; ++i) {
      const float angle = 0.7F * static_cast<float>(i);
      const float distance = 0.3F + 0.1F * static_cast<float>(i);
      Transforms transforms;
      transforms.view = look_at(distance * Eigen::Vector3f(std::cos(angle), 0.3F, std::sin(angle)),
                                Eigen::Vector3f(0.1F, 0, 0), Eigen::Vector3f::UnitY());
      transforms.projection = perspective(60, 1.5F, 0.1F, 20);
      for (const Cull cull : {Cull::none, Cull::back, Cull::front}) {
        const Difference difference = compare(mesh, transforms, cull, 301, 200);
        EXPECT_EQ(difference.coverage, 0) << shape << " view " << i;
        EXPECT_LE(difference.triangle, 6) << shape << " view " << i;
      }
    }
  }
}

}  // namespace
}  // namespace rasterlab
