// The triangles that are seen in a tile, set up for shading: whatever of that is the same for every
// shader, and so needn't be compiled with each.
//
// Each triangle gets a slot, which it keeps for the next tiles, since it may reach there. A block
// of 8×8 pixels is a list of parts: a slot, and which pixels show its triangle; or it has its
// pixels on the tile's list of scattered ones, each with a slot.
//
// What shading needs to know of a triangle is a record of 32-bit words, its slot's:
//
// - its edge functions 1 and 2, which face corners 1 and 2 and are positive inside, at the
//   picture's first pixel, their steps, and their sum's limit, twice the area. Inside, edge
//   functions are between 0 and twice the area; where 32 bits hold that, and all that they are in a
//   block a part of which is inside, they are exact modulo 2^32, whatever they are at the first
//   pixel. Larger triangles also have them as doubles.
// - the ratios of w;
// - of each Number of the shader's varyings its value at corner 0; of each, how much it differs at
//   corner 1; of each, how much at corner 2.
#pragma once

#include "common/engine/blocks.h"
#include "common/engine/window_vertex.h"

#include <span>

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
  count,
};
}

/// How to have a shader's varyings as plain floats.
struct CornerVaryings {
  int count;         ///< Numbers
  bool derivatives;  ///< whether the shader reads them: else nobody needs WeightsInBlock::inverse
  /// Those of corners first, first + 1 and first + 2 (modulo 3), one corner after the other.
  void (*write)(const void* shader, const Mesh& mesh, std::uint32_t triangle, int first,
                float* corners);
  /// As in a record: of the second and third corner, differences from the first in place of the
  /// values. Returns whether any isn't zero.
  bool (*write_record)(const void* shader, const Mesh& mesh, std::uint32_t triangle, int first,
                       float* numbers);

  /// A record's length: whole fours, for load_fours().
  constexpr int record_size() const { return (word::count + 3 * count + 3) / 4 * 4; }
};

/// Of some pixels, each in the triangle it sees: what shading needs to know of where it is there.
struct PixelWeights {
  Number b1;       ///< of corner 1, perspective-correct
  Number b2;       ///< of corner 2
  Number inverse;  ///< 1 / (q0 + q1 + q2), for derivatives
};

/// Perspective-correct weights, from exact edge functions: with q_i = E_i · w0/w_i they are
/// q_i / (q_0 + q_1 + q_2), computed in double. They become floats last, so they are right to about
/// a unit in the last place for slivers and for any ratio of w.
struct Edges {
  Doubles e0;  ///< what the others leave of twice the area
  Doubles e1, e2;

  PixelWeights weights(Doubles ratio1, Doubles ratio2) const {
    const Doubles q1 = e1 * ratio1;
    const Doubles q2 = e2 * ratio2;
    const Doubles inverse = Doubles(1) / (e0 + (q1 + q2));
    return {to_number(q1 * inverse), to_number(q2 * inverse), to_number(inverse)};
  }
};

/// The weights of a block's pixels. They are computed ahead for all of them: a division of doubles
/// takes long, and so many can be on their way at once, none of them waited for by a shader.
struct WeightsInBlock {
  using OfPixels = std::array<float, 64>;
  alignas(64) OfPixels b1;
  alignas(64) OfPixels b2;
  alignas(64) OfPixels inverse;

  PixelWeights at(int first) const {
    const auto i = static_cast<std::size_t>(first);
    return {load(&b1[i]), load(&b2[i]), load(&inverse[i])};
  }
  template <bool for_derivatives = true>
  void set(int first, const PixelWeights& weights) {
    const auto i = static_cast<std::size_t>(first);
    store(weights.b1, &b1[i]);
    store(weights.b2, &b2[i]);
    if constexpr (for_derivatives) store(weights.inverse, &inverse[i]);
  }
};

class EachRecord;
struct RecordNumbers;

class VisibleTriangles {
 public:
  VisibleTriangles(const DrawJob& job, const Tile& tile, const CornerVaryings& varyings,
                   Worker& worker);

  /// All of the draw call that the tile shows.
  void take_all();
  /// A single triangle, for pixels of a tile that is a single block.
  void take_one(std::uint32_t key, BlockMask covered);

  /// Slots before this one are of triangles that tiles before had set up.
  std::int32_t first_new_slot() const { return static_cast<std::int32_t>(first_new_); }
  std::int32_t slot_count() const { return static_cast<std::int32_t>(scratch_.slot_count); }
  const float* record(std::int32_t slot) const {
    return scratch_.record.data() + slot * varyings_.record_size();
  }
  ShadedTriangle& triangle(std::int32_t slot) const {
    return scratch_.triangle[static_cast<std::size_t>(slot)];
  }

  /// Whether any of them are the same all over.
  bool any_constant() const { return scratch_.any_constant; }

