// Which triangles go to the bins of which tiles, and how they will be drawn there.
#pragma once

#include "common/engine/depth_bounds.h"
#include "common/engine/hidden_clusters.h"
#include "common/engine/kernels.h"
#include "common/engine/window_vertex.h"

#include <bit>
#include <type_traits>

namespace rasterlab::RASTERLAB_SIMD {

/// As many triangles as there are lanes, in the order that makes their areas positive.
struct Triangles {
  std::array<Ints, 3> x;
  std::array<Ints, 3> y;
  std::array<Number, 3> depth;
};

/// First and last pixel whose centre is within the bounds, in each direction.
struct SampleBounds {
  Ints left, right, top, bottom;
};

/// With `beyond`, in 1/256 pixel, the pixels whose centres are that near.
inline SampleBounds sample_bounds(const Triangles& t, int beyond) {
  const Ints before(127 - beyond);
  const Ints after(beyond - 128);
  const Ints low_x = minimum(minimum(t.x[0], t.x[1]), t.x[2]);
  const Ints high_x = maximum(maximum(t.x[0], t.x[1]), t.x[2]);
  const Ints low_y = minimum(minimum(t.y[0], t.y[1]), t.y[2]);
  const Ints high_y = maximum(maximum(t.y[0], t.y[1]), t.y[2]);
  return {shift_right<8>(low_x + before), shift_right<8>(high_x + after),
          shift_right<8>(low_y + before), shift_right<8>(high_y + after)};
}

/// Twice the area, (v1 − v0) × (v2 − v0), exact but for a last rounding.
inline Number twice_area(const Triangles& t, bool short_sides) {
  const Ints ax = t.x[1] - t.x[0];
  const Ints ay = t.y[1] - t.y[0];
  const Ints bx = t.x[2] - t.x[0];
  const Ints by = t.y[2] - t.y[0];
  if (short_sides) return as_numbers(ax * by - ay * bx);
  return to_number(to_doubles(ax) * to_doubles(by) - to_doubles(ay) * to_doubles(bx));
}

/// How triangles are to be drawn (bins.h), as bits; those of no kind as large ones.
struct Kinds {
  std::uint32_t small = 0;
  std::uint32_t thin = 0;
  std::uint32_t medium = 0;
  std::array<std::int32_t, lanes> width;  ///< of thin ones, in whole pixels
};

inline Kinds kinds_of(const Triangles& t, Number area, Truth alive, const SampleBounds& bounds) {
  const Ints side = maximum(bounds.right - bounds.left, bounds.bottom - bounds.top);
  const Truth compact = side < Ints(PackedTriangles::max_compact_side);
  Kinds kinds;
  kinds.small = bits(side < Ints(PackedTriangles::max_small_side));
  kinds.medium = bits(compact) & ~kinds.small;
  if (all(compact || !alive)) return kinds;
  const auto reach = [](const std::array<Ints, 3>& a) {
    return as_numbers(maximum(maximum(a[0], a[1]), a[2]) - minimum(minimum(a[0], a[1]), a[2]));
  };
  const Number width = reach(t.x);
  const Number height = reach(t.y);
  const Number longer = maximum(width, height);
  // A trifle more than it is, as the walk along the lines reckons it too.
  const Number across = magnitude(area) / (longer * Number(256)) + Number(1.0F / 64);
  constexpr auto widest = static_cast<float>(LargeTriangle::max_thin_width);
  constexpr float below_2_to_31 = 2147483000.0F;
  kinds.thin = bits(!compact && across < Number(widest) && width * height <= Number(below_2_to_31));
  store(to_whole(minimum(across, Number(widest))), kinds.width.data());
  kinds.medium |=
      bits(!compact && longer <= Number(256.0F * PackedTriangles::max_medium_side)) & ~kinds.thin;
  return kinds;
}

/// Where triangles of one cluster go.
class Binning {
 public:
  Binning(const DrawJob& job, Worker& worker)
      : job_(job),
        worker_(worker),
        tile_shift_(std::countr_zero(static_cast<unsigned>(job.frame.tile_size()))),
        tiles_x_(job.frame.tiles_x()) {}

