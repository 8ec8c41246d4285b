// The kernels that each instruction set's namespace has.
#pragma once

#include "common/engine/kernels.h"

namespace rasterlab::RASTERLAB_SIMD {

void find_visible(const DrawJob& job, std::uint32_t begin, std::uint32_t end,
                  std::vector<VisibleCluster>& visible, Statistics& statistics);
void bin_clusters(const DrawJob& job, std::span<const VisibleCluster> clusters, Worker& worker);
void draw_tile(const DrawJob& job, const Tile& tile, std::span<Worker> workers, Worker& worker);
void write_depth(const Tile& tile, float* depth);

}  // namespace rasterlab::RASTERLAB_SIMD
