#include "common/projection/eye.h"
#include "common/projection/orthographic.h"
#include "common/projection/rotation.h"
#include "common/projection/viewport.h"
#include "common/shaders/culled.h"
#include "common/shaders/draw_shaded.h"
#include "common/shaders/lattice.h"
#include "common/shaders/shaders.h"

#include "tests/stage07/scene.h"
#include "tests/support/toy_lanes.h"

#include <gtest/gtest.h>

namespace rasterlab {
namespace {

const char* name_of(Cull cull) {
  if (cull == Cull::none) return "none";
  return cull == Cull::back ? "back" : "front";
}

bool is_refused(Cull cull, bool front) {
  return (cull == Cull::back && !front) || (cull == Cull::front && front);
}

TEST(stage07_cull_fragment, refuses_the_side_that_is_named) {
  for (const Cull cull : {Cull::none, Cull::back, Cull::front}) {
    for (const bool front : {false, true}) {
      for (const bool discarded : {false, true}) {
        const Fragment<float> fragment{{0.1F, 0.2F, 0.3F}, discarded};
        const Fragment<float> result = cull_fragment(fragment, front, cull);
        EXPECT_EQ(result.discarded, discarded || is_refused(cull, front))
            << "cull " << name_of(cull) << ", the " << (front ? "front" : "back") << " is seen"
            << (discarded ? ", and the shader itself had refused the pixel" : "");
        EXPECT_EQ(result.color, fragment.color) << "the colour stays as it is";
      }
    }
  }
}

TEST(stage07_cull_fragment, lanes_equal_one_float) {
  Fragment<ToyLanes<4>> wide;
  wide.discarded.lane = {false, true, false, true};
  ToyMask<4> front;
  front.lane = {false, false, true, true};
  for (const Cull cull : {Cull::none, Cull::back, Cull::front}) {
    const auto result = cull_fragment(wide, front, cull);
    for (std::size_t i = 0; i < 4; ++i) {
      const Fragment<float> one{{0, 0, 0}, wide.discarded.lane[i]};
      EXPECT_EQ(result.discarded.lane[i], cull_fragment(one, front.lane[i], cull).discarded);
    }
  }
}

/// A sphere without its top: one sees both its sides.
Mesh bowl() {
  Mesh mesh = colored("uv_sphere:12");
  std::erase_if(mesh.triangles, [&](const Mesh::Triangle& triangle) {
    return mesh.positions[triangle[0]].y() > 0.4F;
  });
  return mesh;
}

/// In perspective and without, as it is, mirrored once, twice and three times.
std::vector<Transforms> cameras() {
  std::vector<Transforms> all;
  for (const Eigen::Matrix4f& projection :
       {perspective(45, 1, 0.1F, 20), perspective(100, 1, 0.1F, 20), orthographic(3, 1, 0.1F, 9)}) {
    for (const Eigen::Vector3f& scale :
         {Eigen::Vector3f(1, 1, 1), Eigen::Vector3f(-1, 1, 1), Eigen::Vector3f(-1, 1.2F, -0.7F),
          Eigen::Vector3f(-0.8F, -1, -1)}) {
      all.push_back({.model = rotation(30, {1, 2, 0}) * scaling(scale),
                     .view = look_at({0.5F, 1.6F, 2}, {0.1F, 0, 0}, {0.2F, 1, 0}),
                     .projection = projection});
    }
  }
  return all;
}

/// The cosine between a face's outer side, in the world, and the way from it to the eye.
double outer_cosine(const Mesh& mesh, int face, const Transforms& transforms) {
  const Eigen::Matrix3d model = transforms.model.topLeftCorner<3, 3>().cast<double>();
  const auto& [a, b, c] = mesh.triangles[static_cast<std::size_t>(face)];
  const auto corner = [&](std::uint32_t vertex) -> Eigen::Vector3d {
    return model * mesh.positions[vertex].cast<double>();
  };
  const double outward = model.determinant() < 0 ? -1 : 1;
  const Eigen::Vector3d normal =
      outward * (corner(b) - corner(a)).cross(corner(c) - corner(a)).normalized();
  const Eigen::Vector4d eye = eye_of(transforms).cast<double>();
  return normal.dot((eye.head<3>() - eye.w() * corner(a)).normalized());
}

Frame draw_bowl(const Mesh& mesh, const Transforms& transforms, Cull by_shader, Cull by_loop,
                const Light& light = {}) {
  const ShaderInputs inputs = {.mesh = mesh, .transforms = transforms, .light = light};
  Frame frame = make_frame(64, 64);
  frame.ids = Image<std::int32_t>(64, 64, -1);
  const Culled<PhongSurface<VertexColor>> shader{PhongSurface<VertexColor>(inputs), by_shader};
  draw_shaded(mesh, transforms, by_loop, shader, frame);
  return frame;
}

TEST(stage07_cull_fragment, what_is_left_faces_the_camera_in_every_projection) {
  const Mesh mesh = bowl();
  for (const Transforms& transforms : cameras()) {
    for (const Cull cull : {Cull::back, Cull::front}) {
      int drawn = 0;
      const Frame frame = draw_bowl(mesh, transforms, cull, Cull::none);
      for (const std::int32_t face : frame.ids.pixels()) {
        if (face < 0) continue;
        ++drawn;
        const double cosine = outer_cosine(mesh, face, transforms);
        if (std::abs(cosine) < 1e-3) continue;  // so nearly edge-on that snapping decides
        EXPECT_EQ(cosine > 0, cull == Cull::back)
            << "face " << face << " shows its " << (cosine > 0 ? "front" : "back") << ", cull "
            << name_of(cull) << "; model:\n"
            << transforms.model << "\nprojection:\n"
            << transforms.projection;
      }
      EXPECT_GT(drawn, 50) << "nothing to compare";
    }
  }
}

TEST(stage07_cull_fragment, gives_the_picture_of_the_loops_own_culling) {
  const Mesh mesh = bowl();
  for (const Transforms& transforms : cameras()) {
    for (const Cull cull : {Cull::none, Cull::back, Cull::front}) {
      const Frame by_shader = draw_bowl(mesh, transforms, cull, Cull::none);
      const Frame by_loop = draw_bowl(mesh, transforms, Cull::none, cull);
      EXPECT_TRUE(by_shader.color == by_loop.color) << name_of(cull);
      EXPECT_TRUE(by_shader.ids == by_loop.ids) << name_of(cull);
    }
  }
}

TEST(stage07_cull_fragment, does_not_ask_the_light) {
  const Mesh mesh = bowl();
  const Transforms transforms = cameras().front();
  const Frame lit = draw_bowl(mesh, transforms, Cull::back, Cull::none, {.position = {0, 1, 1, 0}});
  const Frame from_behind =
      draw_bowl(mesh, transforms, Cull::back, Cull::none, {.position = {0, -1, -1, 0}});
  EXPECT_TRUE(lit.ids == from_behind.ids) << "which faces are drawn changes with the light";
}

TEST(stage07_cull_fragment, keeps_what_the_shader_refused) {
  const TestScene scene("uv_sphere:24");
  const ShaderInputs inputs = scene.inputs();
  Frame plain = make_frame(64, 64);
  Frame culled = make_frame(64, 64);
  const DrawCounts alone =
      draw_shaded(scene.mesh, inputs.transforms, Cull::back, Lattice(inputs), plain);
  draw_shaded(scene.mesh, inputs.transforms, Cull::none,
              Culled<Lattice>{Lattice(inputs), Cull::back}, culled);
  EXPECT_GT(alone.discarded, 100);
  EXPECT_TRUE(plain.color == culled.color) << "the lattice lost its holes";
}

}  // namespace
}  // namespace rasterlab
