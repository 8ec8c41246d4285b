#include "common/engine/statistics.h"

#include <array>
#include <utility>

#include <nlohmann/json.hpp>

namespace rasterlab {

namespace {

struct Field {
  const char* name;
  std::uint64_t Statistics::*value;
};

constexpr std::array<Field, 22> fields = {{
    {"clusters", &Statistics::clusters},
    {"clusters_outside", &Statistics::clusters_outside},
    {"clusters_facing_away", &Statistics::clusters_facing_away},
    {"clusters_hidden", &Statistics::clusters_hidden},
    {"vertices", &Statistics::vertices},
    {"vertices_skipped", &Statistics::vertices_skipped},
    {"triangles", &Statistics::triangles},
    {"triangles_culled", &Statistics::triangles_culled},
    {"triangles_without_area", &Statistics::triangles_without_area},
    {"triangles_missed", &Statistics::triangles_missed},
    {"triangles_hidden", &Statistics::triangles_hidden},
    {"triangles_clipped", &Statistics::triangles_clipped},
    {"triangles_binned", &Statistics::triangles_binned},
    {"blocks_hidden", &Statistics::blocks_hidden},
    {"tiles_drawn", &Statistics::tiles_drawn},
    {"tiles_untouched", &Statistics::tiles_untouched},
    {"tiles_not_kept", &Statistics::tiles_not_kept},
    {"blocks_undisputed", &Statistics::blocks_undisputed},
    {"pixels_shaded", &Statistics::pixels_shaded},
    {"pixels_asked", &Statistics::pixels_asked},
    {"derivatives_unread", &Statistics::derivatives_unread},
    {"triangles_shaded", &Statistics::triangles_shaded},
}};

}  // namespace

Statistics& Statistics::operator+=(const Statistics& other) {
  for (const Field& field : fields) this->*field.value += other.*field.value;
  milliseconds += other.milliseconds;
  return *this;
}

nlohmann::json to_json(const Statistics& statistics) {
  nlohmann::json object = {{"milliseconds", statistics.milliseconds}};
  for (const Field& field : fields) object[field.name] = statistics.*field.value;
  return object;
}

}  // namespace rasterlab
