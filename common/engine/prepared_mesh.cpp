#include "common/engine/prepared_mesh.h"

#include "common/engine/thread_team.h"
#include "common/image/check.h"

#include <bit>
#include <cmath>

namespace rasterlab {

namespace {

constexpr std::uint32_t padding = 16;
/// Triangles that are worth another thread.
constexpr std::size_t per_part = std::size_t{1} << 16U;

std::size_t part_count(std::size_t triangles) {
  return (triangles + per_part - 1) / per_part;
}

/// Calls `work(part)` for each part of so many triangles.
template <class Work>
void for_each_part(ThreadTeam& team, std::size_t parts, const Work& work) {
  team.for_each(static_cast<int>(parts),
                [&](int part, int) { work(static_cast<std::size_t>(part)); });
}

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

/// By parts, which are merged two by two.
void sort(ThreadTeam& team, std::vector<std::uint64_t>& keys) {
  const std::size_t parts = std::bit_ceil(static_cast<std::size_t>(team.size()));
  const auto border = [&](std::size_t part) {
    return keys.begin() + static_cast<std::ptrdiff_t>(keys.size() * part / parts);
  };
  for_each_part(team, parts, [&](std::size_t i) { std::sort(border(i), border(i + 1)); });
  for (std::size_t width = 1; width < parts; width *= 2) {
    for_each_part(team, parts / (2 * width), [&](std::size_t i) {
      const std::size_t first = 2 * width * i;
      std::inplace_merge(border(first), border(first + width), border(first + 2 * width));
    });
  }
}

/// Triangles in an order in which neighbours in space are neighbours in the list.
std::vector<std::uint32_t> spatial_order(ThreadTeam& team, const Mesh& mesh) {
  const Eigen::AlignedBox3f box = finite_bounds(mesh);
  std::vector<std::uint64_t> keys(mesh.triangles.size());
  for_each_part(team, part_count(keys.size()), [&](std::size_t part) {
    const std::size_t end = std::min((part + 1) * per_part, keys.size());
    for (std::size_t t = part * per_part; t < end; ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      const Eigen::Vector3f middle =
          (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3.0F;
      keys[t] = static_cast<std::uint64_t>(morton_code(middle, box)) << 32U | t;
    }
  });
  sort(team, keys);
  std::vector<std::uint32_t> order(keys.size());
  std::transform(keys.begin(), keys.end(), order.begin(),
                 [](std::uint64_t key) { return static_cast<std::uint32_t>(key); });
  return order;
}

/// Per vertex of the cluster being built, its place there.
class LocalVertices {
 public:
  void clear() {
    vertex_.fill(none);
    count_ = 0;
  }

  int count() const { return count_; }
  bool has(std::uint32_t vertex) const { return vertex_[find(vertex)] == vertex; }

  /// The place of a vertex; a new one's is the number of those before.
  std::uint8_t place_of(std::uint32_t vertex) {
    const std::size_t slot = find(vertex);
    if (vertex_[slot] != vertex) {
      vertex_[slot] = vertex;
      place_[slot] = static_cast<std::uint8_t>(count_++);
    }
    return place_[slot];
  }

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  static constexpr std::size_t size = 512;  // more than twice as many as there are vertices

  /// Where in the hash table the vertex is, or would be.
  std::size_t find(std::uint32_t vertex) const {
    std::size_t slot = (vertex * 2654435769U) >> 23U;
    while (vertex_[slot] != vertex && vertex_[slot] != none) slot = (slot + 1) % size;
    return slot;
  }

  std::array<std::uint32_t, size> vertex_;
  std::array<std::uint8_t, size> place_;
  int count_ = 0;
};

/// Puts triangles into clusters, beginning a new one when the last is full.
class ClusterBuilder {
 public:
  explicit ClusterBuilder(const Mesh& mesh) : mesh_(mesh) { local_.clear(); }

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
    return std::move(result_);
  }

 private:
  bool full(std::uint32_t triangle) const {
    int vertices = local_.count();
    for (const std::uint32_t vertex : mesh_.triangles[triangle]) {
      vertices += local_.has(vertex) ? 0 : 1;
    }
    return current_.triangle_count == Cluster::max_triangles || vertices > Cluster::max_vertices;
  }

  std::uint8_t local_vertex(std::uint32_t vertex) {
    const int before = local_.count();
    const std::uint8_t place = local_.place_of(vertex);
    for (std::size_t axis = 0; axis < 3 && local_.count() > before; ++axis) {
      result_.position[axis].push_back(mesh_.positions[vertex][static_cast<Eigen::Index>(axis)]);
    }
    return place;
  }

  void finish() {
    current_.vertex_count = static_cast<std::uint16_t>(local_.count());
    for (std::size_t axis = 0; axis < 3; ++axis) add_bounds(axis);
    add_facing();
    result_.list.push_back(current_);
    pad();
    current_ = {.first_vertex = static_cast<std::uint32_t>(result_.position[0].size()),
                .first_triangle = static_cast<std::uint32_t>(result_.triangle.size())};
    local_.clear();
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

  Eigen::Vector3d position(std::size_t corner, std::size_t triangle) const {
    const std::size_t vertex = current_.first_vertex + result_.corner[corner][triangle];
    return {result_.position[0][vertex], result_.position[1][vertex], result_.position[2][vertex]};
  }

  void add_facing() {
    std::array<Eigen::Vector3d, Cluster::max_triangles> unit;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double smallest = std::numeric_limits<double>::infinity();
    double thinnest = smallest;
    for (std::size_t i = 0; i < current_.triangle_count; ++i) {
      const std::size_t triangle = current_.first_triangle + i;
      const Eigen::Vector3d a = position(1, triangle) - position(0, triangle);
      const Eigen::Vector3d b = position(2, triangle) - position(0, triangle);
      const Eigen::Vector3d normal = a.cross(b);
      const double area = normal.norm();
      const double longest =
          std::sqrt(std::max({a.squaredNorm(), b.squaredNorm(), (a - b).squaredNorm()}));
      smallest = std::min(smallest, area);
      thinnest = std::min(thinnest, area / longest);
      unit[i] = normal / area;  // not a number when there is no area
      sum += unit[i];
    }
    const Eigen::Vector3d axis = sum.normalized();
    double spread = 0;
    bool known = true;
    for (std::size_t i = 0; i < current_.triangle_count; ++i) {
      const double distance = (unit[i] - axis).norm();
      known = known && std::isfinite(distance);
      spread = std::max(spread, distance);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      result_.facing.axis[i].push_back(static_cast<float>(axis[static_cast<Eigen::Index>(i)]));
    }
    // Rounded so that what is concluded from them stays true.
    result_.facing.spread.push_back(known ? static_cast<float>(spread) + 1e-5F
                                          : std::numeric_limits<float>::quiet_NaN());
    result_.facing.smallest.push_back(static_cast<float>(smallest) * 0.9999F);
    result_.facing.thinnest.push_back(static_cast<float>(thinnest) * 0.9999F);
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
  LocalVertices local_;
};

// ---------------------------------------------------------------------------------------------
// Clusters of parts of the mesh, and the parts put together

/// Calls `visit(array of a, the same array of b)` for all arrays that have an entry per cluster.
template <class A, class B, class Visit>
void for_each_cluster_array(A& a, B& b, const Visit& visit) {
  visit(a.list, b.list);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    visit(a.center[axis], b.center[axis]);
    visit(a.half_size[axis], b.half_size[axis]);
    visit(a.facing.axis[axis], b.facing.axis[axis]);
  }
  visit(a.facing.spread, b.facing.spread);
  visit(a.facing.smallest, b.facing.smallest);
  visit(a.facing.thinnest, b.facing.thinnest);
}
template <class A, class B, class Visit>
void for_each_vertex_array(A& a, B& b, const Visit& visit) {
  for (std::size_t axis = 0; axis < 3; ++axis) visit(a.position[axis], b.position[axis]);
}
template <class A, class B, class Visit>
void for_each_triangle_array(A& a, B& b, const Visit& visit) {
  for (std::size_t i = 0; i < 3; ++i) visit(a.corner[i], b.corner[i]);
  visit(a.triangle, b.triangle);
}

/// Where in the whole a part's arrays begin.
struct Offsets {
  std::size_t cluster = 0;
  std::size_t vertex = 0;
  std::size_t triangle = 0;
};

void copy_part(const Clusters& part, const Offsets& offsets, Clusters& whole) {
  const auto copy_to = [](std::size_t offset) {
    return [offset](auto& to, const auto& from) {
      std::copy(from.begin(), from.end(), to.begin() + static_cast<std::ptrdiff_t>(offset));
    };
  };
  for_each_cluster_array(whole, part, copy_to(offsets.cluster));
  for_each_vertex_array(whole, part, copy_to(offsets.vertex));
  for_each_triangle_array(whole, part, copy_to(offsets.triangle));
  for (std::size_t i = 0; i < part.list.size(); ++i) {
    Cluster& cluster = whole.list[offsets.cluster + i];
    cluster.first_vertex += static_cast<std::uint32_t>(offsets.vertex);
    cluster.first_triangle += static_cast<std::uint32_t>(offsets.triangle);
  }
}

/// Empties `parts`.
Clusters join(ThreadTeam& team, std::vector<Clusters>& parts) {
  std::vector<Offsets> begin;
  Offsets size;
  for (const Clusters& part : parts) {
    begin.push_back(size);
    size.cluster += part.list.size();
    size.vertex += part.position[0].size();
    size.triangle += part.triangle.size();
  }
  Clusters whole;
  const auto resize_to = [](std::size_t count) {
    return [count](auto& array, const auto&) { array.resize(count); };
  };
  const std::size_t padded = (size.cluster + padding - 1) / padding * padding;
  for_each_cluster_array(whole, whole, resize_to(padded));
  for_each_vertex_array(whole, whole, resize_to(size.vertex));
  for_each_triangle_array(whole, whole, resize_to(size.triangle));
  whole.list.resize(size.cluster);
  for_each_part(team, parts.size(), [&](std::size_t i) {
    copy_part(parts[i], begin[i], whole);
    parts[i] = {};
  });
  return whole;
}

/// The same whatever the number of threads.
Clusters make_clusters(const Mesh& mesh) {
  const std::size_t part_total = part_count(mesh.triangles.size());
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  ThreadTeam team(static_cast<int>(std::clamp(part_total, std::size_t{1}, cores)));
  const std::vector<std::uint32_t> order = spatial_order(team, mesh);
  std::vector<Clusters> parts(part_total);
  for_each_part(team, parts.size(), [&](std::size_t i) {
    ClusterBuilder builder(mesh);
    const std::size_t end = std::min((i + 1) * per_part, order.size());
    for (std::size_t t = i * per_part; t < end; ++t) builder.add(order[t]);
    parts[i] = builder.take();
  });
  return join(team, parts);
}

}  // namespace

PreparedMesh::PreparedMesh(const Mesh& mesh) : mesh_(&mesh) {
  check_indices(mesh);
  clusters_ = make_clusters(mesh);
}

}  // namespace rasterlab
