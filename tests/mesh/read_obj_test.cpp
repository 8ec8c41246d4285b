#include "tests/mesh/read_helpers.h"

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using Vector = Eigen::Vector3f;
using Uv = Eigen::Vector2f;
using Triangle = Mesh::Triangle;

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(stage01_read_obj, positions_and_faces) {
  const Mesh mesh = read_as("a.obj", square + "f 1 2 3\nf 1 3 4\n");
  EXPECT_THAT(mesh.positions,
              ElementsAre(Vector(0, 0, 0), Vector(1, 0, 0), Vector(1, 1, 0), Vector(0, 1, 0)));
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
  EXPECT_THAT(mesh.normals, IsEmpty());
  EXPECT_THAT(mesh.texture_coordinates, IsEmpty());
  EXPECT_THAT(mesh.colors, IsEmpty());
}

TEST(stage01_read_obj, a_seam_splits_only_its_vertices) {
  // The middle edge 2-3 has u = 1 on its left and u = 0 on its right.
  const Mesh mesh = read_as("a.obj",
                            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n"
                            "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                            "f 1/1 2/2 3/3 4/4\nf 2/1 5/2 6/3 3/4\n");
  ASSERT_THAT(mesh.positions, SizeIs(8));
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) {
      const float u = mesh.texture_coordinates[vertex].x();
      const float x = mesh.positions[vertex].x();
      EXPECT_TRUE(x == u || x == u + 1) << "smeared";
    }
  }
  EXPECT_EQ(mesh.texture_coordinates[1], Uv(1, 0)) << "the first side of a seam keeps the place";
}

TEST(stage01_read_obj, equal_values_under_different_numbers_split_nothing) {
  const Mesh mesh = read_as("a.obj", square +
                                         "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 0\nvt 1 1\nvt 0 1\n"
                                         "vn 0 0 1\nvn 0 0 2\n"
                                         "f 1/1/1 2/2/1 3/3/1\nf 1/4/2 3/5/2 4/6/2\n");
  EXPECT_THAT(mesh.positions, SizeIs(4));
  EXPECT_THAT(mesh.normals, Each(Vector(0, 0, 1)));
}

TEST(stage01_read_obj, normals_of_the_file_win_and_belong_to_corners) {
  // A fold: each side has its own normal along the common edge, and neither is the face's.
  const Mesh mesh = read_as("a.obj",
                            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nvn 1 0 0\nvn 0 3 4\n"
                            "f 1//1 2//1 3//1\nf 2//2 4//2 3//2\n");
  ASSERT_THAT(mesh.positions, SizeIs(6));
  for (const std::uint32_t vertex : mesh.triangles[0])
    EXPECT_EQ(mesh.normals[vertex], Vector(1, 0, 0));
  for (const std::uint32_t vertex : mesh.triangles[1]) {
    EXPECT_EQ(mesh.normals[vertex], Vector(0, 0.6F, 0.8F));
  }
}

TEST(stage01_read_obj, missing_normals_are_filled_in) {
  const Mesh mesh = read_as("a.obj", square + "vn 1 0 0\nvn 0 0 0\nf 1//1 2//2 3\nf 1//1 3 4\n");
  EXPECT_THAT(mesh.normals,
              ElementsAre(Vector(1, 0, 0), Vector(0, 0, 1), Vector(0, 0, 1), Vector(0, 0, 1)));
}

TEST(stage01_read_obj, missing_texture_coordinates_are_zero) {
  const Mesh mesh = read_as("a.obj", square + "vt 0.5 1.5\nf 1/1 2/1 3/1\nf 1/1 3/1 4\n");
  EXPECT_THAT(mesh.texture_coordinates,
              ElementsAre(Uv(0.5, 1.5), Uv(0.5, 1.5), Uv(0.5, 1.5), Uv(0, 0)));
}

