#include "common/mesh/decimate.h"

#include "common/mesh/normals.h"
#include "common/mesh/openmesh_silence.h"

#include <algorithm>

// OpenMesh's vectors begin uninitialized; g++ sees that through all inlining when it sanitizes.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

namespace rasterlab {
namespace {

using Surface = OpenMesh::TriMesh_ArrayKernelT<>;
using Corners = std::array<OpenMesh::VertexHandle, 3>;

Surface::Point point(const Eigen::Vector3f& position) {
  return {position.x(), position.y(), position.z()};
}

/// Adds a triangle; where OpenMesh cannot join it to what is there, with vertices of its own.
void add_triangle(Surface& surface, const Corners& corners) {
  if (surface.add_face(corners[0], corners[1], corners[2]).is_valid()) return;
  Corners own;
  std::transform(corners.begin(), corners.end(), own.begin(), [&](auto corner) {
    const Surface::Point copy = surface.point(corner);  // adding moves the points
    return surface.add_vertex(copy);
  });
  surface.add_face(own[0], own[1], own[2]);
}

Surface joined_surface(const Mesh& mesh) {
  const OpenMeshSilence silence;
  Surface surface;
  const std::vector<std::uint32_t> joined = join_by_position(mesh.positions);
  std::vector<OpenMesh::VertexHandle> handles(mesh.positions.size());
  for (const Mesh::Triangle& triangle : mesh.triangles) {
    Corners corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t vertex = joined[triangle[i]];
      if (!handles[vertex].is_valid())
        handles[vertex] = surface.add_vertex(point(mesh.positions[vertex]));
      corners[i] = handles[vertex];
    }
    const auto& [a, b, c] = corners;
    if (a != b && b != c && c != a) add_triangle(surface, corners);
  }
  return surface;
}

void collapse_edges(Surface& surface, std::size_t triangles) {
  using Decimater = OpenMesh::Decimater::DecimaterT<Surface>;
  surface.request_face_normals();
  surface.update_face_normals();
  Decimater decimater(surface);
  OpenMesh::Decimater::ModQuadricT<Surface>::Handle quadric;
  OpenMesh::Decimater::ModNormalFlippingT<Surface>::Handle flipping;
  decimater.add(quadric);
  decimater.add(flipping);
  decimater.initialize();
  decimater.decimate_to_faces(0, triangles);
  surface.garbage_collection();
}

Mesh to_mesh(const Surface& surface) {
  Mesh mesh;
  for (const auto vertex : surface.vertices()) {
    const Surface::Point& at = surface.point(vertex);
    mesh.positions.emplace_back(at[0], at[1], at[2]);
  }
  for (const auto face : surface.faces()) {
    Mesh::Triangle triangle{};
    std::size_t i = 0;
    for (const auto vertex : face.vertices())
      triangle[i++] = static_cast<std::uint32_t>(vertex.idx());
    mesh.triangles.push_back(triangle);
  }
  mesh.normals = angle_weighted_normals(mesh);
  return mesh;
}

}  // namespace

Mesh decimated(const Mesh& mesh, std::size_t triangles) {
  Surface surface = joined_surface(mesh);
  collapse_edges(surface, triangles);
  return to_mesh(surface);
}

}  // namespace rasterlab
