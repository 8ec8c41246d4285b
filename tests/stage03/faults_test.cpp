// What exercise 03.5 counts, and exercise 03.6.
#include "common/mesh/shapes.h"
#include "common/triangles/draw_flat_faces.h"
#include "common/zbuffer/draw_flat_depth.h"
#include "common/zbuffer/visibility_faults.h"

#include "tests/oracle/exact_visibility.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterlab {
namespace {

TEST(stage03_visibility_faults, nothing_is_wrong_with_the_truth) {
  const VisibilityScene scene = piercing_triangles();
  const VisibleTriangles truth = oracle::exactly_seen(scene);
  const VisibilityFaults faults = visibility_faults(truth, scene);
  EXPECT_EQ(faults.wrong, 0);
  EXPECT_EQ(faults.covered, std::count_if(truth.pixels().begin(), truth.pixels().end(),
                                          [](int i) { return i >= 0; }));
}

TEST(stage03_visibility_faults, counts_what_differs_from_the_truth) {
  const VisibilityScene scene = piercing_triangles();
  const VisibleTriangles truth = oracle::exactly_seen(scene);
  for (const VisibilityRung& rung : visibility_ladder) {
    const VisibleTriangles seen = rung.seen(scene);
    std::int64_t different = 0;
    for (std::size_t i = 0; i < seen.pixels().size(); ++i)
      different += seen.pixels()[i] != truth.pixels()[i] ? 1 : 0;
    EXPECT_EQ(visibility_faults(seen, scene).wrong, different) << rung.name;
  }
}

TEST(stage03_visibility_faults, an_empty_picture_misses_all) {
  const VisibilityScene scene = piercing_triangles();
  const VisibilityFaults faults =
      visibility_faults(VisibleTriangles(scene.width, scene.height, -1), scene);
  EXPECT_GT(faults.covered, 0);
  EXPECT_EQ(faults.wrong, faults.covered);
}

TEST(stage03_visibility_faults, finer_buffers_confuse_fewer_pairs) {
  double coarse = 0;
  double fine = 0;
  for (const double distance : {1.0, 100.0, 10000.0}) {
    coarse += wrong_share_of_pair(&seen_by_zbuffer_16, distance, 1e-4);
    fine += wrong_share_of_pair(&seen_by_zbuffer_reversed, distance, 1e-4);
  }
  EXPECT_GT(coarse, 0) << "16 bit cannot tell a gap of 1/10000 far away";
  EXPECT_EQ(fine, 0) << "reversed float can, at every distance";
}

TEST(stage03_draw_flat_depth, the_nearer_face_wins_in_any_order) {
  Mesh mesh;  // two squares' halves facing the viewer, the second behind the first and brighter
  mesh.positions = {{-1, -1, 0.5F},  {1, -1, 0.5F},  {-1, 1, -0.7F},
                    {-1, -1, -0.8F}, {1, -1, -0.8F}, {-1, 1, -0.8F}};
  for (const bool near_first : {true, false}) {
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
    if (!near_first) std::swap(mesh.triangles[0], mesh.triangles[1]);
    Image<Rgb8> image(16, 16);
    DepthBuffer depth(16, 16);
    draw_flat_depth(image, depth, mesh);
    EXPECT_LT(image(2, 12).r, 255)
        << "the tilted face is nearer and darker; drawn first: " << near_first;
    EXPECT_NEAR(depth.depths()(0, 15), -0.5, 0.08) << "the depth is -z of the nearer face";
  }
}

TEST(stage03_draw_flat_depth, as_bright_as_without_depth_where_nothing_overlaps) {
  const Mesh wall = make_shape("wall:3");
  Image<Rgb8> with(20, 20);
  DepthBuffer depth(20, 20);
  draw_flat_depth(with, depth, wall);
  Image<Rgb8> without(20, 20);
  draw_flat_faces(without, wall);
  EXPECT_EQ(with, without);
}

TEST(stage03_draw_flat_depth, outside_the_depth_range_is_left_out) {
  Mesh wall = make_shape("wall:1");
  for (Eigen::Vector3f& position : wall.positions) position.z() = -1.5F;
  Image<Rgb8> image(8, 8);
  DepthBuffer depth(8, 8);
  draw_flat_depth(image, depth, wall);
  EXPECT_EQ(image, Image<Rgb8>(8, 8)) << "z = -1.5 is behind the far plane, depth 1.5";
}

TEST(stage03_draw_flat_depth, faces_turned_away_are_left_out) {
  Mesh wall = make_shape("wall:1");
  for (Mesh::Triangle& triangle : wall.triangles) std::swap(triangle[0], triangle[1]);
  Image<Rgb8> image(8, 8);
  DepthBuffer depth(8, 8);
  draw_flat_depth(image, depth, wall);
  EXPECT_EQ(image, Image<Rgb8>(8, 8));
}

TEST(stage03_draw_flat_depth, faces_that_are_none_are_left_out) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const Eigen::Vector3f& corner :
       {Eigen::Vector3f(1, -1, 0), {0.5F, -1, 0}, {1e30F, 1, 0}, {0, nan, 0}, {0, 1, nan}}) {
    Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, corner};
    mesh.triangles = {{0, 1, 2}};
    Image<Rgb8> image(8, 8);
    DepthBuffer depth(8, 8);
    EXPECT_NO_THROW(draw_flat_depth(image, depth, mesh));
    EXPECT_EQ(image, Image<Rgb8>(8, 8))
        << "a face with a corner at (" << corner.transpose() << ") has no area, or no place";
  }
}

}  // namespace
}  // namespace rasterlab
