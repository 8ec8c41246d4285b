// Closed meshes from every side, counted layer by layer: no sample is covered twice and none
// missed.
#include "common/engine/renderer.h"
#include "common/mesh/shapes.h"

#include <numbers>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

constexpr int width = 96;
constexpr int height = 80;

Eigen::Matrix4f perspective_from(const Eigen::Vector3f& direction, float distance) {
  Eigen::Matrix4f projection = Eigen::Matrix4f::Zero();
  projection(0, 0) = 1.2F;
  projection(1, 1) = 1.44F;
  projection(2, 2) = -1;
  projection(2, 3) = -0.2F;
  projection(3, 2) = -1;
  const Eigen::Vector3f back = direction.normalized();
  const Eigen::Vector3f right = back.unitOrthogonal();
  Eigen::Matrix4f view = Eigen::Matrix4f::Identity();
  view.block<1, 3>(0, 0) = right.transpose();
  view.block<1, 3>(1, 0) = back.cross(right).transpose();
  view.block<1, 3>(2, 0) = back.transpose();
  view(2, 3) = -distance;
  return projection * view;
}

/// Each triangle as a mesh of its own.
class Apart {
 public:
  explicit Apart(const Mesh& mesh) {
    for (const auto& [a, b, c] : mesh.triangles) {
      Mesh one;
      one.positions = {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
      one.triangles = {{0, 1, 2}};
      meshes_.push_back(std::move(one));
    }
    for (const Mesh& one : meshes_) prepared_.emplace_back(one);
  }

  /// Per pixel, how many triangles cover it.
  Image<int> layers(const Eigen::Matrix4f& matrix, Cull cull, Renderer& renderer) const {
    Image<int> count(width, height, 0);
    Framebuffer frame(width, height);
    for (const PreparedMesh& one : prepared_) {
      frame.clear();
      renderer.draw({.mesh = &one, .matrix = matrix, .cull = cull}, frame);
      const Image<std::int32_t> ids = frame.ids();
      for (std::size_t i = 0; i < ids.pixels().size(); ++i) {
        count.pixels()[i] += ids.pixels()[i] == 0 ? 1 : 0;
      }
    }
    return count;
  }

 private:
  std::vector<Mesh> meshes_;
  std::vector<PreparedMesh> prepared_;
};

Image<std::int32_t> ids_of(const Mesh& mesh, const Eigen::Matrix4f& matrix, Renderer& renderer) {
  const PreparedMesh prepared(mesh);
  Framebuffer frame(width, height);
  renderer.draw({.mesh = &prepared, .matrix = matrix}, frame);
  return frame.ids();
}

/// Calls `check(matrix)` for views from every corner, edge and face of a cube about the origin.
template <class Check>
void from_every_side(float distance, const Check& check) {
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        SCOPED_TRACE(testing::Message() << "from (" << x << ", " << y << ", " << z << ")");
        check(perspective_from(
            Eigen::Vector3f(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)),
            distance));
      }
    }
  }
}

/// Whoever enters a closed surface leaves it again.
void expect_as_many_fronts_as_backs(const char* shape, int most_layers) {
  SCOPED_TRACE(shape);
  const Mesh mesh = make_shape(shape);
  const Apart apart(mesh);
  Renderer renderer({.threads = 1, .skip = {}});
  from_every_side(3.2F, [&](const Eigen::Matrix4f& matrix) {
    const Image<int> fronts = apart.layers(matrix, Cull::back, renderer);
    const Image<int> backs = apart.layers(matrix, Cull::front, renderer);
    EXPECT_EQ(fronts, backs);
    EXPECT_THAT(fronts.pixels(), testing::Contains(testing::Ge(1)));
    EXPECT_THAT(fronts.pixels(), testing::Each(testing::Le(most_layers)));
    const Image<std::int32_t> ids = ids_of(mesh, matrix, renderer);
    for (std::size_t i = 0; i < ids.pixels().size(); ++i) {
      ASSERT_EQ(ids.pixels()[i] >= 0, fronts.pixels()[i] > 0) << "pixel " << i;
    }
  });
}

TEST(engine_layers, convex_meshes_have_one_front_and_one_back) {
  for (const char* shape : {"cube:3", "icosphere:2", "uv_sphere:12"}) {
    expect_as_many_fronts_as_backs(shape, 1);
  }
}

TEST(engine_layers, a_ring_has_as_many_fronts_as_backs) {
  expect_as_many_fronts_as_backs("torus:9", 2);
}

/// Between a convex mesh's leftmost and rightmost pixel of a row there is no hole.
TEST(engine_layers, convex_meshes_have_no_holes) {
  Renderer renderer({.threads = 1, .skip = {}});
  for (const char* shape : {"cube:3", "icosphere:2", "uv_sphere:40"}) {
    SCOPED_TRACE(shape);
    const Mesh mesh = make_shape(shape);
    from_every_side(2.6F, [&](const Eigen::Matrix4f& matrix) {
      const Image<std::int32_t> ids = ids_of(mesh, matrix, renderer);
      for (int y = 0; y < height; ++y) {
        int changes = 0;
        for (int x = 1; x < width; ++x) changes += (ids(x, y) < 0) != (ids(x - 1, y) < 0) ? 1 : 0;
        ASSERT_LE(changes, 2) << "row " << y;
      }
    });
  }
}

}  // namespace
}  // namespace rasterlab
