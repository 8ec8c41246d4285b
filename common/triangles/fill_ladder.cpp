#include "common/triangles/fill_ladder.h"

#include "common/triangles/fill_barycentric_matrix.h"
#include "common/triangles/fill_bounding_box.h"
#include "common/triangles/fill_edge_functions.h"
#include "common/triangles/fill_half_sweep.h"
#include "common/triangles/fill_scanline.h"
#include "common/triangles/fill_sweep.h"

namespace rasterlab {

const std::array<FillRung, 6> fill_ladder = {{
    {"half_sweep", &fill_half_sweep, "half the triangle is missing"},
    {"scanline", &fill_scanline, "shared sides drawn twice, up to a pixel too large"},
    {"sweep", &fill_sweep, "shared sides drawn twice, up to a pixel off"},
    {"bounding_box", &fill_bounding_box, "shared sides drawn twice, up to a pixel off"},
    {"barycentric_matrix", &fill_barycentric_matrix,
     "centres on a shared side drawn twice or not at all"},
    {"edge_functions", &fill_edge_functions, "none"},
}};

}  // namespace rasterlab
