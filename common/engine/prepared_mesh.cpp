#include "common/engine/prepared_mesh.h"

#include "common/image/check.h"

#include <cmath>

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

namespace rasterlab {

namespace {

constexpr std::uint32_t padding = 16;

void check_indices(const Mesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t vertex : mesh.triangles[t]) {
      if (vertex >= mesh.positions.size()) {
        throw InputError("triangle " + std::to_string(t) + " refers to vertex " +
                         std::to_string(vertex) + ", but the mesh has " +
                         std::to_string(mesh.positions.size()) + " vertices");
      }
    }
  }
}

/// The low 10 bits of `value`, two zeros between each.
std::uint32_t spread_bits(std::uint32_t value) {
  value = (value | value << 16U) & 0x030000FFU;
  value = (value | value << 8U) & 0x0300F00FU;
  value = (value | value << 4U) & 0x030C30C3U;
  return (value | value << 2U) & 0x09249249U;
}

/// Where along the box's Morton curve the point lies; 0 when it isn't finite.
std::uint32_t morton_code(const Eigen::Vector3f& point, const Eigen::AlignedBox3f& box) {
  std::uint32_t code = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const float size = box.max()[axis] - box.min()[axis];
    const float place = (point[axis] - box.min()[axis]) / size * 1023.0F;
    if (place > 0 && place <= 1023.0F) {
      code |= spread_bits(static_cast<std::uint32_t>(place)) << static_cast<unsigned>(axis);
    }
  }
  return code;
}

Eigen::AlignedBox3f finite_bounds(const Mesh& mesh) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& position : mesh.positions) {
    if (position.allFinite()) box.extend(position);
  }
  return box;
}

/// Triangles in an order in which neighbours in space are neighbours in the list.
std::vector<std::uint32_t> spatial_order(const Mesh& mesh) {
  const Eigen::AlignedBox3f box = finite_bounds(mesh);
  std::vector<std::uint64_t> keys(mesh.triangles.size());
  tbb::parallel_for(std::size_t{0}, keys.size(), [&](std::size_t t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Eigen::Vector3f middle =
        (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3.0F;
    keys[t] = static_cast<std::uint64_t>(morton_code(middle, box)) << 32U | t;
  });
  tbb::parallel_sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order(keys.size());
  std::transform(keys.begin(), keys.end(), order.begin(),
                 [](std::uint64_t key) { return static_cast<std::uint32_t>(key); });
  return order;
}

/// Appends triangles to clusters, beginning a new one when the last is full.
class ClusterBuilder {
 public:
  explicit ClusterBuilder(const Mesh& mesh)
      : mesh_(mesh), owner_(mesh.positions.size(), no_cluster), local_(mesh.positions.size()) {}

  void add(std::uint32_t triangle) {
    if (full(triangle)) finish();
    std::array<std::uint32_t, 3> corners = mesh_.triangles[triangle];
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    for (std::size_t i = 0; i < 3; ++i) result_.corner[i].push_back(local_vertex(corners[i]));
    result_.triangle.push_back(triangle);
    ++current_.triangle_count;
  }

  Clusters take() {
    if (current_.triangle_count > 0) finish();
    while (result_.center[0].size() % padding != 0) {
      for (auto& values : result_.center) values.push_back(0);
      for (auto& values : result_.half_size) values.push_back(0);
    }
    return std::move(result_);
  }

 private:
  static constexpr std::uint32_t no_cluster = ~std::uint32_t{0};

  std::uint32_t cluster_number() const { return static_cast<std::uint32_t>(result_.list.size()); }

  bool full(std::uint32_t triangle) const {
    int vertices = current_.vertex_count;
    for (const std::uint32_t vertex : mesh_.triangles[triangle]) {
      vertices += owner_[vertex] != cluster_number() ? 1 : 0;
    }
    return current_.triangle_count == Cluster::max_triangles || vertices > Cluster::max_vertices;
  }

  std::uint8_t local_vertex(std::uint32_t vertex) {
    if (owner_[vertex] != cluster_number()) {
      owner_[vertex] = cluster_number();
      local_[vertex] = static_cast<std::uint8_t>(current_.vertex_count++);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        result_.position[axis].push_back(mesh_.positions[vertex][static_cast<Eigen::Index>(axis)]);
      }
    }
    return local_[vertex];
  }

  void finish() {
    for (std::size_t axis = 0; axis < 3; ++axis) add_bounds(axis);
    result_.list.push_back(current_);
    pad();
    current_ = {.first_vertex = static_cast<std::uint32_t>(result_.position[0].size()),
                .first_triangle = static_cast<std::uint32_t>(result_.triangle.size())};
  }

  void add_bounds(std::size_t axis) {
    float low = std::numeric_limits<float>::infinity();
    float high = -low;
    bool finite = true;
    for (std::size_t i = current_.first_vertex; i < result_.position[axis].size(); ++i) {
      low = std::min(low, result_.position[axis][i]);
      high = std::max(high, result_.position[axis][i]);
      finite = finite && std::isfinite(result_.position[axis][i]);
    }
    const float center = low / 2 + high / 2;
    const float reach = std::max(high - center, center - low);
    result_.center[axis].push_back(center);
    // A little more than exact, for the rounding of `center`; not a number: never culled.
    result_.half_size[axis].push_back(finite ? reach * 1.000001F
                                             : std::numeric_limits<float>::quiet_NaN());
  }

  void pad() {
    const auto round_up = [](std::size_t size) { return (size + padding - 1) / padding * padding; };
    for (auto& values : result_.position) values.resize(round_up(values.size()));
    for (auto& values : result_.corner) values.resize(round_up(values.size()));
    result_.triangle.resize(round_up(result_.triangle.size()));
  }

  const Mesh& mesh_;
  Clusters result_;
  Cluster current_;
  std::vector<std::uint32_t> owner_;  ///< per vertex of the mesh: the last cluster that has it
  std::vector<std::uint8_t> local_;   ///< and its place there
};

}  // namespace

PreparedMesh::PreparedMesh(const Mesh& mesh) : mesh_(&mesh) {
  check_indices(mesh);
  ClusterBuilder builder(mesh);
  for (const std::uint32_t triangle : spatial_order(mesh)) builder.add(triangle);
  clusters_ = builder.take();
}

}  // namespace rasterlab
