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

const std::string text_head =
    "ply\nformat ascii 1.0\ncomment made here\nelement vertex 4\nproperty float x\nproperty float "
    "y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
const std::string text_body = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

TEST(stage01_read_ply, text) {
  const Mesh mesh = read_as("a.ply", text_head + text_body);
  EXPECT_THAT(mesh.positions,
              ElementsAre(Vector(0, 0, 0), Vector(1, 0, 0), Vector(1, 1, 0), Vector(0, 1, 0)));
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
  EXPECT_THAT(mesh.normals, IsEmpty());
  EXPECT_THAT(mesh.colors, IsEmpty());
  std::string crlf = text_head + text_body;
  replace_all(crlf, "\n", "\r\n");
  EXPECT_EQ(read_as("a.ply", crlf).positions, mesh.positions);
}

TEST(stage01_read_ply, all_attributes_in_any_order) {
  const Mesh mesh =
      read_as("a.ply",
              "ply\nformat ascii 1.0\nelement vertex 3\nproperty uchar red\nproperty float nz\n"
              "property double x\nproperty float quality\nproperty uchar green\nproperty float z\n"
              "property float y\nproperty uchar blue\nproperty float t\nproperty float s\n"
              "property float nx\nproperty float ny\nproperty uchar alpha\n"
              "element face 1\nproperty list uchar uint vertex_index\nend_header\n"
              "255 2 0 9 0 0 0 0 .25 .5 0 0 255\n0 2 1 9 255 0 0 51 0 1 0 0 255\n"
              "0 2 0 9 0 0 1 255 1 0 0 0 255\n3 0 1 2\n");
  EXPECT_THAT(mesh.positions, ElementsAre(Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0)));
  EXPECT_THAT(mesh.normals, Each(Vector(0, 0, 1)));
  EXPECT_THAT(mesh.colors, ElementsAre(Vector(1, 0, 0), Vector(0, 1, 0.2F), Vector(0, 0, 1)));
  EXPECT_THAT(mesh.texture_coordinates, ElementsAre(Uv(.5, .25), Uv(1, 0), Uv(0, 1)));
}

/// Two triangles with elements and lists around them that are of no use.
std::string binary(std::endian order) {
  std::string bytes =
      std::string("ply\nformat binary_") + (order == std::endian::big ? "big" : "little") +
      "_endian 1.0\nelement camera 1\nproperty list int short settings\n"
      "element vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
      "property ushort red\nproperty ushort green\nproperty ushort blue\n"
      "element face 2\nproperty uchar flags\nproperty list int uint vertex_indices\n"
      "property list uchar float texcoord\nelement edge 1\nproperty int a\nend_header\n";
  append(bytes, std::int32_t{2}, order);
  append(bytes, std::int16_t{7}, order);
  append(bytes, std::int16_t{10}, order);  // holds the byte of a line feed
  for (int i = 0; i < 4; ++i) {
    append(bytes, double(i % 2), order);
    append(bytes, i < 2 ? 0.0 : 1.0, order);
    append(bytes, 0.1, order);
    for (const std::uint16_t color : std::array<std::uint16_t, 3>{65535, 0, 13107})
      append(bytes, color, order);
  }
  for (const Triangle& triangle : {Triangle{0, 1, 2}, Triangle{1, 3, 2}}) {
    append(bytes, std::uint8_t{1}, order);
    append(bytes, std::int32_t{3}, order);
    for (const std::uint32_t vertex : triangle) append(bytes, vertex, order);
    append(bytes, std::uint8_t{6}, order);
    for (const std::uint32_t vertex : triangle) {
      append(bytes, float(vertex), order);
      append(bytes, 0.5F, order);
    }
  }
  append(bytes, std::int32_t{5}, order);
  return bytes;
}