  void add(const Triangles& triangles, Number area, Truth alive, const SampleBounds& bounds,
           const std::uint32_t* ids) {
    std::uint32_t mask = bits(alive);
    if (mask == 0) return;
    const Kinds kinds = job_.shades_blocks() ? Kinds() : kinds_of(triangles, area, alive, bounds);
    const SampleBounds pixels = {
        maximum(bounds.left, Ints(0)), minimum(bounds.right, Ints(job_.frame.width() - 1)),
        maximum(bounds.top, Ints(0)), minimum(bounds.bottom, Ints(job_.frame.height() - 1))};
    store(pixels.left, left_.data());
    store(pixels.right, right_.data());
    store(pixels.top, top_.data());
    store(pixels.bottom, bottom_.data());
    if (job_.skip.hidden_triangles) {
      const Truth within_block =
          bounds.right - bounds.left < Ints(8) && bounds.bottom - bounds.top < Ints(8);
      const std::uint32_t hidden =
          bits(behind_blocks(alive && within_block, pixels, triangles.depth));
      worker_.statistics.triangles_hidden += static_cast<unsigned>(std::popcount(hidden));
      mask &= ~hidden;
    }
    const std::uint32_t packed = mask & (kinds.small | kinds.medium);
    if (packed != 0) add_packed(triangles, pixels, ids, kinds, packed);
    if (mask != packed) add_others(triangles, ids, kinds, mask & ~packed);
  }

  /// A triangle with samples in the given pixels, which are in the picture.
  void add_large(const LargeTriangle& triangle, const PixelBounds& pixels) {
    auto* kept = worker_.arena.make<LargeTriangle>();
    *kept = triangle;
    for_each_tile(triangle, pixels, [&](int tile) { worker_.add_large(tile, kept); });
  }

 private:
  /// An edge function, in each tile where it is largest: negative where all of it is outside.
  struct TileEdge {
    std::int64_t at_first;        ///< in tile (0, 0)
    std::int64_t step_x, step_y;  ///< to the next tile

    TileEdge(const LargeTriangle& t, std::size_t i, int shift) {
      const std::size_t a = (i + 1) % 3;
      const std::size_t b = (i + 2) % 3;
      const std::int64_t dx = t.x[b] - t.x[a];
      const std::int64_t dy = t.y[b] - t.y[a];
      const std::int64_t to_last = ((std::int64_t{1} << shift) - 1) * 256;
      at_first = dx * (128 - t.y[a]) - dy * (128 - t.x[a]) +
                 to_last * (std::max<std::int64_t>(-dy, 0) + std::max<std::int64_t>(dx, 0));
      step_x = -dy * (std::int64_t{256} << shift);
      step_y = dx * (std::int64_t{256} << shift);
    }

    std::int64_t at(int tx, int ty) const { return at_first + tx * step_x + ty * step_y; }
  };

  /// Calls `visit(tile)` for the tiles in which a triangle may be seen.
  template <class Visit>
  void for_each_tile(const LargeTriangle& triangle, const PixelBounds& pixels, Visit&& visit) {
    const std::array<TileEdge, 3> edges = {TileEdge(triangle, 0, tile_shift_),
                                           TileEdge(triangle, 1, tile_shift_),
                                           TileEdge(triangle, 2, tile_shift_)};
    const float nearest = bounds_of(triangle.depth).near;
    const int left = pixels.left >> tile_shift_;
    const int right = pixels.right >> tile_shift_;
    for (int ty = pixels.top >> tile_shift_; ty <= pixels.bottom >> tile_shift_; ++ty) {
      std::array<std::int64_t, 3> e;
      for (std::size_t i = 0; i < 3; ++i) e[i] = edges[i].at(left, ty);
      for (int tx = left; tx <= right; ++tx) {
        const int tile = ty * tiles_x_ + tx;
        if ((e[0] | e[1] | e[2]) >= 0 && !hides(tile, nearest)) {
          visit(tile);
          ++worker_.statistics.triangles_binned;
        }
        for (std::size_t i = 0; i < 3; ++i) e[i] += edges[i].step_x;
      }
    }
  }

