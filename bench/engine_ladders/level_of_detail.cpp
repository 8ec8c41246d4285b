#include "bench/engine_ladders/level_of_detail.h"

#include "common/engine/renderer.h"
#include "common/mesh/decimate.h"
#include "common/mesh/normals.h"
#include "common/mesh/shapes.h"
#include "common/projection/look_at.h"
#include "common/projection/perspective.h"

#include "bench/engine/bench_shaders.h"
#include "bench/support/picture_error.h"

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace rasterlab::bench {
namespace {

const Eigen::Vector3f eye(0.4F, 0.8F, 2.6F);

/// Hills of many sizes, so that some of its triangles count for more than others.
Mesh bumpy_sphere() {
  Mesh mesh = make_shape("icosphere", 6);
  for (Eigen::Vector3f& p : mesh.positions) {
    const float hills = std::sin(5 * p.x() + 1) * std::sin(6 * p.y()) * std::sin(5 * p.z());
    const float stones = std::sin(23 * p.x()) * std::sin(19 * p.y() + 2) * std::sin(29 * p.z());
    p *= 0.95F + 0.2F * hills + 0.02F * stones;
  }
  mesh.normals = angle_weighted_normals(mesh);
  mesh.texture_coordinates.clear();
  return mesh;
}

class Level {
 public:
  Level(const Mesh& mesh, int pixels)
      : prepared_(mesh), renderer_({.threads = 1}), frame_(pixels, pixels) {}

  const Image<Rgb8>& draw() {
    frame_.clear();
    renderer_.draw({.mesh = &prepared_,
                    .matrix = perspective(50, 1, 0.1F, 20) * look_at(eye, {0, 0, 0}, {0, 1, 0}),
                    .shading = shading(shader_)},
                   frame_);
    return frame_.color();
  }

 private:
  PreparedMesh prepared_;
  PhongShader shader_{{.eye = eye}};
  Renderer renderer_;
  Framebuffer frame_;
};

/// The sphere at each level, the coarsest first, made once: decimating takes a while.
const std::vector<Mesh>& levels() {
  static const std::vector<Mesh> all = [] {
    std::vector<Mesh> meshes;
    const Mesh whole = bumpy_sphere();
    for (const std::size_t part : {200U, 100U, 50U, 20U, 10U, 4U, 2U})
      meshes.push_back(decimated(whole, whole.triangles.size() / part));
    meshes.push_back(whole);
    return meshes;
  }();
  return all;
}

}  // namespace

TimedLadder level_of_detail_ladder(int pixels) {
  TimedLadder ladder{.name = "level of detail, " + std::to_string(pixels) + " pixels a side",
                     .stage = "engine",
                     .unit = "pixel of the picture",
                     .units = static_cast<double>(pixels) * pixels,
                     .error = "model: RMSE, codes",
                     .rungs = {}};
  const Image<Rgb8> truth = Level(levels().back(), pixels).draw();
  for (const Mesh& mesh : levels()) {
    const auto level = std::make_shared<Level>(mesh, pixels);
    const bool whole = &mesh == &levels().back();
    ladder.rungs.push_back({.name = std::to_string(mesh.triangles.size()) + " triangles",
                            .fault = whole ? "none" : "coarser outlines and shading",
                            .work = [level] { level->draw(); },
                            .errors = picture_errors("model", level->draw(), truth)});
  }
  return ladder;
}

}  // namespace rasterlab::bench
