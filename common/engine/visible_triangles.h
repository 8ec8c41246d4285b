// The triangles that are seen in a tile, set up for shading: whatever of that is the same for every
// shader, and so needn't be compiled with each.
//
// What shading needs to know of a triangle is a record of 32-bit words, its slot's:
//
// - its edge functions 1 and 2, which face corners 1 and 2 and are positive inside, at the tile's
//   first pixel, their steps, and their sum's limit, twice the area. Inside, edge functions are
//   between 0 and twice the area; where that is below 2^31, they are exact modulo 2^32, whatever
//   they are at the tile's first pixel. Larger triangles also have them as doubles.
// - the ratios of w, and which side is seen;
// - of each Number of the shader's varyings its value at corner 0; of each, how much it differs at
//   corner 1; of each, how much at corner 2.
#pragma once

#include "common/engine/kernels.h"
#include "common/engine/window_vertex.h"

namespace rasterlab::RASTERLAB_SIMD {

namespace word {
enum : int {
  edge1,
  edge2,
  step1_x,  ///< of edge 1, for a pixel's 1/256 to the right: of 256 units, the 256th part
  step1_y,
  step2_x,
  step2_y,
  area,
  ratio1,  ///< w of corner 0 over w of corner 1
  ratio2,
  front,     ///< 1 when the front is seen
  is_large,  ///< 1 when the doubles count
  unused,
  count,
};
}

/// Edge functions 1 and 2 and twice the area, exactly.
struct Edges {
  Doubles e1, e2, area;
};

/// How to have a shader's varyings as plain floats.
struct CornerVaryings {
  int count;  ///< Numbers
  /// Those of corners first, first + 1 and first + 2 (modulo 3), one corner after the other.
  void (*write)(const void* shader, const Mesh& mesh, std::uint32_t triangle, int first,
                float* corners);

  /// A record's length: whole fours, for load_fours().
  constexpr int record_size() const { return (word::count + 3 * count + 3) / 4 * 4; }
};

class VisibleTriangles {
 public:
  VisibleTriangles(const DrawJob& job, const Tile& tile, const CornerVaryings& varyings,
                   Worker& worker);

  /// All of the draw call that the tile shows.
  void take_all();
  /// A single triangle, for pixels of a tile that is a single block.
  void take_one(std::uint32_t key, BlockMask covered);

  /// Instead of a slot: pixels of earlier draw calls, or of none.
  static constexpr std::int32_t no_slot = -1;
  /// Instead of a block's slot: its pixels have different ones.
  static constexpr std::int32_t mixed = -2;

  /// The slots of a block's 64 pixels.
  const std::int32_t* slots(int block) const { return scratch_.slot.data() + block * 64; }
  std::int32_t block_slot(int block) const {
    return scratch_.block_slot[static_cast<std::size_t>(block)];
  }
  const float* record(std::int32_t slot) const {
    return scratch_.record.data() + slot * varyings_.record_size();
  }

  /// Edge functions for the pixels of one block beginning with its pixel `first`, as many as there
  /// are lanes, given each lane's slot, when one of the triangles is large.
  Edges exact_edges(int block, int first, const std::int32_t* slot) const;

  /// Colours of a block's pixels, packed with red in the lowest byte.
  void write_colors(int block, const std::uint32_t* packed, BlockMask mask) const;

  /// A block's place in the tile.
  struct Place {
    int x, y;
  };
  Place place_of_block(int block) const {
    return {(block & (tile_.blocks_per_row() - 1)) * 8, (block >> blocks_shift_) * 8};
  }

 private:
  struct CornerLanes;
  struct TriangleLanes;

  std::uint32_t triangle_of(std::uint32_t key) const { return key - job_.first_key; }
  float* record(std::size_t slot) {
    return scratch_.record.data() + slot * static_cast<std::size_t>(varyings_.record_size());
  }
  void collect();
  void collect_block(const std::uint32_t* key, std::int32_t* slot);
  std::int32_t slot_of(std::uint32_t key);
  void reserve_slots(std::size_t count);
  void set_up();
  void set_up_some(std::size_t first_slot, std::size_t count);
  CornerLanes corner_order(Ints triangle) const;
  std::array<Number, 3> position(Ints vertex) const;
  void write_geometry(const TriangleLanes& triangles, std::size_t first_slot, std::size_t count);
  void write_differences(float* corners) const;
  void resolve_clipped_pixels();
  void add_part(const ClippedPart& part, const float* corners, std::int32_t whole,
                std::size_t slot);
  bool covers(const std::array<SnappedCorner, 3>& corner, int pixel) const;

  const DrawJob& job_;
  const Mesh& mesh_;
  const Tile& tile_;
  const CornerVaryings& varyings_;
  int blocks_shift_;
  ShadingScratch& scratch_;
  Statistics& statistics_;
};

}  // namespace rasterlab::RASTERLAB_SIMD
