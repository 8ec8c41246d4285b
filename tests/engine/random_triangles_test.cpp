// Ten million random triangles: the engine covers exactly the pixels the exercise code covers.
#include "common/engine/renderer.h"
#include "common/projection/vertex_stage.h"
#include "common/triangles/rasterize.h"

#include <random>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

constexpr int side = 256;
constexpr std::uint32_t triangles_per_picture = 20000;

/// Triangle i at depth −1 + i · step: all in front of the ones after it, each flat, so that which
/// is seen follows from coverage alone.
Mesh random_triangles(std::mt19937& random, std::uint32_t count) {
  const auto number = [&random] { return static_cast<float>(random() >> 8U) / 16777216.0F; };
  Mesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    // From hundredths of a pixel to the whole picture; most are a few pixels.
    const float reach = std::exp(-6.5F * std::sqrt(number()) + 0.3F);
    const float x = 2.4F * number() - 1.2F;
    const float y = 2.4F * number() - 1.2F;
    // Some on the grid of pixel centres and quarters, where boundaries meet samples.
    const bool on_grid = random() % 4 == 0;
    for (int c = 0; c < 3; ++c) {
      Eigen::Vector3f p(x + reach * (number() - 0.5F), y + reach * (number() - 0.5F),
                        -1.0F + 1.9F * static_cast<float>(i) / static_cast<float>(count));
      if (on_grid) {
        for (int axis = 0; axis < 2; ++axis) p[axis] = std::round(p[axis] * 512) / 512;
      }
      mesh.positions.push_back(p);
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

Image<std::int32_t> exercise_ids(const Mesh& mesh) {
  Image<std::int32_t> ids(side, side, -1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<Eigen::Vector2f, 3> window;
    for (std::size_t c = 0; c < 3; ++c) {
      const Eigen::Vector4f clip =
          to_clip(Eigen::Matrix4f::Identity(), mesh.positions[mesh.triangles[t][c]]);
      window[c] = to_window(clip, side, side).position;
    }
    rasterize_triangle(window, side, side, [&](int x, int y, const Eigen::Vector3d&) {
      std::int32_t& id = ids.row(y)[x];
      if (id < 0) id = static_cast<std::int32_t>(t);
    });
  }
  return ids;
}

Image<std::int32_t> engine_ids(const Mesh& mesh, Renderer& renderer) {
  const PreparedMesh prepared(mesh);
  Framebuffer frame(side, side);
  renderer.draw({.mesh = &prepared}, frame);
  return frame.ids();
}

/// The one triangle whose coverage differs, found by halving.
std::string culprit(const Mesh& mesh, Renderer& renderer) {
  std::size_t begin = 0;
  std::size_t end = mesh.triangles.size();
  const auto differs = [&](std::size_t from, std::size_t to) {
    Mesh part = mesh;
    part.triangles.assign(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(from),
                          mesh.triangles.begin() + static_cast<std::ptrdiff_t>(to));
    return engine_ids(part, renderer) != exercise_ids(part);
  };
  while (end - begin > 1) {
    const std::size_t middle = (begin + end) / 2;
    if (differs(begin, middle)) {
      end = middle;
    } else if (differs(middle, end)) {
      begin = middle;
    } else {
      return "none alone: triangles " + std::to_string(begin) + " to " + std::to_string(end);
    }
  }
  std::ostringstream text;
  text << "triangle " << begin << ":";
  for (const std::uint32_t i : mesh.triangles[begin]) {
    text << std::hexfloat << " (" << mesh.positions[i].x() << ", " << mesh.positions[i].y() << ")";
  }
  return text.str();
}

TEST(engine_random_triangles, ten_million_cover_what_the_exercise_covers) {
  std::mt19937 random(5);
  Renderer renderer;
  for (int picture = 0; picture < 500; ++picture) {
    const Mesh mesh = random_triangles(random, triangles_per_picture);
    ASSERT_EQ(engine_ids(mesh, renderer) == exercise_ids(mesh), true)
        << "picture " << picture << ", " << culprit(mesh, renderer);
  }
}

}  // namespace
}  // namespace rasterlab