TEST(stage01_read_obj, negative_indices_count_from_where_they_stand) {
  const Mesh mesh =
      read_as("a.obj",
              "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nf -3/-3 -2/-2 -1/-1\n"
              "v 5 5 5\nv 6 5 5\nv 6 6 5\nf -3/-1 -2/-1 -1/-1\n");
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{3, 4, 5}));
  EXPECT_EQ(mesh.positions[3], Vector(5, 5, 5));
}

TEST(stage01_read_obj, vertices_may_follow_their_faces) {
  const Mesh mesh = read_as("a.obj", "f 1/1/1 2/1/1 3/1/1\n" + square + "vt 1 0\nvn 0 1 0\n");
  EXPECT_EQ(mesh.positions[1], Vector(1, 0, 0));
  EXPECT_THAT(mesh.normals, Each(Vector(0, 1, 0)));
}

TEST(stage01_read_obj, polygons_keep_their_attributes) {
  const Mesh mesh =
      read_as("a.obj",
              "v 0 0 0\nv 2 -1 0\nv 0.5 0 0\nv 2 1 0\nvt 1 1\nvt 2 2\nvt 3 3\nvt 4 4\n"
              "f 1/1 2/2 3/3 4/4\n");
  EXPECT_THAT(mesh.triangles, SizeIs(2));
  EXPECT_THAT(mesh.texture_coordinates, ElementsAre(Uv(1, 1), Uv(2, 2), Uv(3, 3), Uv(4, 4)));
  for (const Triangle& t : mesh.triangles) {
    const Vector normal = (mesh.positions[t[1]] - mesh.positions[t[0]])
                              .cross(mesh.positions[t[2]] - mesh.positions[t[0]]);
    EXPECT_GT(normal.z(), 0) << "a concave polygon was cut across its notch";
  }
}

TEST(stage01_read_obj, faces_that_are_not_manifold_are_kept) {
  // Three faces on one edge, one face twice, one backwards.
  const Mesh mesh =
      read_as("a.obj", square + "v 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 2 5\nf 1 2 3\nf 3 2 1\n");
  EXPECT_THAT(mesh.triangles, SizeIs(5));
  EXPECT_THAT(mesh.positions, SizeIs(5));
}

TEST(stage01_read_obj, layout_of_the_text_does_not_matter) {
  const std::string plain = square + "vt 0 0\nvt 1 1\nf 1/1 2/2 3/1\nf 1/1 3/1 4/2\n";
  const Mesh expected = read_as("a.obj", plain);
  std::string crlf = plain;
  replace_all(crlf, "\n", "\r\n");
  std::string tabs = plain;
  replace_all(tabs, " ", "\t \t");
  replace_all(tabs, "\n", " \t\n\t");
  std::string continued = plain;
  replace_all(continued, " 3/1", " \\\n3/1");
  replace_all(continued, "v 1 0", "v 1 \\\r\n 0");
  const std::string unfinished = plain.substr(0, plain.size() - 1);
  const std::string commented = "# c:\\folder\\\n" + plain + "# end\\";
  for (const std::string& text :
       {crlf, tabs, continued, unfinished, commented, "\xEF\xBB\xBF" + plain}) {
    const Mesh mesh = read_as("a.obj", text);
    EXPECT_EQ(mesh.positions, expected.positions) << text;
    EXPECT_EQ(mesh.texture_coordinates, expected.texture_coordinates);
    EXPECT_EQ(mesh.triangles, expected.triangles);
  }
}

TEST(stage01_read_obj, what_is_no_geometry_is_passed_over_in_silence) {
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  const Mesh mesh =
      read_as("a.obj", "mtllib missing.mtl\no thing\ng part\nusemtl none\ns off\n" + square +
                           "l 1 2\np 3\nvp 0.5\ncurv2 1 2\nf 1 2 3\nf 1 2\nf 4\n");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_THAT(mesh.triangles, SizeIs(1));
}

