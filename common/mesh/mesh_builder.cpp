#include "common/mesh/mesh_builder.h"

#include "common/image/check.h"
#include "common/mesh/normals.h"
#include "common/mesh/triangulate.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rasterlab {
namespace {

constexpr std::uint32_t none = MeshBuilder::none;

/// Whether two corners have the same of one attribute: both none, or equal values.
template <class Value>
bool same(std::uint32_t a, std::uint32_t b, const std::vector<Value>& values) {
  return a == b || (a != none && b != none && values[a] == values[b]);
}

/// Makes the vertices: finds for each corner the one it belongs to.
class CornerJoiner {
 public:
  CornerJoiner(const MeshBuilder& source, const std::vector<MeshBuilder::Corner>& corners)
      : source_(source), first_vertex_(source.positions.size(), none) {
    for (const auto& corner : corners) first_vertex_[corner.position] = 0;
    std::uint32_t used = 0;
    for (auto& first : first_vertex_) {
      if (first != none) first = used++;
    }
    vertices_.resize(used);
    next_.resize(used, unmade);
  }

  std::uint32_t vertex_of(const MeshBuilder::Corner& corner) {
    std::uint32_t vertex = first_vertex_[corner.position];
    if (next_[vertex] == unmade) {
      vertices_[vertex] = corner;
      next_[vertex] = none;
      return vertex;
    }
    while (!is_same(vertices_[vertex], corner)) {
      if (next_[vertex] == none) {
        const auto added = static_cast<std::uint32_t>(vertices_.size());
        vertices_.push_back(corner);
        next_.push_back(none);
        next_[vertex] = added;
        return added;
      }
      vertex = next_[vertex];
    }
    return vertex;
  }

  const std::vector<MeshBuilder::Corner>& vertices() const { return vertices_; }

 private:
  static constexpr std::uint32_t unmade = none - 1;

  bool is_same(const MeshBuilder::Corner& a, const MeshBuilder::Corner& b) const {
    return same(a.uv, b.uv, source_.uvs) && same(a.normal, b.normal, source_.normals) &&
           same(a.color, b.color, source_.colors);
  }

  const MeshBuilder& source_;
  std::vector<std::uint32_t> first_vertex_;  ///< of each position
  std::vector<std::uint32_t> next_;          ///< the next vertex at the same position
  std::vector<MeshBuilder::Corner> vertices_;
};

/// The values that the vertices' corners point to; none at all when no corner points to one.
template <class Value>
std::vector<Value> gather(const std::vector<MeshBuilder::Corner>& vertices,
                          std::uint32_t MeshBuilder::Corner::*attribute,
                          const std::vector<Value>& values, const Value& if_none) {
  std::vector<Value> result;
  if (std::all_of(vertices.begin(), vertices.end(),
                  [&](const auto& vertex) { return vertex.*attribute == none; })) {
    return result;
  }
  result.reserve(vertices.size());
  for (const auto& vertex : vertices) {
    result.push_back(vertex.*attribute == none ? if_none : values[vertex.*attribute]);
  }
  return result;
}

/// Where a vertex has no normal though others have, it gets the one its faces suggest.
void fill_in_normals(Mesh& mesh) {
  const auto is_none = [](const Eigen::Vector3f& normal) { return normal.isZero(0); };
  if (std::none_of(mesh.normals.begin(), mesh.normals.end(), is_none)) return;
  const std::vector<Eigen::Vector3f> suggested = angle_weighted_normals(mesh);
  for (std::size_t i = 0; i < suggested.size(); ++i) {
    if (is_none(mesh.normals[i])) mesh.normals[i] = suggested[i];
  }
}

float clamp_color(float value) {
  return std::isnan(value) ? 1.0F : std::clamp(value, 0.0F, 1.0F);
}

}  // namespace

void MeshBuilder::add_polygon(std::span<const Corner> corners) {
  corners_.insert(corners_.end(), corners.begin(), corners.end());
  polygon_ends_.push_back(corners_.size());
}

void MeshBuilder::give_each_position(std::uint32_t Corner::*attribute) {
  for (Corner& corner : corners_) corner.*attribute = corner.position;
}

void MeshBuilder::renumber_positions(const std::vector<std::uint32_t>& numbers) {
  for (Corner& corner : corners_) corner.position = numbers[corner.position];
}

Mesh MeshBuilder::build(const std::string& file) && {
  check_positions(file);
  drop_normals_without_direction();
  for (Eigen::Vector3f& color : colors) color = color.unaryExpr(&clamp_color);

  Mesh mesh;
  CornerJoiner joiner(*this, corners_);
  std::vector<std::uint32_t> vertices;
  std::vector<Eigen::Vector3f> polygon;
  std::vector<Mesh::Triangle> triangles;
  std::size_t start = 0;
  for (const std::size_t end : polygon_ends_) {
    vertices.clear();
    polygon.clear();
    for (; start < end; ++start) {
      vertices.push_back(joiner.vertex_of(corners_[start]));
      polygon.push_back(positions[corners_[start].position]);
    }
    triangulate(polygon, triangles);
    for (const auto& [a, b, c] : triangles) {
      mesh.triangles.push_back({vertices[a], vertices[b], vertices[c]});
    }
  }
  mesh.positions =
      gather(joiner.vertices(), &Corner::position, positions, Eigen::Vector3f(0, 0, 0));
  mesh.normals = gather(joiner.vertices(), &Corner::normal, normals, Eigen::Vector3f(0, 0, 0));
  mesh.colors = gather(joiner.vertices(), &Corner::color, colors, Eigen::Vector3f(1, 1, 1));
  mesh.texture_coordinates = gather(joiner.vertices(), &Corner::uv, uvs, Eigen::Vector2f(0, 0));
  fill_in_normals(mesh);
  return mesh;
}

void MeshBuilder::check_positions(const std::string& file) const {
  if (polygon_ends_.empty()) {
    throw InputError(file + ": there is no face in it, so nothing to draw");
  }
  for (const Corner& corner : corners_) {
    if (!positions[corner.position].allFinite()) {
      throw InputError(file + ": a face uses a vertex (number " + std::to_string(corner.position) +
                       ", counted from 0) that is not at a finite place");
    }
  }
}

/// Makes normals unit length, and corners forget those that have none.
void MeshBuilder::drop_normals_without_direction() {
  for (Eigen::Vector3f& normal : normals) {
    const Eigen::Vector3d exact = normal.cast<double>();
    const double length = exact.norm();
    const bool has_direction = length > 0 && std::isfinite(length);
    normal =
        has_direction ? Eigen::Vector3f((exact / length).cast<float>()) : Eigen::Vector3f(0, 0, 0);
  }
  for (Corner& corner : corners_) {
    if (corner.normal != none && normals[corner.normal].isZero(0)) corner.normal = none;
  }
}

void scale_colors(std::vector<Eigen::Vector3f>& colors) {
  float largest = 0;
  bool all_whole = true;
  for (const Eigen::Vector3f& color : colors) {
    for (const float value : color) {
      largest = std::max(largest, value);
      all_whole = all_whole && value == std::floor(value);
    }
  }
  if (largest <= 1 || (!all_whole && largest < 2)) return;
  for (Eigen::Vector3f& color : colors) color /= 255.0F;
}

}  // namespace rasterlab
