#include "common/mesh/shapes.h"

#include "common/image/check.h"

#include <map>
#include <set>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

struct Case {
  std::string name;
  int subdivision;
  bool closed;
  int euler_characteristic;
  double volume;  ///< of the smooth shape, which flat triangles stay a little below
};

void PrintTo(const Case& value, std::ostream* out) {
  *out << value.name << ":" << value.subdivision;
}

/// Edges of the joined mesh, directed as the triangles go round: (from, to) → how often.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed_edges(const Mesh& mesh) {
  const auto joined = join_by_position(mesh.positions);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      ++edges[{joined[triangle[i]], joined[triangle[(i + 1) % 3]]}];
    }
  }
  return edges;
}

int euler_characteristic(const Mesh& mesh) {
  const auto joined = join_by_position(mesh.positions);
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& [edge, count] : directed_edges(mesh)) {
    edges.insert({std::min(edge.first, edge.second), std::max(edge.first, edge.second)});
  }
  const std::set<std::uint32_t> vertices(joined.begin(), joined.end());
  return static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) +
         static_cast<int>(mesh.triangles.size());
}

/// By the divergence theorem; positive when faces are counter-clockwise seen from outside.
double volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += mesh.positions[a].cast<double>().dot(
        mesh.positions[b].cast<double>().cross(mesh.positions[c].cast<double>()));
  }
  return sum / 6;
}

constexpr double pi = 3.14159265358979;

class stage01_shapes : public testing::TestWithParam<Case> {};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const int n : {1, 2, 7}) {
    all.push_back({"cube", n, true, 2, 8});
    all.push_back({"wall", n, false, 1, 0});
    all.push_back({"grid", n, false, 1, 0});
  }
  for (const int n : {2, 3, 5, 32}) all.push_back({"uv_sphere", n, true, 2, 4 * pi / 3});
  for (const int n : {0, 1, 2, 5}) all.push_back({"icosphere", n, true, 2, 4 * pi / 3});
  for (const int n : {3, 8, 32}) {
    all.push_back({"torus", n, true, 0, 2 * pi * 0.7 * pi * 0.3 * 0.3});
    // Pappus: cross-section times the length of the trefoil, integrated numerically.
    all.push_back({"torus_knot", n, true, 0, pi * 0.15 * 0.15 * 8.97417});
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(, stage01_shapes, testing::ValuesIn(cases()), [](const auto& information) {
  return information.param.name + "_" + std::to_string(information.param.subdivision);
});

TEST_P(stage01_shapes, arrays_agree) {
  const Mesh mesh = make_shape(GetParam().name, GetParam().subdivision);
  ASSERT_FALSE(mesh.empty());
  EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
  EXPECT_EQ(mesh.texture_coordinates.size(), mesh.positions.size());
  EXPECT_EQ(mesh.colors.size(), GetParam().name == "cube" ? mesh.positions.size() : 0);
  std::set<std::uint32_t> used;
  for (const auto& triangle : mesh.triangles) used.insert(triangle.begin(), triangle.end());
  EXPECT_EQ(used.size(), mesh.positions.size()) << "a vertex is in no triangle";
  EXPECT_EQ(*used.rbegin() + 1, mesh.positions.size());
}

TEST_P(stage01_shapes, closed_and_oriented) {
  const Mesh mesh = make_shape(GetParam().name, GetParam().subdivision);
  const auto edges = directed_edges(mesh);
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1) << "an edge is passed twice in one direction";
    ASSERT_NE(edge.first, edge.second);
    if (GetParam().closed) {
      ASSERT_EQ(edges.count({edge.second, edge.first}), 1U) << "an edge has one side only";
    }
  }
  EXPECT_EQ(euler_characteristic(mesh), GetParam().euler_characteristic);
}

TEST_P(stage01_shapes, volume) {
  const Mesh mesh = make_shape(GetParam().name, GetParam().subdivision);
  if (!GetParam().closed) {
    EXPECT_EQ(volume(mesh), 0);
    return;
  }
  EXPECT_GT(volume(mesh), 0) << "turned inside out";
  EXPECT_LE(volume(mesh), GetParam().volume + 1e-5);
  if (GetParam().subdivision >= 32 || GetParam().name == "cube") {
    EXPECT_GT(volume(mesh), 0.99 * GetParam().volume);
  }
}

