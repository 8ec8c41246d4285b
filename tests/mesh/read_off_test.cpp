#include "tests/mesh/read_helpers.h"

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using Vector = Eigen::Vector3f;
using Uv = Eigen::Vector2f;
using Triangle = Mesh::Triangle;

const Vector red(1, 0, 0);
const Vector green(0, 1, 0);
const Vector blue(0, 0, 1);

// ---- Course C: the header says nothing of colours and texture coordinates.

TEST(stage01_read_off, course_c_colours_are_not_dropped) {
  const Mesh mesh =
      read_as("c.off", "OFF\n3 1 0\n0 0 0 1 0 0\n1 0 0 0 1 0\n0 1 0 0 0 1\n3 0 1 2\n");
  EXPECT_THAT(mesh.positions, ElementsAre(Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0)));
  EXPECT_THAT(mesh.colors, ElementsAre(red, green, blue));
  EXPECT_THAT(mesh.texture_coordinates, IsEmpty());
  EXPECT_THAT(mesh.normals, IsEmpty());
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}));
}

TEST(stage01_read_off, course_c_colours_and_texture_coordinates) {
  const Mesh mesh = read_as("c.off",
                            "OFF\n3 1 0\n0 0 0 0.5 0.25 0 0 0\n1 0 0 0 1 0 10 0\n"
                            "0 1 0 0 0 1 0.5 7.5\n3 0 1 2\n");
  EXPECT_THAT(mesh.colors, ElementsAre(Vector(0.5, 0.25, 0), green, blue));
  EXPECT_THAT(mesh.texture_coordinates, ElementsAre(Uv(0, 0), Uv(10, 0), Uv(0.5, 7.5)));
}

TEST(stage01_read_off, columns_of_whole_numbers_are_no_bytes) {
  // OpenMesh takes the integers of an STCOFF for 0…255: 1 became 0.0039.
  const Mesh mesh = read_as("c.off",
                            "STCOFF\n3 1 0\n0 0 0 1 0 0 0 0\n1 0 0 0 1 0 1 0\n"
                            "0 1 0 1 1 1 0 1\n3 0 1 2\n");
  EXPECT_THAT(mesh.colors, ElementsAre(red, green, Vector(1, 1, 1)));
  EXPECT_THAT(mesh.texture_coordinates, ElementsAre(Uv(0, 0), Uv(1, 0), Uv(0, 1)));
}

TEST(stage01_read_off, comments_and_blank_lines_anywhere) {
  const std::string plain = "OFF\n3 1 0\n0 0 0 1 0 0\n1 0 0 0 1 0\n0 1 0 0 0 1\n3 0 1 2\n";
  const std::string commented =
      "# first\n\n  # second\nOFF # header\n#\n3 1 0 # counts\n\n# vertices\n0 0 0 1 0 0#glued\n"
      "\t1 0 0\t0 1 0  \n   \n0 1 0 0 0 1\n# faces\n3 0 1 2 # last\n# end";
  const Mesh expected = read_as("a.off", plain);
  const Mesh mesh = read_as("b.off", commented);
  EXPECT_EQ(mesh.positions, expected.positions);
  EXPECT_EQ(mesh.colors, expected.colors);
  EXPECT_EQ(mesh.triangles, expected.triangles);
}

TEST(stage01_read_off, line_ends) {
  const std::string lf = "OFF\n3 1 0\n0 0 0 1 0 0\n1 0 0 0 1 0\n0 1 0 0 0 1\n3 0 1 2";
  for (const char* const end : {"\n", "\r\n", "\r"}) {
    for (const char* const last : {"", end}) {
      std::string text = lf + last;
      replace_all(text, "\n", end);
      const Mesh mesh = read_as("c.off", text);
      EXPECT_THAT(mesh.colors, ElementsAre(red, green, blue));
      EXPECT_THAT(mesh.triangles, SizeIs(1));
    }
  }
}

// ---- The standard's headers

const std::string faces = "3 0 1 2\n";

