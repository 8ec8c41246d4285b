// Levels of detail: a mesh of fewer triangles for what is seen from farther off.
#pragma once

#include "common/mesh/mesh.h"

#include <cstddef>

namespace rasterlab {

/// The mesh with about `triangles` triangles or fewer: edges are collapsed, one after the other,
/// each time the one that moves the surface least, as long as no face turns over. It keeps more
/// where the mesh's topology allows no further collapse. Vertices are some of the mesh's own.
///
/// Vertices at one position are joined first; the result has angle-weighted normals, and neither
/// colours nor texture coordinates. Where more than two faces meet in an edge, the further ones get
/// vertices of their own.
///
/// Source: Garland and Heckbert, "Surface Simplification Using Quadric Error Metrics", SIGGRAPH
/// 1997, as OpenMesh has it. Cost: O(n log n).
Mesh decimated(const Mesh& mesh, std::size_t triangles);

}  // namespace rasterlab
