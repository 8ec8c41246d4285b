// What the readers of mesh files share: polygons whose corners point into lists of attributes
// become a Mesh.
#pragma once

#include "common/mesh/mesh.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rasterlab {

class MeshBuilder {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFF;

  /// A corner of a polygon: numbers of elements of the lists below.
  struct Corner {
    std::uint32_t position = 0;
    std::uint32_t normal = none;
    std::uint32_t color = none;
    std::uint32_t uv = none;
  };

  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;  ///< of any length; zero and not finite count as none
  std::vector<Eigen::Vector3f> colors;   ///< what leaves [0, 1] is clamped, NaN becomes 1
  std::vector<Eigen::Vector2f> uvs;

  /// Three corners or more. The lists may still grow, but in build() every number must be in range.
  void add_polygon(std::span<const Corner> corners);

  /// Makes one list a list per position: corners so far get their position's number in it.
  void give_each_position(std::uint32_t Corner::*attribute);

  /// Corners so far take position `numbers[i]` where they had i.
  void renumber_positions(const std::vector<std::uint32_t>& numbers);

  /// Cuts the polygons into triangles and joins corners into vertices: those with the same position
  /// and equal normal, colour and texture coordinates are one vertex. Vertices keep the order of
  /// `positions`; further vertices, for the other sides of seams, follow. Positions that no polygon
  /// uses are left out.
  ///
  /// An attribute that no corner has gives an empty array. A corner without one that others have
  /// gets the angle-weighted normal, white, (0, 0).
  ///
  /// Throws InputError, beginning with `file`, when there is no polygon or a corner is not at a
  /// finite place.
  Mesh build(const std::string& file) &&;

 private:
  void check_positions(const std::string& file) const;
  void drop_normals_without_direction();

  std::vector<Corner> corners_;
  std::vector<std::size_t> polygon_ends_;
};

/// Colours as text files give them, 0…1 or 0…255, to 0…1. They are 0…255 when one exceeds 1 and all
/// are whole numbers or one is 2 or more: all black and white in whole numbers is 0…1.
void scale_colors(std::vector<Eigen::Vector3f>& colors);

}  // namespace rasterlab