TEST(stage01_read_off, off) {
  const Mesh mesh = read_as("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n" + faces);
  EXPECT_THAT(mesh.positions, SizeIs(3));
  EXPECT_THAT(mesh.colors, IsEmpty());
}

TEST(stage01_read_off, coff_of_floats_and_of_bytes) {
  const Mesh floats =
      read_as("a.off", "COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 0 1 0 1\n0 1 0 0 0 1 .5\n" + faces);
  EXPECT_THAT(floats.colors, ElementsAre(red, green, blue));
  const Mesh bytes = read_as(
      "a.off", "COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0 255 0 255\n0 1 0 51 0 255 0\n" + faces);
  EXPECT_THAT(bytes.colors, ElementsAre(red, green, Vector(0.2F, 0, 1)));
  const Mesh without_alpha =
      read_as("a.off", "COFF\n3 1 0\n0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n" + faces);
  EXPECT_THAT(without_alpha.colors, ElementsAre(red, green, blue));
}

TEST(stage01_read_off, a_float_barely_above_one_is_clamped) {
  const Mesh mesh =
      read_as("a.off", "OFF\n3 1 0\n0 0 0 1.001 0 0\n1 0 0 0 1 0\n0 1 0 0 0 .5\n" + faces);
  EXPECT_THAT(mesh.colors, ElementsAre(red, green, Vector(0, 0, 0.5)));
}

TEST(stage01_read_off, noff_normals_are_made_unit) {
  const Mesh mesh =
      read_as("a.off", "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 -3\n0 1 0 4 3 0\n" + faces);
  EXPECT_THAT(mesh.normals, ElementsAre(Vector(0, 0, 1), Vector(0, 0, -1), Vector(0.8F, 0.6F, 0)));
  EXPECT_THAT(mesh.colors, IsEmpty());
}

TEST(stage01_read_off, all_at_once) {
  const Mesh mesh =
      read_as("a.off",
              "STCN4OFF 3 1 3\n0 0 0 2 0 0 1 1 0 0 .5 0 1\n2 0 0 2 0 0 1 0 1 0 .5 1 1\n"
              "0 2 0 2 0 0 1 0 0 1 .5 0 0\n" +
                  faces);
  EXPECT_THAT(mesh.positions, ElementsAre(Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0)));
  EXPECT_THAT(mesh.normals, testing::Each(Vector(0, 0, 1)));
  EXPECT_THAT(mesh.colors, ElementsAre(red, green, blue));
  EXPECT_THAT(mesh.texture_coordinates, ElementsAre(Uv(0, 1), Uv(1, 1), Uv(0, 0)));
}

TEST(stage01_read_off, stoff) {
  const Mesh mesh = read_as("a.off", "STOFF\n3 1 0\n0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n" + faces);
  EXPECT_THAT(mesh.texture_coordinates, ElementsAre(Uv(0, 0), Uv(1, 0), Uv(0, 1)));
  EXPECT_THAT(mesh.colors, IsEmpty());
}

TEST(stage01_read_off, counts_in_odd_places) {
  const std::string rest = "0 0 0\n1 0 0\n0 1 0\n" + faces;
  for (const char* const start : {"OFF 3 1 0\n", "OFF3 1 0\n", "3 1 0\n", "OFF\n3 1\n",
                                  "OFF\n3\n1\n", "\xEF\xBB\xBFOFF\n3 1 0\n"}) {
    EXPECT_THAT(read_as("a.off", start + rest).positions, SizeIs(3)) << start;
  }
}

TEST(stage01_read_off, lines_may_end_anywhere) {
  const Mesh one_line = read_as("a.off", "OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2");
  EXPECT_THAT(one_line.positions, ElementsAre(Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0)));
  const Mesh two_a_line =
      read_as("a.off", "OFF\n4 2 0\n0 0 0 1 0 0\n0 1 0 1 1 0\n3 0 1 2 3 1 3 2\n");
  EXPECT_THAT(two_a_line.positions, SizeIs(4));
  EXPECT_THAT(two_a_line.colors, IsEmpty());
  EXPECT_THAT(two_a_line.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{1, 3, 2}));
  const Mesh broken_vertex =
      read_as("a.off", "COFF\n3 1 0\n0 0 0\n1 0 0 1\n1 0 0\n0 1 0 1\n0 1 0\n0 0 1 1\n3 0 1\n2\n");
  EXPECT_THAT(broken_vertex.colors, ElementsAre(red, green, blue));
}

