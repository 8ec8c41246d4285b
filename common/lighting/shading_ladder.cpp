#include "common/lighting/shading.h"

namespace rasterlab {

const std::array<ShadingRung, 3> shading_ladder = {{
    {"flat", &shade_flat, "faces show, more than they differ (Mach bands)"},
    {"gouraud", &shade_gouraud,
     "a highlight smaller than a face is lost, or jumps from vertex to vertex as it moves"},
    {"phong", &shade_phong, "none but what interpolated normals cannot say of a surface"},
}};

}  // namespace rasterlab
