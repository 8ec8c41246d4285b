#include "common/mesh/shapes.h"

#include "tests/mesh/read_helpers.h"
#include "tests/support/places.h"
#include "tests/support/scratch.h"

#include <cstdlib>
#include <random>
#include <set>

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rasterlab {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// What every renderer takes for granted of a Mesh.
void expect_sane(const Mesh& mesh) {
  const std::size_t vertices = mesh.positions.size();
  ASSERT_GT(vertices, 0U);
  ASSERT_FALSE(mesh.triangles.empty());
  ASSERT_TRUE(mesh.normals.empty() || mesh.normals.size() == vertices);
  ASSERT_TRUE(mesh.colors.empty() || mesh.colors.size() == vertices);
  ASSERT_TRUE(mesh.texture_coordinates.empty() || mesh.texture_coordinates.size() == vertices);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) ASSERT_LT(vertex, vertices);
  }
  for (const auto& position : mesh.positions) ASSERT_TRUE(position.allFinite());
  for (const auto& normal : mesh.normals) ASSERT_NEAR(normal.norm(), 1, 1e-5);
  for (const auto& color : mesh.colors) {
    ASSERT_GE(color.minCoeff(), 0);
    ASSERT_LE(color.maxCoeff(), 1);
  }
}

/// The message with which a file is refused; empty when it is read, and sane.
std::string message_for(const fs::path& file) {
  try {
    expect_sane(read_mesh(file));
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

fs::path zoo() {
  return test_models_folder();
}

fs::path shared_data() {
  const char* const named = std::getenv("RASTERLAB_SHARED_DATA");
  return named != nullptr ? fs::path(named) : source_folder() / ".." / "shared" / "data";
}

std::vector<fs::path> zoo_files() {
  std::vector<fs::path> files;
  for (const char* const folder : {"OFF", "OBJ", "PLY", "STL", "invalid"}) {
    for (const auto& entry : fs::directory_iterator(zoo() / folder)) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// ---- Which format

TEST(stage01_read_mesh, built_in_shapes) {
  EXPECT_EQ(read_mesh("builtin:icosphere:2").positions, make_shape("icosphere", 2).positions);
  EXPECT_THROW(read_mesh("builtin:nothing"), InputError);
}

TEST(stage01_read_mesh, extension_in_any_case_else_content) {
  const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const char* const name : {"a.off", "a.OFF", "a", "a.txt", "a.b.c"}) {
    EXPECT_EQ(read_as(name, off).triangles.size(), 1U) << name;
  }
  EXPECT_THAT(refusal("a.obj", off), HasSubstr("no face"));
  EXPECT_THAT(refusal("a.png", "\x89PNG"), HasSubstr("OFF, OBJ, PLY, STL or OM expected"));
}

// ---- What is no mesh at all

TEST(stage01_read_mesh, missing_folder_and_empty) {
  const ScratchFolder folder;
  EXPECT_THAT(message_for(folder / "missing.obj"), HasSubstr("missing.obj"));
  EXPECT_THAT(message_for(folder.path()), HasSubstr("folder"));
  for (const char* const extension : {"off", "obj", "ply", "stl", "om", "txt"}) {
    EXPECT_THAT(refusal(std::string("a.") + extension, ""), HasSubstr("the file is empty"));
    EXPECT_NE(refusal(std::string("a.") + extension, " \n"), "");
    EXPECT_NE(refusal(std::string("a.") + extension, std::string(100, '\0')), "");
  }
  EXPECT_THAT(refusal("a.obj", std::string("\xFF\xFEv\0 \0", 6)), HasSubstr("UTF-16"));
}

TEST(stage01_read_mesh, noise) {
  std::mt19937 random(1);
  testing::internal::CaptureStderr();
  for (int round = 0; round < 50; ++round) {
    std::string bytes(1 + random() % 5000, ' ');
    for (char& c : bytes)
      c = static_cast<char>(random() % (round % 2 == 0 ? 256 : 96) + (round % 2 == 0 ? 0 : 32));
    for (const char* const extension : {"off", "obj", "ply", "stl", "om", "txt"}) {
      EXPECT_NE(refusal(std::string("a.") + extension, bytes), "");
    }
    for (const auto& [extension, start] :
         {std::pair("off", "OFF\n"), std::pair("off", "OFF BINARY\n"),
          std::pair("ply", "ply\nformat ascii 1.0\n"), std::pair("om", "OMTB"),
          std::pair("stl", "solid\n"), std::pair("obj", "v 0 0 0\nf 1 1 1\nf ")}) {
      EXPECT_NE(refusal(std::string("a.") + extension, start + bytes), "");
    }
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(stage01_read_mesh, damaged_anywhere) {
  const std::vector<std::pair<std::string, std::string>> whole = {
      {"a.off",
       "OFF\n4 2 0\n0 0 0 1 0 0 0 0\n1 0 0 0 1 0 1 0\n0 1 0 0 0 1 0 1\n1 1 0 1 1 1 1 1\n"
       "3 0 1 2\n3 1 3 2\n"},
      {"a.obj",
       "v 0 0 0 1 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 1\nvn 0 0 1\n"
       "f 1/1/1 2/2/1 3/1/1 -1/2/1\nf 1 \\\n2 3\n"},
      {"a.ply",
       "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
       "property float z\nproperty uchar red\nelement face 1\n"
       "property list uchar int vertex_indices\nend_header\n0 0 0 9\n1 0 0 9\n0 1 0 9\n3 0 1 2\n"},
      {"a.stl",
       "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
       "endloop\nendfacet\nendsolid a\n"}};
  std::mt19937 random(3);
  int refused = 0;
  for (const auto& [name, bytes] : whole) {
    ASSERT_EQ(refusal(name, bytes), "");
    for (int round = 0; round < 3000; ++round) {
      std::string damaged = bytes;
      for (std::size_t i = 0; i <= random() % 3; ++i) {
        const std::size_t at = random() % damaged.size();
        switch (random() % 4) {
          case 0:
            damaged[at] = static_cast<char>(random() % 256);
            break;
          case 1:
            damaged[at] = "0123456789-+.e/ \n\\"[random() % 18];
            break;
          case 2:
            damaged.erase(at, 1 + random() % 20);
            break;
          default:
            damaged.insert(at, std::string(random() % 20, damaged[at]));
        }
        if (damaged.empty()) damaged.push_back(' ');
      }
      try {
        expect_sane(read_as(name, damaged));
      } catch (const InputError& error) {
        ++refused;
        ASSERT_THAT(error.what(), testing::StartsWith(name + ":"));
      }
    }
  }
  EXPECT_GT(refused, 1000);
}

// ---- Files written for this project

/// Six times the volume; positive when faces are counter-clockwise seen from outside.
float six_volumes(const Mesh& mesh) {
  float sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += mesh.positions[a].dot(mesh.positions[b].cross(mesh.positions[c]));
  }
  return sum;
}

TEST(stage01_read_mesh, coloured_cube) {
  const Mesh cube = read_mesh(source_folder() / "data/cube.off");
  expect_sane(cube);
  ASSERT_EQ(cube.positions.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(cube.colors[i], (cube.positions[i] + Eigen::Vector3f::Ones()) / 2);
  }
  EXPECT_EQ(cube.triangles.size(), 12U);
  EXPECT_EQ(six_volumes(cube), 6 * 8);
  EXPECT_EQ(six_volumes(make_shape("cube")), 6 * 8);
}

TEST(stage01_read_mesh, textured_wall) {
  const Mesh wall = read_mesh(source_folder() / "data/wall.off");
  expect_sane(wall);
  ASSERT_EQ(wall.texture_coordinates.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector2f flat(wall.positions[i].x(), wall.positions[i].y());
    EXPECT_EQ(wall.texture_coordinates[i], (flat + Eigen::Vector2f(4, 1)) / 2)
        << "bricks keep their shape";
  }
}

// ---- Files that no one here wrote

TEST(stage01_read_mesh, zoo_reads_or_refuses_in_silence) {
  if (!fs::exists(zoo())) GTEST_SKIP() << "no " << zoo() << ": install assimp-testmodels";
  // Nothing with faces is refused but these.
  const std::set<std::string> unreadable = {
      "box_UTF16BE.obj",     // UTF-16
      "number_formats.obj",  // has "3.1+e2"
      "point_cloud.obj",    "points.ply",    "testline.obj",   "testpoints.obj", "issue623.ply",
      "pond.0.ply",  // no faces
      "invalid.off",        "malformed.obj", "malformed2.obj", "OutOfMemory.off"};
  int read = 0;
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  for (const fs::path& file : zoo_files()) {
    SCOPED_TRACE(file);
    const std::string message = message_for(file);
    const std::string name = file.filename();
    const std::string extension = file.extension();
    const bool is_mesh = extension == ".off" || extension == ".obj" || extension == ".ply" ||
                         extension == ".stl" || extension == ".STL" || name == "formatDetection";
    if (is_mesh && unreadable.count(name) == 0 && fs::file_size(file) > 0) {
      EXPECT_EQ(message, "");
      ++read;
    } else {
      EXPECT_THAT(message, testing::StartsWith(file.string()));
      EXPECT_THAT(message, testing::Not(HasSubstr("\n")));
    }
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_GE(read, 34);
}

TEST(stage01_read_mesh, zoo_takes_little_memory) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer needs more memory than the limit of this test";
#endif
  if (!fs::exists(zoo())) GTEST_SKIP() << "no " << zoo() << ": install assimp-testmodels";
  const auto files = zoo_files();
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const rlimit limit = {std::size_t{1} << 28, std::size_t{1} << 28};
    setrlimit(RLIMIT_DATA, &limit);
    for (const fs::path& file : files) {
      try {
        read_mesh(file);
      } catch (const InputError&) {  // the other test looks at these
      } catch (const std::bad_alloc&) {
        _exit(1);
      }
    }
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "256 MiB were not enough";
}

TEST(stage01_read_mesh, one_model_in_four_formats) {
  if (!fs::exists(zoo())) GTEST_SKIP() << "no " << zoo() << ": install assimp-testmodels";
  // The same model, written by programs that do not know each other.
  const auto triangles = [](const fs::path& file) {
    const Mesh mesh = read_mesh(file);
    std::vector<Eigen::Vector3f> centers;
    for (const auto& [a, b, c] : mesh.triangles) {
      centers.emplace_back((mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3);
    }
    return centers;
  };
  const auto distance_to_nearest = [](const Eigen::Vector3f& point,
                                      const std::vector<Eigen::Vector3f>& points) {
    float nearest = 1e9F;
    for (const auto& other : points) nearest = std::min(nearest, (point - other).squaredNorm());
    return std::sqrt(nearest);
  };
  const auto reference = triangles(zoo() / "STL" / "Wuson.stl");
  EXPECT_EQ(reference.size(), 3732U);
  for (const char* const name : {"OFF/Wuson.off", "OBJ/WusonOBJ.obj", "PLY/Wuson.ply"}) {
    const auto centers = triangles(zoo() / name);
    ASSERT_EQ(centers.size(), reference.size());
    for (const auto& center : centers)
      ASSERT_LT(distance_to_nearest(center, reference), 2e-6F) << name;
  }
}

TEST(stage01_read_mesh, bunny) {
  const fs::path bunny = "/usr/share/glmark2/models/bunny.obj";
  if (!fs::exists(bunny)) GTEST_SKIP() << "no " << bunny << ": install glmark2-data";
  const Mesh mesh = read_mesh(bunny);
  expect_sane(mesh);
  EXPECT_EQ(mesh.triangles.size(), 69666U);
  EXPECT_EQ(mesh.positions.size(), 34835U);
}

TEST(stage01_read_mesh, textured_models) {
  if (!fs::exists(shared_data())) {
    GTEST_SKIP() << "no " << shared_data()
                 << ": point RASTERLAB_SHARED_DATA to a folder with spot/ and frankie/";
  }
  const Mesh spot = read_mesh(shared_data() / "spot" / "spot_triangulated.obj");
  expect_sane(spot);
  EXPECT_EQ(spot.triangles.size(), 5856U);
  EXPECT_EQ(spot.positions.size(), 3225U) << "2930 vertices, of which its seams split some";
  EXPECT_FALSE(spot.texture_coordinates.empty());
  const Mesh frankie = read_mesh(shared_data() / "frankie" / "Frankie.obj");
  expect_sane(frankie);
  // A seam that smears would make a triangle as large as the texture.
  for (const auto& [a, b, c] : spot.triangles) {
    const auto& uv = spot.texture_coordinates;
    ASSERT_LT((uv[a] - uv[b]).norm() + (uv[b] - uv[c]).norm() + (uv[c] - uv[a]).norm(), 0.5F);
  }
}

}  // namespace
}  // namespace rasterlab
