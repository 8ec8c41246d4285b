// What passes from the front end, which works by cluster, to the back end, which works by tile.
#pragma once

#include "common/engine/frame_access.h"
#include "common/engine/scattered_pixels.h"
#include "common/engine/statistics.h"
#include "common/image/huge_pages.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <vector>

namespace rasterlab {

/// Memory that is only ever freed as a whole.
class Arena {
 public:
  template <class T>
  T* make() {
    static_assert(alignof(T) <= alignment && std::is_trivially_destructible_v<T>);
    used_ = (used_ + alignof(T) - 1) / alignof(T) * alignof(T);
    if (used_ + sizeof(T) > block_size) next_block();
    void* place = blocks_[current_].get() + used_;
    used_ += sizeof(T);
    return ::new (place) T;
  }

  /// Forgets what was made; keeps the memory for next time.
  void reset() {
    current_ = 0;
    used_ = blocks_.empty() ? block_size : 0;
  }

  /// In use.
  std::size_t bytes() const { return blocks_.empty() ? 0 : current_ * block_size + used_; }

 private:
  static constexpr std::size_t alignment = 64;
  static constexpr std::size_t block_size = std::size_t{1} << 21;  // a large page

  void next_block() {
    current_ = blocks_.empty() ? 0 : current_ + 1;
    if (current_ == blocks_.size()) blocks_.emplace_back(block_size);
    used_ = 0;
  }

  std::vector<HugePages<std::byte>> blocks_;
  std::size_t current_ = 0;
  std::size_t used_ = block_size;
};

/// A triangle of a few pixels: eight words, the last of no use, that are written and read at once.
/// Coordinates count from the corner of a tile in 1/256 pixel, x in the low half, y in the high
/// half. Corners are in the order that makes the area positive.
struct alignas(32) PackedTriangle {
  std::array<std::uint32_t, 3> corner;
  std::array<float, 3> depth;
  std::uint32_t key;
};
static_assert(sizeof(PackedTriangle) == 8 * sizeof(std::uint32_t));

/// Those that reach into one tile.
struct PackedTriangles {
  static constexpr int capacity = 16;
  static constexpr int max_small_side = 4;     ///< in samples: drawn one per lane
  static constexpr int max_compact_side = 16;  ///< in samples: drawn vector by vector
  static constexpr int max_medium_side = 63;   ///< in pixels, so that halves of a word are enough

  PackedTriangles* next;
  std::int32_t count;
  std::array<PackedTriangle, capacity> triangle;
};

/// Any other triangle, in the picture's coordinates, 1/256 pixel; area positive. Three times four
/// words, so that a lane's are read in three, all of one cache line.
///
/// Slivers among them are a few pixels wide where they are widest, along the axis they reach less
/// far on, and of any length as long as the box around them has less than 2^31 square units: then
/// all edge functions in it fit 32 bits.
struct alignas(64) LargeTriangle {
  static constexpr int max_thin_width = 3;

  std::array<std::int32_t, 3> x;
  std::array<std::int32_t, 3> y;
  std::array<float, 3> depth;
  std::uint32_t key;
  std::int32_t thin_width = 0;  ///< of a sliver, in whole pixels

  /// Its area, in pixels.
  std::int64_t pixels() const {
    const auto cross = [](std::int64_t ax, std::int64_t ay, std::int64_t bx, std::int64_t by) {
      return ax * by - ay * bx;
    };
    return cross(x[1] - x[0], y[1] - y[0], x[2] - x[0], y[2] - y[0]) / (2 * 256 * 256);
  }
};

/// Those that reach into one tile.
struct alignas(64) LargeTriangles {
  static constexpr int capacity = 30;

  LargeTriangles* next;
  std::int32_t count;
  std::array<const LargeTriangle*, capacity> triangle;
};

/// A sliver in a tile, and which of the tile's lines it may have samples on.
struct ThinInTile {
  const LargeTriangle* triangle;
  std::uint8_t first = 0;
  std::uint8_t last = 0;
  std::uint16_t likeness = 0;  ///< its place among others
};

/// What one worker found to draw in one tile, in that order: nearer clusters first, so that what
/// follows meets a filled tile.
template <class Chunk>
struct ChunkList {
  Chunk* first = nullptr;
  Chunk* last = nullptr;

