// A triangle mesh as flat arrays: what every reader makes and every renderer takes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Dense>

namespace rasterlab {

/// Arrays of one entry per vertex, and triangles that index them. A vertex is split only where a
/// seam needs it: corners that meet in a point with different texture coordinates, normals or
/// colours are different vertices.
struct Mesh {
  using Triangle = std::array<std::uint32_t, 3>;

  std::vector<Eigen::Vector3f> positions;  ///< object space
  std::vector<Eigen::Vector3f> normals;    ///< object space, unit length; empty or one per vertex
  std::vector<Eigen::Vector3f> colors;     ///< red, green, blue in [0, 1]; empty or one per vertex
  std::vector<Eigen::Vector2f>
      texture_coordinates;          ///< (u, v), v up; may leave [0, 1]; empty or one per vertex
  std::vector<Triangle> triangles;  ///< counter-clockwise seen from outside

  bool empty() const { return triangles.empty(); }
};

/// Light grey: the colour of a surface to which neither its mesh nor anything else gives one.
inline Eigen::Vector3f default_color() {
  return Eigen::Vector3f::Constant(0.75F);
}

/// The box around all positions; of an empty mesh, an empty box.
Eigen::AlignedBox3f bounding_box(const Mesh& mesh);

/// For every position the number of the first that equals it: what a seam has split is one again.
std::vector<std::uint32_t> join_by_position(const std::vector<Eigen::Vector3f>& positions);

}  // namespace rasterlab