TEST(stage01_read_obj, numbers_in_every_notation) {
  const Mesh mesh =
      read_as("a.obj", "v +1 -.5 2.\nv 1e2 +2.E-1 -3e+1\nv 1e-50 0 -1e-46\nf 1 2 3\n");
  EXPECT_THAT(mesh.positions,
              ElementsAre(Vector(1, -0.5, 2), Vector(100, 0.2F, -30), Vector(0, 0, 0)));
}

TEST(stage01_read_obj, colours_after_the_position) {
  const Mesh mesh = read_as(
      "a.obj", "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0\nv 1 1 0 1 0.5 0.25\nf 1 2 3\nf 2 4 3\n");
  EXPECT_THAT(mesh.colors,
              ElementsAre(Vector(1, 0, 0), Vector(0, 1, 0), Vector(1, 1, 1), Vector(1, 0.5, 0.25)));
  const Mesh bytes =
      read_as("a.obj", "v 0 0 0 255 0 0\nv 1 0 0 0 255 0\nv 0 1 0 0 0 51\nf 1 2 3\n");
  EXPECT_THAT(bytes.colors, ElementsAre(Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 0.2F)));
  const Mesh with_w = read_as("a.obj", "v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n");
  EXPECT_THAT(with_w.colors, IsEmpty());
}

TEST(stage01_read_obj, refusals_name_the_line) {
  EXPECT_EQ(refusal("a.obj", square + "f 1 2 3\nf 1 2 9\n# end\n"),
            "a.obj:6: a face refers to vertex 9; the file has 4");
  EXPECT_EQ(refusal("a.obj", square + "vt 0 0\nf 1/1 2/1 3/2\n"),
            "a.obj:6: a face refers to texture coordinate 2; the file has 1");
  EXPECT_EQ(refusal("a.obj", square + "f 1//1 2//1 3//1\n"),
            "a.obj:5: a face refers to normal 1; the file has 0");
  EXPECT_THAT(refusal("a.obj", square + "f 0 1 2\n"),
              HasSubstr("a.obj:5: a face refers to vertex 0"));
  EXPECT_THAT(refusal("a.obj", square + "f -5 1 2\n"),
              HasSubstr("a.obj:5: a face refers to vertex -5"));
  EXPECT_THAT(refusal("a.obj", square + "f 99999999999 1 2\n"), HasSubstr("a.obj:5: "));
  EXPECT_THAT(refusal("a.obj", square + "f 99999999999999999999 1 2\n"), HasSubstr("a.obj:5: "));
  EXPECT_THAT(refusal("a.obj", square + "f one two three\n"),
              HasSubstr("a.obj:5: 'one' is no corner"));
  EXPECT_THAT(refusal("a.obj", square + "f /1 /2 /3\n"), HasSubstr("a.obj:5: '/1' is no corner"));
  EXPECT_THAT(refusal("a.obj", square + "f //1 //1 //1\n"),
              HasSubstr("a.obj:5: '//1' is no corner"));
  EXPECT_THAT(refusal("a.obj", square + "f\n"), HasSubstr("a.obj:5: a face without corners"));
  EXPECT_EQ(refusal("a.obj", "v 0 0\n"), "a.obj:1: three coordinates of a vertex expected");
  EXPECT_EQ(refusal("a.obj", "v 0 0 1,5\n"), "a.obj:1: '1,5' is not a number");
  EXPECT_THAT(refusal("a.obj", square), HasSubstr("a.obj: there is no face"));
  EXPECT_THAT(refusal("a.obj", "v 0 0 \\\n0 \\\nx\n"), HasSubstr("a.obj:1: "));
}

TEST(stage01_read_obj, strange_words_do_not_spoil_the_message) {
  const std::string word(5000, 'x');
  const std::string message = refusal("a.obj", "v 0 0 \x1b[31m" + word + "\n");
  EXPECT_EQ(message.find('\x1b'), std::string::npos);
  EXPECT_LT(message.size(), 200U);
}

}  // namespace
}  // namespace rasterlab