  /// The last chunk, or a new one when that is full.
  Chunk& with_room(Arena& arena) {
    if (last == nullptr || last->count == Chunk::capacity) {
      auto* chunk = arena.make<Chunk>();
      chunk->next = nullptr;
      chunk->count = 0;
      (last == nullptr ? first : last->next) = chunk;
      last = chunk;
    }
    return *last;
  }
};

struct TileBin {
  ChunkList<PackedTriangles> small;
  ChunkList<PackedTriangles> medium;
  ChunkList<LargeTriangles> thin;
  ChunkList<LargeTriangles> large;

  /// How much there is to draw: 1 for a small triangle, more for what may hide others, less for
  /// slivers, which hardly do.
  std::uint32_t worth = 0;
  static constexpr std::uint32_t worth_of_medium = 8;
  /// One for four of its pixels, at most as many as a tile has.
  static std::uint32_t worth_of_large(const LargeTriangle& triangle) {
    return static_cast<std::uint32_t>(std::clamp<std::int64_t>(triangle.pixels() / 4, 1, 1000));
  }
};

/// Per pixel of a tile its depth's bits above the complement of its triangle's number, so that of
/// two triangles the one that is seen has the larger word.
using PixelWords = std::array<std::int64_t, 64 * 64>;

struct NearTriangle {
  float nearest;  ///< no depth of it is more
  const LargeTriangle* triangle;
};

/// The pixels of a block that show one triangle.
struct VisiblePart {
  std::uint64_t mask;
  std::int32_t slot;  ///< the triangle's
};

/// What shading knows of a triangle besides its record (visible_triangles.h).
struct ShadedTriangle {
  std::array<double, 3>
      edges;            ///< edge functions 1 and 2 at the picture's first pixel, twice the area
  bool is_large;        ///< 32 bits aren't enough for them
  bool front;           ///< its front is seen; unknown of a constant one
  bool is_constant;     ///< all corners have the same varyings, so all its pixels …
  bool is_discarded;    ///< … are discarded or have …
  std::uint32_t color;  ///< … this colour, packed
};

/// Room for shading a tile, kept from one to the next (visible_triangles.h).
struct ShadingScratch {
  std::vector<VisiblePart> part;         ///< block after block
  std::vector<std::uint32_t> parts_end;  ///< per block
  std::size_t slot_count = 0;
  std::vector<std::uint32_t> key;           ///< per slot: the triangle that has it; 0: part of one
  std::vector<std::uint32_t> clipped;       ///< slots of triangles that had to be clipped
  std::vector<std::uint32_t> table;         ///< hash table from key to slot
  std::vector<std::int32_t> slot_of_plane;  ///< per plane of undisputed blocks; −1: none yet
  std::vector<float> record;                ///< per slot
  std::vector<ShadedTriangle> triangle;     ///< per slot
  ScatteredPixels scattered;                ///< of blocks that have no parts
  bool any_large = false;                   ///< triangles, as ShadedTriangle::is_large
  bool any_constant = false;                ///< as ShadedTriangle::is_constant
  bool likely_constant = false;             ///< the last triangles set up were
  float fetched;  ///< of no use but that what it was made of had to be read

  /// Triangles have no slots any more.
  void forget() {
    slot_count = 0;
    clipped.clear();
    any_large = false;
    any_constant = false;
    likely_constant = false;
  }
};

/// What belongs to one thread, in cache lines of its own.
struct alignas(64) Worker {
  Arena arena;
  std::vector<TileBin> bins;
  Statistics statistics;
  ShadingScratch scratch;
  std::vector<NearTriangle> near_first;  ///< room for sorting a tile's large triangles …
  std::vector<ThinInTile> thin_in_tile;  ///< … and its slivers, …
  std::vector<ThinInTile> thin_sorted;
  alignas(64) PixelWords words;  ///< … and for what these draw
  TileMemory passing_tile;       ///< for one that the framebuffer doesn't keep

  void begin(int tiles) {
    arena.reset();
    bins.assign(static_cast<std::size_t>(tiles), TileBin());
    scratch.forget();
  }

  TileBin& bin(int tile) { return bins[static_cast<std::size_t>(tile)]; }

  void add_large(int tile, const LargeTriangle* triangle) {
    LargeTriangles& chunk = bin(tile).large.with_room(arena);
    bin(tile).worth += TileBin::worth_of_large(*triangle);
    chunk.triangle[static_cast<std::size_t>(chunk.count++)] = triangle;
  }

  void add_thin(int tile, const LargeTriangle* triangle) {
    LargeTriangles& chunk = bin(tile).thin.with_room(arena);
    if (chunk.count == 0) ++bin(tile).worth;  // for a chunk of them
    chunk.triangle[static_cast<std::size_t>(chunk.count++)] = triangle;
  }
};

}  // namespace rasterlab