  /// Slivers and large ones.
  void add_others(const Triangles& triangles, const std::uint32_t* ids, const Kinds& kinds,
                  std::uint32_t mask) {
    std::array<IntLanes, 3> x;
    std::array<IntLanes, 3> y;
    std::array<std::array<float, lanes>, 3> depth;
    for (std::size_t i = 0; i < 3; ++i) {
      store(triangles.x[i], x[i].data());
      store(triangles.y[i], y[i].data());
      store(triangles.depth[i], depth[i].data());
    }
    for (; mask != 0; mask &= mask - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(mask));
      auto* kept = worker_.arena.make<LargeTriangle>();
      *kept = {{x[0][lane], x[1][lane], x[2][lane]},
               {y[0][lane], y[1][lane], y[2][lane]},
               {depth[0][lane], depth[1][lane], depth[2][lane]},
               job_.first_key + ids[lane],
               kinds.width[lane]};
      const bool is_thin = (kinds.thin >> lane & 1U) != 0;
      const PixelBounds pixels = {left_[lane], right_[lane], top_[lane], bottom_[lane]};
      for_each_tile(*kept, pixels, [&](int tile) {
        is_thin ? worker_.add_thin(tile, kept) : worker_.add_large(tile, kept);
      });
    }
  }

  /// Which of the triangles asked, of at most 8×8 samples, are behind all that the blocks they
  /// reach into show: those of their bounds' corners.
  Truth behind_blocks(Truth asked, const SampleBounds& pixels,
                      const std::array<Number, 3>& depth) const {
    const auto far = [&](Ints x, Ints y) {
      return gather_numbers(job_.frame.block_fars(), select(asked, block_of(x, y), Ints(0)));
    };
    const Number above = minimum(far(pixels.left, pixels.top), far(pixels.right, pixels.top));
    const Number below = minimum(far(pixels.left, pixels.bottom), far(pixels.right, pixels.bottom));
    return asked && minimum(above, below) > bounds_of(depth).near;
  }

  /// Calls `work` with the logarithm of the tile size, as a number the compiler knows.
  template <class Work>
  Ints with_tile_shift(const Work& work) const {
    switch (tile_shift_) {
      case 4:
        return work(std::integral_constant<int, 4>());
      case 5:
        return work(std::integral_constant<int, 5>());
      default:
        return work(std::integral_constant<int, 6>());
    }
  }

  /// The tile with the picture's pixel (x, y).
  Ints tile_of(Ints x, Ints y) const {
    return with_tile_shift(
        [&](auto shift) { return shift_right<shift>(y) * Ints(tiles_x_) + shift_right<shift>(x); });
  }

  /// Where a framebuffer keeps what belongs to the block with the picture's pixel (x, y).
  Ints block_of(Ints x, Ints y) const {
    return with_tile_shift([&](auto shift) {
      constexpr int blocks_shift = shift - 3;
      const Ints mask((1 << blocks_shift) - 1);
      return shift_left<2 * blocks_shift>(tile_of(x, y)) +
             shift_left<blocks_shift>(shift_right<3>(y) & mask) + (shift_right<3>(x) & mask);
    });
  }

  // -------------------------------------------------------------------------------------------
  // Triangles of few pixels

  /// Most are in one tile: these are written where they belong, all at once, and others beside.
  void add_packed(const Triangles& triangles, const SampleBounds& pixels, const std::uint32_t* ids,
                  const Kinds& kinds, std::uint32_t mask) {
    const Ints first_tile = tile_of(pixels.left, pixels.top);
    const std::uint32_t in_one_tile = bits(first_tile == tile_of(pixels.right, pixels.bottom));
    IntLanes tile;
    store(first_tile, tile.data());
    std::array<float, lanes> nearest;
    store(bounds_of(triangles.depth).near, nearest.data());
    const auto is_small = [&](std::size_t lane) { return (kinds.small >> lane & 1U) != 0; };
    std::array<PackedTriangle, lanes> beside;
    std::array<PackedTriangle*, lanes> to;
    for (std::size_t lane = 0; lane < lanes; ++lane) to[lane] = &beside[lane];
    for_each_lane(mask & in_one_tile, [&](std::size_t lane) {
      if (!hides(tile[lane], nearest[lane])) to[lane] = &new_in(tile[lane], is_small(lane));
    });
    write_packed(triangles, pixels, ids, to);
    for_each_lane(mask & ~in_one_tile, [&](std::size_t lane) {
      for_each_tile_in_bounds(lane, [&](int column, int row) {
        const int there = tile[lane] + row * tiles_x_ + column;
        if (hides(there, nearest[lane])) return;
        move(beside[lane], column, row, new_in(there, is_small(lane)));
      });
    });
  }

