// The parts of the engine that are compiled once per instruction set, as a table of functions.
#pragma once

#include "common/engine/bins.h"
#include "common/engine/clip_transform.h"
#include "common/engine/engine_options.h"
#include "common/engine/frame_access.h"
#include "common/engine/prepared_mesh.h"
#include "common/mesh/cull.h"

#include <cstdint>
#include <span>

namespace rasterlab {

struct DrawJob;

/// What is compiled once per instruction set and shader.
struct ShadingKernels {
  /// Shades the pixels of a tile that this draw call owns.
  void (*shade_tile)(const DrawJob& job, const Tile& tile, Worker& worker);
  /// Of the pixels `covered` of a block of the picture at (left, top), those the shader doesn't
  /// discard for this triangle. nullptr for a shader that never discards.
  BlockMask (*not_discarded)(const DrawJob& job, std::uint32_t key, int left, int top,
                             BlockMask covered, Worker& worker);
};

/// A draw call as the kernels see it.
struct DrawJob {
  const PreparedMesh* mesh;
  ClipTransform transform;
  Cull cull;  ///< as seen in the picture: `mirrored` is taken care of
  bool mirrored;
  Skips skip;
  Keep keep;
  std::uint32_t first_key;  ///< of triangle 0; triangle t has first_key + t
  const void* shader;
  const ShadingKernels* shading;  ///< nullptr: depth only
  FrameAccess frame;

  /// Nobody asks which triangle a pixel shows.
  bool wants_depth_only() const {
    return shading == nullptr && keep != Keep::everything && skip.unwanted_depth;
  }
  /// Whether pixels need no depth where triangles don't compete for them (undisputed_blocks.h).
  bool spares_undisputed_blocks() const { return skip.undisputed_blocks && !discards(); }
  bool discards() const { return shading != nullptr && shading->not_discarded != nullptr; }
};

/// What of a mesh's clusters is to be drawn, and how near it is at most.
struct VisibleCluster {
  std::uint32_t index;
  float nearest;  ///< reversed depth; infinite when unknown
};

struct EngineKernels {
  /// Of clusters [begin, end), begin a multiple of 16, appends those that may be seen.
  void (*find_visible)(const DrawJob& job, std::uint32_t begin, std::uint32_t end,
                       std::vector<VisibleCluster>& visible, Statistics& statistics);
  /// Transforms the clusters' vertices and puts what may be seen of their triangles into bins.
  void (*bin_clusters)(const DrawJob& job, std::span<const VisibleCluster> clusters,
                       Worker& worker);
  /// Draws the depth and keys of what all workers put into one tile's bins.
  void (*draw_tile)(const DrawJob& job, const Tile& tile, std::span<Worker> workers,
                    Worker& worker);
  /// Writes a tile's depths to where nothing needs them soon.
  void (*write_depth)(const Tile& tile, float* depth);
};

}  // namespace rasterlab
