// Exercises 02.6 and 02.7.
#include "common/mesh/shapes.h"
#include "common/triangles/draw_flat_faces.h"
#include "common/triangles/draw_random_faces.h"
#include "common/triangles/fill_faults.h"

#include "tests/oracle/exact_triangle.h"
#include "tests/support/picture_text.h"

#include <limits>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterlab {
namespace {

double total(const FillFaults& faults) {
  return faults.missing + faults.extra + faults.doubled + faults.order + faults.translation +
         faults.rotation;
}

TEST(stage02_fill_faults, exact_rung_has_none) {
  for (const TriangleSample& sample : fill_samples()) {
    EXPECT_EQ(total(fill_faults(fill_ladder.back().fill, sample)), 0) << sample.name;
  }
}

TEST(stage02_fill_faults, every_other_rung_has_some) {
  for (const FillRung& rung : fill_ladder) {
    if (&rung == &fill_ladder.back()) continue;
    double worst = 0;
    for (const TriangleSample& sample : fill_samples())
      worst = std::max(worst, total(fill_faults(rung.fill, sample)));
    EXPECT_GT(worst, 0) << rung.name << "'s known fault must show: " << rung.known_fault;
  }
}

TEST(stage02_fill_faults, exact_coverage_is_the_oracles) {
  for (const TriangleSample& sample : fill_samples()) {
    std::vector<oracle::GridTriangle> grid;
    for (const Corners& corners : sample.triangles) grid.push_back(oracle::to_grid(corners));
    if (grid.size() > 3000) grid.resize(3000);
    TriangleSample part = sample;
    part.triangles.resize(grid.size());
    EXPECT_EQ(exact_coverage(part), oracle::coverage(grid, sample.size, sample.size))
        << sample.name;
  }
}

TEST(stage02_fill_faults, counts_what_is_wrong) {
  const TriangleSample square{"square", 8, {Corners{{{1, 1}, {5, 1}, {1, 5}}}}};
  const auto nothing = [](Image<Rgb8>&, const Corners&, const Rgb8&) {};
  EXPECT_EQ(fill_faults(nothing, square).missing, 1e6)
      << "drawing nothing misses a million of a million";
  const auto one_more = [](Image<Rgb8>& image, const Corners& corners, const Rgb8& color) {
    fill_ladder.back().fill(image, corners, color);
    image(5, 5) = color;
  };
  EXPECT_EQ(fill_faults(one_more, square).missing, 0);
  EXPECT_GT(fill_faults(one_more, square).extra, 0) << "a pixel outside is extra";
}

TEST(stage02_fill_faults, picture_names_faults_by_colour) {
  Coverage drawn(4, 1);
  Coverage exact(4, 1);
  drawn(1, 0) = 1, exact(1, 0) = 1;
  exact(2, 0) = 1;
  drawn(3, 0) = 2, exact(3, 0) = 1;
  drawn(0, 0) = 1;
  const Image<Rgb8> picture = fault_picture(drawn, exact);
  EXPECT_EQ(picture(1, 0), (Rgb8{255, 255, 255})) << "right";
  EXPECT_GT(picture(2, 0).r, picture(2, 0).b) << "missing is red";
  EXPECT_GT(picture(0, 0).b, picture(0, 0).r) << "extra is blue";
  EXPECT_GT(picture(3, 0).g, picture(3, 0).b) << "doubled is yellow";
}

Mesh two_faces() {
  Mesh mesh;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TEST(stage02_draw_random_faces, fills_every_face) {
  Image<Rgb8> image(16, 16);
  draw_random_faces(image, two_faces(), 1);
  std::set<std::tuple<int, int, int>> colors;
  for (const Rgb8& pixel : image.pixels()) colors.insert({pixel.r, pixel.g, pixel.b});
  EXPECT_EQ(colors.size(), 2U) << "two faces fill [-1, 1]² without a gap, each in its colour";
}

TEST(stage02_draw_random_faces, seed_decides) {
  const Mesh sphere = make_shape("icosphere", 3);
  Image<Rgb8> first(40, 40);
  draw_random_faces(first, sphere, 1);
  Image<Rgb8> again(40, 40);
  draw_random_faces(again, sphere, 1);
  EXPECT_EQ(first, again) << "the same seed gives the same picture";
  Image<Rgb8> other(40, 40);
  draw_random_faces(other, sphere, 2);
  EXPECT_NE(first, other) << "another seed gives other colours";
}

TEST(stage02_draw_flat_faces, intensity) {
  EXPECT_EQ(flat_intensity({0, 0, 1}), 1) << "a face toward the viewer is fully lit";
  EXPECT_EQ(flat_intensity({0, 0, -1}), 0)
      << "a face turned away gets nothing, not a negative amount";
  EXPECT_NEAR(flat_intensity({0, 0.6F, 0.8F}), 0.8, 1e-6);
  EXPECT_EQ(flat_intensity({1, 0, 0}), 0);
}

TEST(stage02_draw_flat_faces, grey_by_slope) {
  Mesh mesh = two_faces();
  for (Eigen::Vector3f& p : mesh.positions) p.z() = 0.75F * p.x();  // normal (−0.6, 0, 0.8)
  Image<Rgb8> image(8, 8);
  draw_flat_faces(image, mesh);
  for (const Rgb8& pixel : image.pixels()) {
    ASSERT_NEAR(pixel.r, 0.8 * 255, 1);
    ASSERT_EQ(pixel.r, pixel.g);
    ASSERT_EQ(pixel.r, pixel.b);
  }
}

TEST(stage02_draw_flat_faces, faces_turned_away_are_left_out) {
  Mesh mesh = two_faces();
  std::swap(mesh.triangles[0][1], mesh.triangles[0][2]);
  Image<Rgb8> image(8, 8, {0, 0, 7});
  draw_flat_faces(image, mesh);
  EXPECT_EQ(image(6, 6), (Rgb8{0, 0, 7})) << "the background shows where the face is turned away";
  EXPECT_EQ(image(1, 1), (Rgb8{255, 255, 255}));
}

/// A face without area, or with a corner too far or not a number, and one as large as the window.
Mesh good_face_after(const Eigen::Vector3f& corner) {
  Mesh mesh;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, corner, {3, -1, 0}, {-1, 3, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 4}, {0, 1, 2}};
  return mesh;
}

TEST(stage02_draw_flat_faces, faces_that_are_none_are_left_out) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const Eigen::Vector3f& corner :
       {Eigen::Vector3f(1, -1, 0), {0.5F, -1, 0}, {1e30F, 1, 0}, {nan, 0, 0}, {0, nan, 0}}) {
    const Mesh mesh = good_face_after(corner);
    Image<Rgb8> flat(8, 8);
    draw_flat_faces(flat, mesh);
    EXPECT_EQ(flat, Image<Rgb8>(8, 8, {255, 255, 255}))
        << "a face with a corner at (" << corner.transpose() << ") has no area, or no place";
    Image<Rgb8> random(8, 8);
    draw_random_faces(random, mesh, 1);
    EXPECT_EQ(random, Image<Rgb8>(8, 8, random(0, 0)))
        << "a face with a corner at (" << corner.transpose() << ") has no area, or no place";
    EXPECT_NE(random(0, 0), Rgb8{}) << "and the others are drawn";
  }
}

TEST(stage02_draw_flat_faces, later_faces_cover_earlier_ones) {
  Mesh mesh = two_faces();
  mesh.positions[3] = {1, -1, 2};  // the second face, over the first, is steep and dark
  std::swap(mesh.triangles[1][1], mesh.triangles[1][2]);
  Image<Rgb8> image(8, 8);
  draw_flat_faces(image, mesh);
  const Rgb8 seen = image(5, 5);
  std::swap(mesh.triangles[0], mesh.triangles[1]);
  draw_flat_faces(image, mesh);
  EXPECT_NE(image(5, 5), seen) << "what is drawn last is seen";
}

}  // namespace
}  // namespace rasterlab
