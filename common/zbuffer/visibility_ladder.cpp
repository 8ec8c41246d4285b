#include "common/zbuffer/visibility.h"

namespace rasterlab {

const std::array<VisibilityRung, 6> visibility_ladder = {{
    {"draw_order", &seen_by_draw_order, "the last one drawn wins, near or far"},
    {"painter", &seen_by_painter,
     "sorts whole triangles: wrong where they pass through each other or overlap in a ring"},
    {"zbuffer_16", &seen_by_zbuffer_16,
     "65536 depths, nearly all of them close to the near plane: far ones tie"},
    {"zbuffer_24", &seen_by_zbuffer_24,
     "ties 256 times finer than those of 16 bit, but far ones still tie"},
    {"zbuffer_float", &seen_by_zbuffer_float,
     "no finer than 24 bit: a float's fine steps are around 0, where the near plane needs none"},
    {"zbuffer_reversed", &seen_by_zbuffer_reversed,
     "equally fine at all distances; confuses only what is within about 1e-7 of its distance"},
}};

}  // namespace rasterlab