  /// What a block shows of the draw call: each triangle once.
  std::span<const VisiblePart> parts(int block) const {
    const auto b = static_cast<std::size_t>(block);
    const std::size_t first = b == 0 ? 0 : scratch_.parts_end[b - 1];
    return std::span(scratch_.part).subspan(first, scratch_.parts_end[b] - first);
  }

  /// What other blocks show of it.
  ScatteredPixels& scattered() const { return scratch_.scattered; }

  /// Which side of a triangle is seen. Asked for one that is the same all over: others have it.
  bool shows_front(std::int32_t slot) const;

  /// Weights of a block that sees one or two triangles.
  void weigh_few(std::span<const VisiblePart> parts, int block, WeightsInBlock& weights) const;
  /// Of `parts`, each pixel from `first` to before `end` has the number of the one it sees.
  void number_pixels(std::span<const VisiblePart> parts, int first, int end,
                     RecordNumbers& numbers) const;
  /// Weights of these pixels, whose records are in a table.
  void weigh_each(std::span<const VisiblePart> parts, const std::array<float, 16>* words,
                  const RecordNumbers& numbers, int block, int first, int end,
                  WeightsInBlock& weights) const;

  /// Of scattered pixels from `first` on, as many as a block has.
  void weigh_scattered(std::size_t first, WeightsInBlock& weights) const;
  /// Scattered pixels that see triangles of one colour get it, and are on the list no more.
  void paint_scattered();

  /// Asks for the memory of the colours of a row of blocks, so that it is near when they are
  /// written.
  void prefetch_colors(int row_of_blocks) const;
  /// Of the tile's.
  int blocks_per_row() const { return tile_.blocks_per_row(); }

  /// Of a block's pixels, those in the picture: tiles may reach beyond it.
  BlockMask inside(int block) const;

  /// Colours of a block's pixels that are in the picture, packed with red in the lowest byte.
  void write_colors(int block, const std::uint32_t* packed, BlockMask mask) const;

 private:
  struct CornerLanes;
  struct TriangleLanes;

  /// A triangle that a clipped one consists of.
  struct PartOfClipped {
    std::int32_t whole;  ///< slots
    std::int32_t slot;
    std::array<SnappedCorner, 3> corner;
  };
  struct EdgeWalk;

  EdgeWalk walk(std::int32_t slot, int block) const;
  template <bool for_derivatives>
  void weigh_few(std::span<const VisiblePart> parts, int block, WeightsInBlock& weights) const;
  template <bool for_derivatives>
  void weigh_one(const VisiblePart& part, int block, WeightsInBlock& weights) const;
  template <bool for_derivatives>
  void weigh_two(const VisiblePart& part, const VisiblePart& other, int block,
                 WeightsInBlock& weights) const;
  void weigh_large(const VisiblePart& part, int block, WeightsInBlock& weights) const;
  PixelWeights weights_of_each(const EachRecord& records, int block, int first) const;
  void replace_large(const std::int32_t* slot, Ints x, Ints y, Edges& edges) const;
  std::uint32_t triangle_of(std::uint32_t key) const { return key - job_.first_key; }
  float* record(std::size_t slot) {
    return scratch_.record.data() + slot * static_cast<std::size_t>(varyings_.record_size());
  }
  PixelOffset in_picture(PixelOffset in_tile) const {
    return {tile_.left + in_tile.x, tile_.top + in_tile.y};
  }
  void forget_or_keep();
  void collect();
  void collect_undisputed(int block);
  void collect_block(int block);
  bool are_scattered(int block, BlockMask seen) const;
  void add_scattered(int block, BlockMask seen);
  void find_slots_of_scattered();
  std::int32_t slot_of(std::uint32_t key);
  void find_slots(std::span<std::int32_t> values);
  void reserve_keys(std::size_t more);
  void reserve_slots(std::size_t count);
  void set_up();
  void fetch_vertices(std::size_t first_slot, std::size_t count);
  void set_up_some(std::size_t first_slot, std::size_t count);
  CornerLanes corner_order(Ints triangle) const;
  std::array<Number, 3> position(Ints vertex) const;
  TriangleLanes in_window(const CornerLanes& corners) const;
  ClippedPolygon clipped(const CornerLanes& corners) const;
  void write_geometry(const TriangleLanes& triangles, std::size_t first_slot, std::size_t count);
  void write_words(const std::array<Ints, word::count>& words, std::size_t first_slot,
                   std::size_t count);
  void resolve_clipped_pixels();
  void divide_clipped_triangles(std::span<const PartOfClipped> clipped);
  void divide_clipped_scattered(std::span<const PartOfClipped> clipped);
  void add_slot(const ClippedPart& part, const float* corners);
  BlockMask covered(const std::array<SnappedCorner, 3>& corner, int block) const;

  const DrawJob& job_;
  const Mesh& mesh_;
  const Tile& tile_;
  const CornerVaryings& varyings_;
  std::size_t first_new_ = 0;  ///< slot
  ShadingScratch& scratch_;
  Statistics& statistics_;
};

}  // namespace rasterlab::RASTERLAB_SIMD
