#include "common/projection/draw_mesh.h"

#include <nlohmann/json.hpp>

namespace rasterlab {

nlohmann::json statistics(const DrawCounts& counts) {
  return {{"triangles", counts.triangles},         {"triangles_clipped", counts.clipped},
          {"triangles_outside", counts.outside},   {"pieces_culled", counts.culled},
          {"pieces_without_area", counts.no_area}, {"pieces_off_range", counts.off_range},
          {"pixels_covered", counts.pixels},       {"pixels_hidden", counts.hidden},
          {"pixels_discarded", counts.discarded}};
}

}  // namespace rasterlab