TEST_P(stage01_shapes, normals_are_unit_and_point_out) {
  const Mesh mesh = make_shape(GetParam().name, GetParam().subdivision);
  for (const auto& normal : mesh.normals) ASSERT_NEAR(normal.norm(), 1, 1e-6);
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3f face =
        (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
    ASSERT_GT(face.norm(), 0) << "a triangle without area";
    ASSERT_GT(face.dot(mesh.normals[a] + mesh.normals[b] + mesh.normals[c]), 0);
  }
}

TEST_P(stage01_shapes, fits_the_cube) {
  const Mesh mesh = make_shape(GetParam().name, GetParam().subdivision);
  for (const auto& position : mesh.positions) ASSERT_LE(position.cwiseAbs().maxCoeff(), 1);
}

TEST_P(stage01_shapes, texture_lies_unmirrored_without_jumps) {
  const Mesh mesh = make_shape(GetParam().name, GetParam().subdivision);
  const float u_limit = GetParam().name == "icosphere" ? 1.5F : 1.0F;
  for (const auto& uv : mesh.texture_coordinates) {
    ASSERT_GE(uv.minCoeff(), 0);
    ASSERT_LE(uv.x(), u_limit);
    ASSERT_LE(uv.y(), 1);
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector2f ab = mesh.texture_coordinates[b] - mesh.texture_coordinates[a];
    const Eigen::Vector2f ac = mesh.texture_coordinates[c] - mesh.texture_coordinates[a];
    ASSERT_GT(ab.x() * ac.y() - ab.y() * ac.x(), 0) << "mirrored or collapsed";
    if (GetParam().subdivision > 1) {
      ASSERT_LE(std::max(std::abs(ab.x()), std::abs(ac.x())), 0.5F);
    }
  }
}

TEST(stage01_shapes_globe, continents_are_where_a_map_has_them) {
  for (const char* name : {"uv_sphere:16", "icosphere:4"}) {
    const Mesh mesh = make_shape(name);
    int checked = 0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const Eigen::Vector3f& position = mesh.positions[i];
      const Eigen::Vector2f& uv = mesh.texture_coordinates[i];
      EXPECT_NEAR(std::sin((uv.y() - 0.5) * pi), position.y(), 1e-5);
      if (std::abs(position.y()) > 0.999) continue;
      const Eigen::Vector2d east_and_front(std::sin((uv.x() - 0.5) * 2 * pi),
                                           std::cos((uv.x() - 0.5) * 2 * pi));
      const Eigen::Vector2d expected = Eigen::Vector2d(position.x(), position.z()).normalized();
      EXPECT_NEAR((east_and_front - expected).norm(), 0, 1e-5);
      ++checked;
    }
    EXPECT_GT(checked, 100);
  }
}

TEST(stage01_shapes_cube, corners_have_their_colours) {
  const Mesh mesh = make_shape("cube");
  EXPECT_EQ(mesh.positions.size(), 24U);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    EXPECT_EQ(mesh.colors[i], (mesh.positions[i] + Eigen::Vector3f::Ones()) / 2);
  }
}

TEST(stage01_shapes_by_name, says_what_there_is) {
  const auto message = [](const char* name) {
    try {
      make_shape(name);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_THAT(message("teapot"), testing::HasSubstr("cube, wall, grid, uv_sphere"));
  EXPECT_THAT(message("icosphere:11"), testing::HasSubstr("0 to 10, not 11"));
  EXPECT_THAT(message("icosphere:x"), testing::HasSubstr("'x'"));
  EXPECT_THAT(message("icosphere:"), testing::HasSubstr("whole number"));
  EXPECT_THAT(message(""), testing::HasSubstr("cube"));
  for (const Shape& shape : shapes()) {
    EXPECT_EQ(make_shape(shape.name).triangles,
              make_shape(shape.name + ":" + std::to_string(shape.subdivision)).triangles);
  }
}

TEST(stage01_shapes_by_name, eight_million_triangles) {
  const Mesh mesh = make_shape("uv_sphere:1415");
  EXPECT_EQ(mesh.triangles.size(), 4U * 1415U * 1414U);
}

}  // namespace
}  // namespace rasterlab
