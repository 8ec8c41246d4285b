// The pictures of stage 03 against the ray caster: triangles in the window, the nearest of which is
// seen, with colours interpolated.
#include "common/image/files.h"

#include "tests/oracle/shading.h"
#include "tests/support/process.h"
#include "tests/support/scratch.h"

#include <cmath>
#include <fstream>
#include <random>

#include <gtest/gtest.h>

namespace rasterlab::oracle {
namespace {

constexpr int width = 120;
constexpr int height = 90;

/// Window coordinates and NDC depth seen as a space of its own.
Camera window_camera() {
  Camera camera;
  camera.projection << 2.0 / width, 0, 0, -1,  //
      0, -2.0 / height, 0, 1,                  //
      0, 0, 1, 0,                              //
      0, 0, 0, 1;
  return camera;
}

/// To 1/256 px, where snapping moves nothing: a sliver's colours change so fast that half of that
/// would show.
float on_grid(float coordinate) {
  return std::round(coordinate * 256) / 256;
}

/// Triangles anywhere in and around the window and the depth range, most of them crossing others.
Mesh random_triangles(int count, unsigned seed, float extent) {
  std::mt19937 random(seed);
  const auto pick = [&](float from, float to) {
    return std::uniform_real_distribution<float>(from, to)(random);
  };
  const auto pick_code = [&] { return static_cast<float>(random() % 256); };
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const Eigen::Vector3f center(pick(-20, width + 20), pick(-20, height + 20), pick(-1.1F, 1.1F));
    for (int corner = 0; corner < 3; ++corner) {
      mesh.positions.emplace_back(on_grid(center.x() + pick(-extent, extent)),
                                  on_grid(center.y() + pick(-extent, extent)),
                                  center.z() + pick(-0.4F, 0.4F));
      mesh.colors.emplace_back(pick_code() / 255, pick_code() / 255, pick_code() / 255);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

Image<Rgb8> draw(const Mesh& mesh) {
  const ScratchFolder scratch;
  std::ofstream file(scratch / "triangles.txt");
  file.precision(9);
  for (const Mesh::Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) file << mesh.positions[vertex].transpose() << " ";
    for (const std::uint32_t vertex : triangle) {
      file << (255 * mesh.colors[vertex]).array().round().transpose() << " ";
    }
    file << "\n";
  }
  file.close();
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  const ProcessResult result =
      run_process({program("03_zbuffer"), "--triangles", scratch / "triangles.txt", "--size", size,
                   "--out", scratch / "drawn.png"});
  EXPECT_EQ(result.exit_status, 0) << result.err;
  return read_image<Rgb8>(scratch / "drawn.png");
}

void expect_agreement(const Mesh& mesh) {
  const RayCaster witness(mesh, window_camera(), width, height);
  const Surface surface(mesh);
  const Agreement agreement = compare_colors(
      witness, draw(mesh),
      [&](double, double, const Hit& hit) { return Shade{.color = surface.color(hit)}; });
  std::cout << agreement;
  EXPECT_EQ(agreement.wrong, 0) << agreement;
  EXPECT_GT(agreement.drawn, 500);
}

TEST(stage03_witness, large_triangles_that_cross) {
  expect_agreement(random_triangles(12, 1, 70));
}

TEST(stage03_witness, many_small_triangles) {
  expect_agreement(random_triangles(400, 2, 15));
}

TEST(stage03_witness, triangles_far_larger_than_the_window) {
  expect_agreement(random_triangles(6, 3, 2000));
}

TEST(stage03_witness, slivers) {
  Mesh mesh = random_triangles(200, 4, 60);
  for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
    Eigen::Vector3f& third = mesh.positions[i + 2];
    third = 0.7F * mesh.positions[i] + 0.3F * mesh.positions[i + 1] +
            Eigen::Vector3f(0.4F, -0.3F, 0.1F);
    third.head<2>() = third.head<2>().unaryExpr(&on_grid).eval();
  }
  expect_agreement(mesh);
}

}  // namespace
}  // namespace rasterlab::oracle