  template <class Visit>
  static void for_each_lane(std::uint32_t mask, const Visit& visit) {
    for (; mask != 0; mask &= mask - 1) visit(static_cast<std::size_t>(std::countr_zero(mask)));
  }

  /// Calls `visit(column, row)` for the tiles a lane's pixels are in, counted from their first.
  template <class Visit>
  void for_each_tile_in_bounds(std::size_t lane, const Visit& visit) const {
    const int columns = (right_[lane] >> tile_shift_) - (left_[lane] >> tile_shift_);
    const int rows = (bottom_[lane] >> tile_shift_) - (top_[lane] >> tile_shift_);
    for (int row = 0; row <= rows; ++row) {
      for (int column = 0; column <= columns; ++column) visit(column, row);
    }
  }

  PackedTriangle& new_in(int tile, bool is_small) {
    TileBin& bin = worker_.bin(tile);
    PackedTriangles& chunk = (is_small ? bin.small : bin.medium).with_room(worker_.arena);
    bin.worth += is_small ? 1 : TileBin::worth_of_medium;
    ++worker_.statistics.triangles_binned;
    return chunk.triangle[static_cast<std::size_t>(chunk.count++)];
  }

  /// As the tile of each one's first pixel has them.
  void write_packed(const Triangles& t, const SampleBounds& pixels, const std::uint32_t* ids,
                    const std::array<PackedTriangle*, lanes>& packed) const {
    const Ints mask(-(1 << tile_shift_));
    const Ints x = shift_left<8>(pixels.left & mask);
    const Ints y = shift_left<8>(pixels.top & mask);
    std::array<Number, 8> words;
    for (std::size_t i = 0; i < 3; ++i) {
      words[i] = from_bit_pattern(((t.x[i] - x) & Ints(0xFFFF)) | shift_left<16>(t.y[i] - y));
      words[3 + i] = t.depth[i];
    }
    words[6] = from_bit_pattern(load(ids) + Ints(static_cast<std::int32_t>(job_.first_key)));
    words[7] = Number(0);
    std::array<float*, lanes> to;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      to[lane] = reinterpret_cast<float*>(packed[lane]);
    }
    store_fours(&words[0], to.data(), lanes);
    for (float*& place : to) place += 4;
    store_fours(&words[4], to.data(), lanes);
  }

  /// As a tile has it that is so many further right and down. Word by word to where it belongs: a
  /// record read as a whole would wait for words just written.
  void move(const PackedTriangle& from, int columns, int rows, PackedTriangle& to) const {
    const auto right = static_cast<std::uint32_t>(columns) << (tile_shift_ + 8);
    const auto down = static_cast<std::uint32_t>(rows) << (tile_shift_ + 8);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t corner = from.corner[i];
      to.corner[i] = ((corner - right) & 0xFFFFU) | ((corner & 0xFFFF0000U) - (down << 16U));
      to.depth[i] = from.depth[i];
    }
    to.key = from.key;
  }

  /// Whether everything in a tile is nearer.
  bool hides(int tile, float nearest) const {
    return job_.skip.hidden_triangles && job_.frame.tile_far(tile) > nearest;
  }

  const DrawJob& job_;
  Worker& worker_;
  int tile_shift_;
  int tiles_x_;
  using IntLanes = std::array<std::int32_t, lanes>;
  IntLanes left_, right_, top_, bottom_;
};

}  // namespace rasterlab::RASTERLAB_SIMD