TEST(stage01_read_ply, binary_of_both_byte_orders) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const Mesh mesh = read_as("a.ply", binary(order));
    EXPECT_THAT(mesh.positions, ElementsAre(Vector(0, 0, 0.1F), Vector(1, 0, 0.1F),
                                            Vector(0, 1, 0.1F), Vector(1, 1, 0.1F)));
    EXPECT_THAT(mesh.colors, Each(Vector(1, 0, 0.2F)));
    EXPECT_THAT(mesh.texture_coordinates, ElementsAre(Uv(0, .5), Uv(1, .5), Uv(2, .5), Uv(3, .5)));
    EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{1, 3, 2}));
  }
}

TEST(stage01_read_ply, coloured_faces_split_their_vertices) {
  const Mesh mesh =
      read_as("a.ply",
              "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
              "property float z\nelement face 2\nproperty list uchar int vertex_indices\n"
              "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n"
              "0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2 255 0 0\n3 1 3 2 0 0 255\n");
  ASSERT_THAT(mesh.positions, SizeIs(6));
  for (const std::uint32_t vertex : mesh.triangles[0])
    EXPECT_EQ(mesh.colors[vertex], Vector(1, 0, 0));
  for (const std::uint32_t vertex : mesh.triangles[1])
    EXPECT_EQ(mesh.colors[vertex], Vector(0, 0, 1));
}

TEST(stage01_read_ply, cut_off_anywhere) {
  const std::string whole = binary(std::endian::little);
  // Without the bytes of the last element, which is of no use, the file is still cut off.
  for (std::size_t size = 1; size < whole.size(); ++size) {
    ASSERT_NE(refusal("a.ply", whole.substr(0, size)), "") << size << " bytes of " << whole.size();
  }
  const std::string text = text_head + text_body;
  for (std::size_t size = 1; size < text.size() - 1; ++size) {
    ASSERT_NE(refusal("a.ply", text.substr(0, size)), "") << size << " bytes of " << text.size();
  }
}

TEST(stage01_read_ply, refusals_name_the_line) {
  EXPECT_EQ(refusal("a.ply", text_head + "0 0 0\n1 0 0\n1 1 zero\n0 1 0\n4 0 1 2 3\n"),
            "a.ply:13: 'zero' is not a number");
  EXPECT_EQ(refusal("a.ply", text_head + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 4\n"),
            "a.ply:15: a face refers to vertex 4; there are vertices 0 to 3");
  EXPECT_THAT(refusal("a.ply", text_head + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 -1\n"),
              HasSubstr("a.ply:15: a face refers to vertex -1;"));
  EXPECT_THAT(refusal("a.ply", text_head + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 nan\n"),
              HasSubstr("a.ply:15: "));
  EXPECT_THAT(refusal("a.ply", "plyer\n"), HasSubstr("a.ply:1: "));
  EXPECT_THAT(refusal("a.ply", "ply\nformat tape 1.0\n"), HasSubstr("a.ply:2: 'tape'"));
  EXPECT_THAT(refusal("a.ply", "ply\nformat ascii 1.0\nelement vertex many\n"),
              HasSubstr("a.ply:3: 'many'"));
  EXPECT_THAT(refusal("a.ply", "ply\nformat ascii 1.0\nproperty float x\n"),
              HasSubstr("a.ply:3: a property before any element"));
  EXPECT_THAT(refusal("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\n"),
              HasSubstr("a.ply:4: 'quad'"));
  EXPECT_THAT(refusal("a.ply",
                      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n"),
              HasSubstr("x, y and z"));
}

TEST(stage01_read_ply, counts_that_lie_take_no_memory) {
  std::string text = text_head + text_body;
  replace_all(text, "vertex 4", "vertex 4000000000000");
  EXPECT_NE(refusal("a.ply", text), "");
  text = text_head + text_body;
  replace_all(text, "face 1", "face 4000000000000");
  EXPECT_THAT(refusal("a.ply", text), HasSubstr("ends too early"));
  text = text_head + text_body;
  replace_all(text, "4 0 1 2 3", "4000000000 0 1 2 3");
  EXPECT_THAT(refusal("a.ply", text), HasSubstr("ends too early"));
  EXPECT_THAT(refusal("a.ply", "ply\nformat ascii 1.0\nelement thing 9000000000000000000\n" +
                                   text_head.substr(4) + text_body),
              "");
}

}  // namespace
}  // namespace rasterlab
