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
  /// Shades pixels of one triangle as it is drawn. The tile is one block of the picture; where it
  /// has a place for colours, these are written. Returns the pixels that aren't discarded.
  BlockMask (*shade_now)(const DrawJob& job, const Tile& block, std::uint32_t key, BlockMask pixels,
                         Worker& worker);
  bool may_discard;
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
  bool spares_undisputed_blocks() const { return skip.undisputed_blocks && !shades_blocks(); }
  /// Pixels get their colours as triangles are drawn, not when all are.
  bool colors_blocks() const { return shading != nullptr && !skip.hidden_fragments; }
  /// The shader runs as triangles are drawn, block by block: for that, or because it may discard.
  bool shades_blocks() const {
    return colors_blocks() || (shading != nullptr && shading->may_discard);
  }
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