// ---- Faces

TEST(stage01_read_off, polygons_become_triangles) {
  const Mesh mesh =
      read_as("a.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n2 1 0\n1 2 0\n0 1 0\n5 0 1 2 3 4\n4 0 2 3 4\n");
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{0, 3, 4},
                                          Triangle{0, 2, 3}, Triangle{0, 3, 4}));
}

TEST(stage01_read_off, coloured_faces_split_their_vertices) {
  const Mesh mesh = read_as(
      "a.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2 255 0 0\n3 1 3 2 0 255 0\n");
  ASSERT_THAT(mesh.positions, SizeIs(6));
  for (const std::uint32_t vertex : mesh.triangles[0]) EXPECT_EQ(mesh.colors[vertex], red);
  for (const std::uint32_t vertex : mesh.triangles[1]) EXPECT_EQ(mesh.colors[vertex], green);
}

TEST(stage01_read_off, colours_of_vertices_win_over_those_of_faces) {
  const Mesh mesh =
      read_as("a.off", "OFF\n3 1 0\n0 0 0 1 0 0\n1 0 0 0 1 0\n0 1 0 0 0 1\n3 0 1 2 1 1 1\n");
  EXPECT_THAT(mesh.colors, ElementsAre(red, green, blue));
}

TEST(stage01_read_off, points_and_edges_are_left_out) {
  const Mesh mesh = read_as("a.off", "OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n1 0\n2 0 1\n3 0 1 2\n");
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}));
}

TEST(stage01_read_off, unused_vertices_are_left_out) {
  const Mesh mesh = read_as("a.off", "OFF\n5 1 0\nnan 0 0\n0 0 0\n9 9 9\n1 0 0\n0 1 0\n3 1 3 4\n");
  EXPECT_THAT(mesh.positions, ElementsAre(Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0)));
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}));
}

// ---- Binary

std::string binary(std::endian order, bool colors, bool colored_faces, bool whole_numbers) {
  std::string bytes = colors ? "COFF BINARY\n" : "OFF BINARY\n";
  for (const std::uint32_t count : {4U, 2U, 0U}) append(bytes, count, order);
  const std::vector<Vector> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  for (const Vector& position : positions) {
    for (const float x : position) append(bytes, x, order);
    const std::size_t numbers = colors ? (order == std::endian::big ? 4 : 3) : 0;
    for (std::size_t i = 0; i < numbers; ++i) {
      const float value = i == 3 ? 1 : (position + blue)[static_cast<Eigen::Index>(i)];
      if (whole_numbers) {
        append(bytes, static_cast<std::uint32_t>(255 * value), order);
      } else {
        append(bytes, value, order);
      }
    }
  }
  for (const Triangle& triangle : {Triangle{0, 1, 2}, Triangle{1, 3, 2}}) {
    append(bytes, 3U, order);
    for (const std::uint32_t vertex : triangle) append(bytes, vertex, order);
    if (order == std::endian::big) append(bytes, colored_faces ? 3U : 0U, order);
    if (colored_faces) {
      for (const float value : red) append(bytes, value, order);
    }
  }
  return bytes;
}

TEST(stage01_read_off, binary_of_both_byte_orders) {
  for (const std::endian order : {std::endian::big, std::endian::little}) {
    const Mesh plain = read_as("a.off", binary(order, false, false, false));
    EXPECT_THAT(plain.positions, SizeIs(4));
    EXPECT_THAT(plain.colors, IsEmpty());
    EXPECT_THAT(plain.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{1, 3, 2}));
    for (const bool whole_numbers : {false, true}) {
      const Mesh colored = read_as("a.off", binary(order, true, false, whole_numbers));
      EXPECT_EQ(colored.positions, plain.positions);
      EXPECT_THAT(colored.colors,
                  ElementsAre(blue, Vector(1, 0, 1), Vector(0, 1, 1), Vector(1, 1, 1)));
      EXPECT_EQ(colored.triangles, plain.triangles);
    }
  }
  const Mesh faces_colored = read_as("a.off", binary(std::endian::big, false, true, false));
  EXPECT_THAT(faces_colored.colors, testing::Each(red));
}

