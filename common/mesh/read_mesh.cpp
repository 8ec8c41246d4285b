#include "common/mesh/read_mesh.h"

#include "common/image/check.h"
#include "common/mesh/shapes.h"

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

namespace rasterlab {

Mesh read_mesh(const std::filesystem::path& file) {
  const std::string builtin = "builtin:";
  if (file.string().starts_with(builtin)) return make_shape(file.string().substr(builtin.size()));
  OpenMesh::TriMesh_ArrayKernelT<> source;
  omerr().disable();
  if (!OpenMesh::IO::read_mesh(source, file.string())) {
    throw InputError(file.string() + ": no mesh could be read; OFF, OBJ, PLY, STL or OM expected");
  }
  Mesh mesh;
  for (const auto vertex : source.vertices()) {
    const auto& point = source.point(vertex);
    mesh.positions.emplace_back(point[0], point[1], point[2]);
  }
  for (const auto face : source.faces()) {
    Mesh::Triangle triangle{};
    std::size_t corner = 0;
    for (const auto vertex : face.vertices()) {
      triangle[corner++] = static_cast<std::uint32_t>(vertex.idx());
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

}  // namespace rasterlab
