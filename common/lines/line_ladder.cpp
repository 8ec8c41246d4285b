#include "common/lines/line_ladder.h"

#include "common/lines/bresenham.h"
#include "common/lines/column_steps.h"
#include "common/lines/fixed_steps.h"
#include "common/lines/hoisted_slope.h"
#include "common/lines/split_fraction.h"
#include "common/lines/swapped_columns.h"

namespace rasterlab {

const std::array<LineRung, 7> line_ladder = {{
    {"ten_steps", &line_ten_steps, "gaps beyond 10 pixels, repeated pixels below, p1 never drawn"},
    {"hundred_steps", &line_hundred_steps,
     "gaps beyond 100 pixels, repeated pixels below, p1 never drawn"},
    {"column_steps", &line_column_steps, "gaps where steep, nothing from right to left"},
    {"swapped_columns", &line_swapped_columns, "up to a pixel off: cut, not rounded"},
    {"hoisted_slope", &line_hoisted_slope, "up to a pixel off, and rounding adds up along the way"},
    {"split_fraction", &line_split_fraction,
     "more than half a pixel off after some thousand pixels"},
    {"bresenham", &line_bresenham, "none"},
}};

}  // namespace rasterlab