TEST(stage01_read_off, binary_cut_off_anywhere) {
  for (const std::endian order : {std::endian::big, std::endian::little}) {
    const std::string whole = binary(order, true, false, false);
    for (std::size_t size = 1; size < whole.size(); ++size) {
      EXPECT_NE(refusal("a.off", whole.substr(0, size)), "")
          << size << " bytes of " << whole.size();
    }
  }
}

// ---- What is wrong, and where

TEST(stage01_read_off, refusals_name_the_line) {
  const std::string start = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(refusal("a.off", start + "3 0 1 3\n"),
            "a.off:6: a face refers to vertex 3; there are vertices 0 to 2");
  EXPECT_EQ(refusal("a.off", start + "3 0 -1 2\n"),
            "a.off:6: a face refers to vertex -1; there are vertices 0 to 2");
  EXPECT_EQ(refusal("a.off", start + "3 0 1\n"), "a.off:6: the number of a vertex expected");
  EXPECT_EQ(refusal("a.off", start + "3 0 1 x\n"), "a.off:6: 'x' is not a whole number");
  EXPECT_EQ(refusal("a.off", start + "0\n"), "a.off:6: a face of 0 corners");
  EXPECT_EQ(refusal("a.off", start + "-3 0 1 2\n"), "a.off:6: a face of -3 corners");
  EXPECT_THAT(refusal("a.off", start),
              HasSubstr("a.off:5: the file ends after 0 of the 1 faces that line 2 promises"));
  EXPECT_EQ(refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 zero\n0 1 0\n3 0 1 2\n"),
            "a.off:4: 'zero' is not a number");
  EXPECT_EQ(refusal("a.off", "OFF\n3 1 0\n0 0 0 1 1 1\n1 0 0\n0 1 0\n3 0 1 2\n"),
            "a.off:4: a vertex of 3 numbers; the first has 6");
  EXPECT_THAT(refusal("a.off", "OFF\n3 1 0\n0 0\n1 0\n0 1\n3 0 1 2\n"),
              HasSubstr("a.off:3: a vertex of 2 numbers"));
  EXPECT_THAT(refusal("a.off", "OFF\n-3 1 0\n"), HasSubstr("a.off:2: '-3' is no count"));
  EXPECT_THAT(refusal("a.off", "OFF\n"), HasSubstr("a.off:1: "));
  EXPECT_THAT(refusal("a.off", "nOFF\n4\n3 1 0\n"), HasSubstr("a.off:1: 'nOFF' is no OFF header"));
  EXPECT_THAT(refusal("a.off", "FOO\n"), HasSubstr("a.off:1: 'FOO' is no OFF header"));
  EXPECT_THAT(refusal("a.off", "OFF\n0 0 0\n"), HasSubstr("a.off: there is no face"));
  EXPECT_THAT(refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 inf\n0 1 0\n3 0 1 2\n"),
              HasSubstr("not at a finite place"));
}

TEST(stage01_read_off, counts_that_lie_take_no_memory) {
  EXPECT_THAT(refusal("a.off", "OFF\n353535235358 6 0\n0 0 0\n"),
              HasSubstr("the file ends after 1 of the 353535235358 vertices that line 2 promises"));
  EXPECT_THAT(refusal("a.off", "OFF\n3 9000000000000000000 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
              HasSubstr("1 of the 9000000000000000000 faces"));
  EXPECT_NE(refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n"), "");
  EXPECT_THAT(refusal("a.off", "OFF\n99999999999999999999 1 0\n"), HasSubstr("is no count"));
}

}  // namespace
}  // namespace rasterlab
