#include "common/mesh/mesh.h"

#include <bit>
#include <unordered_map>

namespace rasterlab {
namespace {

struct PositionHash {
  std::size_t operator()(const Eigen::Vector3f& position) const {
    std::uint64_t hash = 0;
    for (const float coordinate : position) {
      const float without_sign_of_zero = coordinate + 0.0F;
      hash = (hash ^ std::bit_cast<std::uint32_t>(without_sign_of_zero)) * 0x9E3779B97F4A7C15U;
      hash ^= hash >> 32U;
    }
    return hash;
  }
};

}  // namespace

Eigen::AlignedBox3f bounding_box(const Mesh& mesh) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& position : mesh.positions) box.extend(position);
  return box;
}

std::vector<std::uint32_t> join_by_position(const std::vector<Eigen::Vector3f>& positions) {
  std::unordered_map<Eigen::Vector3f, std::uint32_t, PositionHash> first_at;
  first_at.reserve(positions.size());
  std::vector<std::uint32_t> first;
  first.reserve(positions.size());
  for (const Eigen::Vector3f& position : positions) {
    const auto vertex = static_cast<std::uint32_t>(first.size());
    first.push_back(first_at.try_emplace(position, vertex).first->second);
  }
  return first;
}

}  // namespace rasterlab
