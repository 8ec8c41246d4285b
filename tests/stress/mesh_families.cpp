// Meshes through matrices: cameras far away, odd pictures, odd models, special floats anywhere.
#include "common/engine/renderer.h"
#include "common/mesh/shapes.h"
#include "common/projection/draw_mesh.h"
#include "common/projection/look_at.h"
#include "common/projection/perspective.h"

#include "tests/stress/family.h"
#include "tests/stress/homogeneous.h"

#include <algorithm>
#include <cmath>

namespace rasterlab::stress {
namespace {

using Truth = HomogeneousTriangle::Truth;
using Ids = Image<std::int32_t>;

constexpr int width = 64;
constexpr int height = 48;

std::string at(int x, int y) {
  return "pixel (" + std::to_string(x) + ", " + std::to_string(y) + ")";
}

float number_at(const Numbers& n, std::size_t i) {
  return static_cast<float>(n[i]);
}

Eigen::Vector3f vector_at(const Numbers& n, std::size_t i) {
  return {number_at(n, i), number_at(n, i + 1), number_at(n, i + 2)};
}

/// What exercise and engine draw; returns the exercise's.
Ids check_same_pixels(const Mesh& mesh, const Transforms& transforms, int columns, int rows,
                      Cull cull, Verdict& verdict) {
  Frame frame = make_frame(columns, rows);
  frame.ids = Ids(columns, rows, -1);
  draw_mesh(mesh, transforms, cull, frame,
            [](std::uint32_t, const TrianglePixel&) { return Color(1, 1, 1); });
  thread_local Renderer renderer({.threads = 1, .skip = {}});
  const PreparedMesh prepared(mesh);
  Framebuffer engine(columns, rows);
  renderer.draw({.mesh = &prepared,
                 .matrix = transforms.to_clip(),
                 .cull = cull,
                 .mirrored = transforms.mirrored()},
                engine);
  const Ids ids = engine.ids();
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      verdict.expect((ids.row(y)[x] >= 0) == (frame.ids.row(y)[x] >= 0), [&] {
        return "exercise and engine differ in whether " + at(x, y) + " is covered";
      });
    }
  }
  return frame.ids;
}

/// The mesh's triangles in clip space: the matrix as it is, all else exact.
std::vector<HomogeneousTriangle> exact_triangles(const Mesh& mesh, const Eigen::Matrix4f& matrix) {
  std::vector<HomogeneousTriangle> triangles;
  for (const Mesh::Triangle& triangle : mesh.triangles) {
    std::array<HomogeneousTriangle::Corner, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector4f position = mesh.positions[triangle[i]].homogeneous();
      for (std::size_t row = 0; row < 4; ++row) {
        corners[i][row] = 0;
        for (Eigen::Index k = 0; k < 4; ++k) {
          corners[i][row] +=
              static_cast<Float128>(matrix(static_cast<Eigen::Index>(row), k)) * position[k];
        }
      }
    }
    triangles.emplace_back(corners, width, height);
  }
  return triangles;
}

Truth truth_of_mesh(const std::vector<HomogeneousTriangle>& triangles, int x, int y) {
  Truth sum = Truth::not_covered;
  for (const HomogeneousTriangle& triangle : triangles) {
    if (!triangle.usable()) continue;
    const Truth truth = triangle.truth_at(x, y, 1.0 / 32);
    if (truth == Truth::covered) return truth;
    if (truth == Truth::too_close) sum = truth;
  }
  return sum;
}

/// Eye, centre and how far from the origin both are moved with the mesh; then the camera's angle.
Numbers cameras_far_out(Random& random) {
  const double away = random.pick({0, 1e2, 1e4, 1e6, 1e7});
  return {random.number(-3, 3),
          random.number(-3, 3),
          random.number(-3, 3),
          random.number(-1, 1),
          random.number(-1, 1),
          random.number(-1, 1),
          away,
          random.number(5, 120)};
}

