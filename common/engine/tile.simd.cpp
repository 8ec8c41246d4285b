// The back end: depth and triangle of every pixel of a tile.
//
// Five ways to draw: triangles of a few samples one per lane (small_triangles.h), slivers one per
// lane too, line by line (thin_triangles.h); others one after the other, those of few pixels vector
// by vector (compact_triangle.h), the rest in blocks of 8×8 pixels, set up side by side when 32
// bits are enough (medium_triangles.h), else each for itself (large_triangles.h).
//
// All compute the same numbers for a pixel. Edge functions are integers, exactly; depth is
// d0 + (E1·k1 + E2·k2), where E is the edge function rounded to float once and k = (di − d0) / area
// rounded to float once: within 5 half units in the last place of the largest corner's depth,
// however thin the triangle.
#include "common/engine/hit_list.h"
#include "common/engine/large_triangles.h"
#include "common/engine/medium_triangles.h"
#include "common/engine/simd_kernels.h"
#include "common/engine/small_triangles.h"
#include "common/engine/thin_triangles.h"

namespace rasterlab::RASTERLAB_SIMD {

namespace {

template <class T>
void prefetch(const T& object) {
  const auto* bytes = reinterpret_cast<const char*>(&object);
  for (std::size_t at = 0; at < sizeof object; at += 64) __builtin_prefetch(bytes + at);
}

/// Calls `visit(chunk)` for what all workers found to draw in a tile, of the kind that `list` takes
/// from a bin.
template <class List, class Visit>
void for_each_chunk(std::span<Worker> workers, int tile, const List& list, const Visit& visit) {
  for (const Worker& from : workers) {
    const TileBin& bin = from.bins[static_cast<std::size_t>(tile)];
    for (const auto* chunk = list(bin).first; chunk != nullptr; chunk = chunk->next) {
      if (chunk->next != nullptr) prefetch(*chunk->next);
      visit(*chunk);
    }
  }
}

/// Near ones first: what they cover needn't be drawn again and again.
void draw_large(const DrawJob& job, const Tile& tile, std::vector<NearTriangle>& triangles,
                Worker& worker) {
  std::sort(triangles.begin(), triangles.end(),
            [](const NearTriangle& a, const NearTriangle& b) { return a.nearest > b.nearest; });
  for (const auto& [nearest, triangle] : triangles) {
    const BlockMask open = open_blocks(job, tile, *triangle, nearest, worker.statistics);
    if (open == 0) continue;
    LargeDrawing drawing(job, tile, *triangle, open);
    if (!drawing.misses()) drawing.draw(worker);
  }
}

/// From how many slivers on it is worth having a tile's pixels in words.
constexpr std::size_t enough_for_words = 64;

void draw_slivers(const Tile& tile, std::span<Worker> workers, Worker& worker, HitList& hits) {
  std::vector<ThinInTile>& slivers = worker.thin_in_tile;
  slivers.clear();
  const auto thins = [](const TileBin& bin) { return bin.thin; };
  for_each_chunk(workers, tile.index, thins, [&](const LargeTriangles& chunk) {
    for (int i = 0; i < chunk.count; ++i) {
      const LargeTriangle* triangle = chunk.triangle[static_cast<std::size_t>(i)];
      prefetch(*triangle);
      slivers.push_back({triangle});
    }
  });
  find_in_tile(slivers, tile, worker.thin_sorted);
  if (worker.thin_sorted.empty()) return;
  give_pixels(tile, all_64);
  if (!tile.has_keys() || worker.thin_sorted.size() < enough_for_words) {
    draw_thin(tile, worker.thin_sorted, [&](std::int32_t place, std::int64_t word) {
      hits.write_one(place, depth_of_word(word), key_of_word(word));
    });
    update_far(tile, hits.take_written_blocks());
    return;
  }
  read_pixels(tile, worker.words);
  std::int64_t* words = worker.words.data();
  draw_thin(tile, worker.thin_sorted, [words](std::int32_t place, std::int64_t word) {
    words[place] = std::max(words[place], word);
  });
  write_pixels(worker.words, tile);
}

}  // namespace

void draw_tile(const DrawJob& job, const Tile& tile, std::span<Worker> workers, Worker& worker) {
  const int index = tile.index;
  std::vector<NearTriangle>& large = worker.near_first;
  large.clear();
  const auto larges = [](const TileBin& bin) { return bin.large; };
  for_each_chunk(workers, index, larges, [&](const LargeTriangles& chunk) {
    for (int i = 0; i < chunk.count; ++i) {
      const LargeTriangle& t = *chunk.triangle[static_cast<std::size_t>(i)];
      large.push_back({bounds_of(t.depth).near, &t});
    }
  });
  draw_large(job, tile, large, worker);
  const bool skip_hidden = job.skip.hidden_triangles;
  const auto mediums = [](const TileBin& bin) { return bin.medium; };
  for_each_chunk(workers, index, mediums, [&](const PackedTriangles& chunk) {
    draw_medium(tile, chunk, skip_hidden, worker.statistics);
  });
  HitList hits(tile);
  draw_slivers(tile, workers, worker, hits);
  const auto smalls = [](const TileBin& bin) { return bin.small; };
  for_each_chunk(workers, index, smalls, [&](const PackedTriangles& chunk) {
    give_pixels(tile, all_64);
    draw_small(tile, chunk, skip_hidden, hits);
    update_far(tile, hits.take_written_blocks());
  });
  job.frame.tile_far(index) =
      *std::min_element(tile.block_far, tile.block_far + tile.block_count());
}

namespace {

/// Of a block that shows nothing but one triangle, and has no depths; else nullptr.
const DepthPlane* only_plane(const Tile& tile, int block) {
  if (tile.undisputed == nullptr || !tile.undisputed->has(block)) return nullptr;
  const auto parts = tile.undisputed->parts(block);
  if (parts.size() != 1 || parts[0].pixels != all_64) return nullptr;
  return &tile.undisputed->plane_of(parts[0]);
}

}  // namespace

void write_depth(const Tile& tile, float* depth) {
  for (int block = 0; block < tile.block_count(); ++block) {
    float* to = depth + block * 64;
    if (const DepthPlane* plane = only_plane(tile, block)) {
      PlaneDepths(*plane).for_each_vector(place_of_block(tile, block),
                                          [&](int g, Number own) { stream(own, to + g * lanes); });
      continue;
    }
    give_pixels(tile, BlockMask{1} << block);
    for (int pixel = 0; pixel < 64; pixel += lanes) {
      stream(load(tile.depth + block * 64 + pixel), to + pixel);
    }
  }
  finish_streaming();
}

}  // namespace rasterlab::RASTERLAB_SIMD
