// The table of this instruction set's kernels.
#include "common/engine/simd_kernels.h"

namespace rasterlab::RASTERLAB_SIMD {

extern const EngineKernels kernels;
const EngineKernels kernels = {&find_visible, &bin_clusters, &draw_tile, &write_depth};

}  // namespace rasterlab::RASTERLAB_SIMD
