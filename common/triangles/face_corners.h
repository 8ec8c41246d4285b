// A face of a mesh in the window.
#pragma once

#include "common/lines/seen_along_z.h"
#include "common/mesh/mesh.h"
#include "common/triangles/fixed_point.h"

namespace rasterlab {

/// Where the corners of a face are in the window of a width × height image, seen along z.
inline Corners face_corners(const Mesh& mesh, const Mesh::Triangle& triangle, int width,
                            int height) {
  Corners corners;
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i] = seen_along_z(mesh.positions[triangle[i]], width, height).cast<double>();
  }
  return corners;
}

}  // namespace rasterlab
