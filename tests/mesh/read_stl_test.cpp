#include "tests/mesh/read_helpers.h"

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;
using Vector = Eigen::Vector3f;
using Triangle = Mesh::Triangle;

const std::string text =
    "solid square\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex "
    "1 1 0\n"
    "  endloop\n endfacet\n facet normal 0 0 1\n  outer loop\n   vertex 0 -0 0\n   vertex 1 1e0 0\n"
    "   vertex 0 1 0\n  endloop\n endfacet\nendsolid square\n";

std::string binary(const std::string& title) {
  std::string bytes = title + std::string(80 - title.size(), ' ');
  append(bytes, std::uint32_t{2});
  for (const auto& corners : {std::array<Vector, 3>{Vector(0, 0, 0), {1, 0, 0}, {1, 1, 0}},
                              std::array<Vector, 3>{Vector(0, 0, 0), {1, 1, 0}, {0, 1, 0}}}) {
    for (int i = 0; i < 3; ++i) append(bytes, 0.0F);
    for (const Vector& corner : corners) {
      for (const float x : corner) append(bytes, x);
    }
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

void expect_square(const Mesh& mesh) {
  EXPECT_THAT(mesh.positions,
              ElementsAre(Vector(0, 0, 0), Vector(1, 0, 0), Vector(1, 1, 0), Vector(0, 1, 0)));
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
}

TEST(stage01_read_stl, text) {
  expect_square(read_as("a.stl", text));
  std::string shouted = text;
  for (char& c : shouted) c = static_cast<char>(std::toupper(c));
  expect_square(read_as("a.STL", shouted));
  std::string crlf = text;
  replace_all(crlf, "\n", "\r\n");
  expect_square(read_as("a.stl", crlf));
}

TEST(stage01_read_stl, binary_whatever_its_title) {
  expect_square(read_as("a.stl", binary("made here")));
  expect_square(read_as("a.stl", binary("solid as a text begins")));
  expect_square(read_as("a.stl", binary("title") + "more at the end"));
}

TEST(stage01_read_stl, cut_off) {
  const std::string whole = binary("title");
  for (std::size_t size = 1; size < whole.size(); ++size) {
    EXPECT_NE(refusal("a.stl", whole.substr(0, size)), "") << size << " bytes";
  }
  EXPECT_THAT(refusal("a.stl", whole.substr(0, whole.size() - 1)),
              HasSubstr("promises 2 faces, but the file ends after 1"));
  const std::size_t inside = text.find("vertex 1 1e0");
  EXPECT_EQ(refusal("a.stl", text.substr(0, inside)), "a.stl:12: the file ends within a face");
}

TEST(stage01_read_stl, refusals) {
  std::string wrong = text;
  replace_all(wrong, "1e0", "one");
  EXPECT_EQ(refusal("a.stl", wrong), "a.stl:12: 'one' is not a number");
  wrong = text;
  replace_all(wrong, "   vertex 1 0 0\n", "");
  EXPECT_EQ(refusal("a.stl", wrong), "a.stl:6: a face of 2 corners");
  std::string lie = binary("title");
  lie.replace(80, 4, "\xFF\xFF\xFF\xFF");
  EXPECT_THAT(refusal("a.stl", lie), HasSubstr("promises 4294967295 faces"));
  EXPECT_THAT(refusal("a.stl", "solid nothing\nendsolid nothing\n"), HasSubstr("there is no face"));
}

}  // namespace
}  // namespace rasterlab
