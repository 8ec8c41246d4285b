#include "tests/engine/coverage_difference.h"

#include "common/projection/vertex_stage.h"
#include "common/triangles/rasterize.h"

#include <sstream>

namespace rasterlab {

namespace {

Image<std::int32_t> exercise_ids(const Mesh& mesh) {
  Image<std::int32_t> ids(coverage_side, coverage_side, -1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<Eigen::Vector2f, 3> window;
    for (std::size_t c = 0; c < 3; ++c) {
      const Eigen::Vector4f clip =
          to_clip(Eigen::Matrix4f::Identity(), mesh.positions[mesh.triangles[t][c]]);
      window[c] = to_window(clip, coverage_side, coverage_side).position;
    }
    rasterize_triangle(window, coverage_side, coverage_side,
                       [&](int x, int y, const Eigen::Vector3d&) {
                         std::int32_t& id = ids.row(y)[x];
                         if (id < 0) id = static_cast<std::int32_t>(t);
                       });
  }
  return ids;
}

Image<std::int32_t> engine_ids(const Mesh& mesh, Renderer& renderer) {
  const PreparedMesh prepared(mesh);
  Framebuffer frame(coverage_side, coverage_side);
  renderer.draw({.mesh = &prepared}, frame);
  return frame.ids();
}

}  // namespace

bool coverage_differs(const Mesh& mesh, Renderer& renderer) {
  return engine_ids(mesh, renderer) != exercise_ids(mesh);
}

std::string culprit(const Mesh& mesh, Renderer& renderer) {
  std::size_t begin = 0;
  std::size_t end = mesh.triangles.size();
  const auto differs = [&](std::size_t from, std::size_t to) {
    Mesh part = mesh;
    part.triangles.assign(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(from),
                          mesh.triangles.begin() + static_cast<std::ptrdiff_t>(to));
    return coverage_differs(part, renderer);
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

}  // namespace rasterlab
