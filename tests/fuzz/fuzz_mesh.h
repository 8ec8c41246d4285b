// Reading meshes of any format.
#pragma once

#include "common/mesh/read_mesh.h"

#include "tests/fuzz/fuzz_target.h"

namespace rasterlab {

inline void fuzz_mesh(std::string_view bytes, const std::string& name) {
  const Mesh mesh = read_mesh_bytes(bytes, name);
  const std::size_t vertices = mesh.positions.size();
  const auto fits = [&](std::size_t size) { return size == 0 || size == vertices; };
  require(fits(mesh.normals.size()) && fits(mesh.colors.size()) &&
              fits(mesh.texture_coordinates.size()),
          "every array of a mesh is empty or as long as its positions");
  for (const Mesh::Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      require(corner < vertices, "a triangle's corners are vertices");
    }
  }
}

}  // namespace rasterlab