void check_camera(const Numbers& n, Verdict& verdict) {
  if (n.size() != 8 || !(n[7] > 0 && n[7] < 180)) return;
  static const Mesh mesh = make_shape("cube");
  const Eigen::Vector3f away = Eigen::Vector3f(1, 0.5F, -0.7F) * number_at(n, 6);
  Transforms transforms;
  transforms.model.topRightCorner<3, 1>() = away;
  transforms.view =
      look_at(vector_at(n, 0) + away, vector_at(n, 3) + away, Eigen::Vector3f::UnitY());
  transforms.projection = perspective(number_at(n, 7), 4.0F / 3, 0.1F, 100);
  const Ids ids = check_same_pixels(mesh, transforms, width, height, Cull::none, verdict);
  const auto triangles = exact_triangles(mesh, transforms.to_clip());
  for (int y = 1; y < height; y += 4) {
    for (int x = 1; x < width; x += 4) {
      const Truth truth = truth_of_mesh(triangles, x, y);
      if (truth == Truth::too_close) continue;
      verdict.expect((ids.row(y)[x] >= 0) == (truth == Truth::covered), [&] {
        return at(x, y) + (truth == Truth::covered ? " must be" : " must not be") + " covered";
      });
    }
  }
}

Numbers odd_pictures(Random& random) {
  return {random.pick({1, 1, 2, 3, 5, 16384}),
          random.pick({1, 1, 2, 7}),
          random.chance(0.5) ? 1.0 : 0.0,
          random.number(-3, 3),
          random.number(-3, 3),
          random.number(-3, 3)};
}

Transforms seen_from(const Eigen::Vector3f& eye, float fovy, int columns, int rows) {
  Transforms transforms;
  transforms.view = look_at(eye, Eigen::Vector3f::Zero(), Eigen::Vector3f::UnitY());
  transforms.projection =
      perspective(fovy, static_cast<float>(columns) / static_cast<float>(rows), 0.1F, 20);
  return transforms;
}

void check_picture(const Numbers& n, Verdict& verdict) {
  if (n.size() != 6) return;
  static const Mesh mesh = make_shape("torus_knot:4");
  const auto side = [](double number) {
    return static_cast<int>(std::clamp(number, 1.0, 16384.0));
  };
  const int columns = side(n[2] != 0 ? n[0] : n[1]);
  const int rows = side(n[2] != 0 ? n[1] : n[0]);
  check_same_pixels(mesh, seen_from(vector_at(n, 3), 70, columns, rows), columns, rows, Cull::none,
                    verdict);
}

/// The model's 3 × 3 matrix row by row, and the eye.
Numbers odd_models(Random& random) {
  Numbers numbers;
  for (int i = 0; i < 9; ++i) {
    numbers.push_back(random.number(-1, 1) * std::pow(10, random.number(-2, 1)));
  }
  const std::int64_t kind = random.whole(0, 4);
  for (std::size_t i = 0; i < 3; ++i) {
    if (kind == 0) numbers[6 + i] = 0;                                // pressed flat
    if (kind == 1) numbers[6 + i] = numbers[i] - 2 * numbers[3 + i];  // in another plane
    if (kind == 2) numbers[3 + i] = numbers[6 + i] = 0;               // to a line
    if (kind == 3) numbers[i] = numbers[3 + i] = numbers[6 + i] = 0;  // to a point
  }
  for (int i = 0; i < 3; ++i) numbers.push_back(random.number(-3, 3));
  return numbers;
}

void check_model(const Numbers& n, Verdict& verdict) {
  if (n.size() != 12) return;
  static const Mesh mesh = make_shape("icosphere:1");
  Transforms transforms = seen_from(vector_at(n, 9), 60, width, height);
  for (Eigen::Index row = 0; row < 3; ++row) {
    transforms.model.row(row).head<3>() = vector_at(n, static_cast<std::size_t>(3 * row));
  }
  for (const Cull cull : {Cull::none, Cull::back, Cull::front}) {
    check_same_pixels(mesh, transforms, width, height, cull, verdict);
  }
}

}  // namespace

std::vector<Family> mesh_families() {
  return {
      {"cameras_far_out",
       "up to 1e7 units from the origin exercise and engine cover the same pixels, and those "
       "farther than 1/32 px from an edge are what homogeneous edge functions in 128-bit floats "
       "say of the same matrix",
       0, 0, cameras_far_out, check_camera},
      {"odd_pictures",
       "in pictures of 1 × 1 to 1 × 16384 exercise and engine cover the same pixels", 0, 0,
       odd_pictures, check_picture},
      {"odd_models",
       "under uneven, mirrored and singular model matrices exercise and engine cover the same "
       "pixels, whichever sides are culled",
       0, 0, odd_models, check_model},
  };
}

}  // namespace rasterlab::stress
