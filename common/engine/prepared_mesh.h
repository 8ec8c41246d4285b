// A mesh made ready for drawing many times: cut once into clusters of neighbouring triangles, which
// the engine can refuse as a whole.
#pragma once

#include "common/mesh/mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace rasterlab {

/// Up to `max_triangles` neighbouring triangles and the vertices they use. Array positions are
/// multiples of 16, so that any SIMD width loads whole vectors.
struct Cluster {
  static constexpr int max_triangles = 128;
  static constexpr int max_vertices = 192;

  std::uint32_t first_vertex = 0;
  std::uint32_t first_triangle = 0;
  std::uint16_t vertex_count = 0;
  std::uint16_t triangle_count = 0;
};

/// Per cluster: the unit normals of its triangles, (v1 − v0) × (v2 − v0) made as long as 1, are at
/// most `spread` from `axis`. Not a number where a triangle has none.
struct Facing {
  std::array<std::vector<float>, 3> axis;
  std::vector<float> spread;
  std::vector<float> smallest;  ///< the least of twice the triangles' areas
  std::vector<float> thinnest;  ///< the least of twice their areas over their longest sides
};

/// All clusters, as arrays that SIMD code reads 16 entries at a time (padded at the end).
struct Clusters {
  std::vector<Cluster> list;
  /// Per cluster, the box around its vertices: centre and half size along x, y, z. Not finite where
  /// a position isn't.
  std::array<std::vector<float>, 3> center;
  std::array<std::vector<float>, 3> half_size;
  /// Per cluster, what is known of the ways its triangles face.
  Facing facing;
  /// Per vertex of a cluster: its position.
  std::array<std::vector<float>, 3> position;
  /// Per triangle of a cluster: which of the cluster's vertices its corners are, beginning with the
  /// one of the lowest index in the mesh, so that (a, b, c) and (b, c, a) are drawn alike.
  std::array<std::vector<std::uint8_t>, 3> corner;
  /// Per triangle of a cluster: its index in the mesh.
  std::vector<std::uint32_t> triangle;
};

class PreparedMesh {
 public:
  /// Keeps a reference to `mesh`, whose positions and triangles must stay as they are. Throws
  /// InputError when a triangle refers to a vertex there isn't. Positions that are not finite are
  /// accepted; triangles that use them are not drawn. Cost: a sort of the triangles, on all cores.
  explicit PreparedMesh(const Mesh& mesh);
  explicit PreparedMesh(Mesh&& mesh) = delete;

  const Mesh& mesh() const { return *mesh_; }
  const Clusters& clusters() const { return clusters_; }

 private:
  const Mesh* mesh_;
  Clusters clusters_;
};

}  // namespace rasterlab
