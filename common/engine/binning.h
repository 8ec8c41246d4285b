// Which triangles go to the bins of which tiles, and how they will be drawn there.
#pragma once

#include "common/engine/depth_bounds.h"
#include "common/engine/hidden_clusters.h"
#include "common/engine/kernels.h"
#include "common/engine/window_vertex.h"

#include <bit>

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
    for (std::size_t i = 0; i < 3; ++i) {
      store(triangles.x[i], x_[i].data());
      store(triangles.y[i], y_[i].data());
      store(triangles.depth[i], depth_[i].data());
    }
    store(maximum(bounds.left, Ints(0)), left_.data());
    store(minimum(bounds.right, Ints(job_.frame.width() - 1)), right_.data());
    store(maximum(bounds.top, Ints(0)), top_.data());
    store(minimum(bounds.bottom, Ints(job_.frame.height() - 1)), bottom_.data());
    const Kinds kinds = job_.shades_blocks() ? Kinds() : kinds_of(triangles, area, alive, bounds);
    if (job_.skip.hidden_triangles) {
      const Truth within_block =
          bounds.right - bounds.left < Ints(8) && bounds.bottom - bounds.top < Ints(8);
      const std::uint32_t hidden = bits(behind_blocks(alive && within_block, triangles.depth));
      worker_.statistics.triangles_hidden += static_cast<unsigned>(std::popcount(hidden));
      mask &= ~hidden;
    }
    for (; mask != 0; mask &= mask - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(mask));
      const std::uint32_t key = job_.first_key + ids[lane];
      const auto is = [lane](std::uint32_t kind) { return (kind >> lane & 1U) != 0; };
      if (is(kinds.small)) {
        add_packed(lane, key, &TileBin::small, 1);
        continue;
      }
      if (is(kinds.medium)) {
        add_packed(lane, key, &TileBin::medium, TileBin::worth_of_medium);
        continue;
      }
      auto* kept = worker_.arena.make<LargeTriangle>();
      *kept = {{x_[0][lane], x_[1][lane], x_[2][lane]},
               {y_[0][lane], y_[1][lane], y_[2][lane]},
               {depth_[0][lane], depth_[1][lane], depth_[2][lane]},
               key,
               kinds.width[lane]};
      const PixelBounds pixels = {left_[lane], right_[lane], top_[lane], bottom_[lane]};
      for_each_tile(*kept, pixels, [&](int tile) {
        is(kinds.thin) ? worker_.add_thin(tile, kept) : worker_.add_large(tile, kept);
      });
    }
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

  /// Which of the triangles asked, of at most 8×8 samples, are behind all that the blocks they
  /// reach into show: those of their bounds' corners.
  Truth behind_blocks(Truth asked, const std::array<Number, 3>& depth) const {
    const auto far = [&](const IntLanes& pixel_x, const IntLanes& pixel_y) {
      const Ints x = shift_right<3>(load(pixel_x.data()));
      const Ints y = shift_right<3>(load(pixel_y.data()));
      return gather_numbers(job_.frame.block_fars(), select(asked, block_index(x, y), Ints(0)));
    };
    const Number above = minimum(far(left_, top_), far(right_, top_));
    const Number below = minimum(far(left_, bottom_), far(right_, bottom_));
    return asked && minimum(above, below) > bounds_of(depth).near;
  }

  /// Where a framebuffer keeps what belongs to the block in column x and row y of the picture's.
  Ints block_index(Ints x, Ints y) const {
    switch (tile_shift_) {
      case 4:
        return block_in_tile<1>(x, y);
      case 5:
        return block_in_tile<2>(x, y);
      default:
        return block_in_tile<3>(x, y);
    }
  }
  template <int shift>
  Ints block_in_tile(Ints x, Ints y) const {
    const Ints tile = shift_right<shift>(y) * Ints(tiles_x_) + shift_right<shift>(x);
    const Ints mask((1 << shift) - 1);
    return shift_left<2 * shift>(tile) + shift_left<shift>(y & mask) + (x & mask);
  }

  void add_packed(std::size_t lane, std::uint32_t key, ChunkList<PackedTriangles> TileBin::*kind,
                  std::uint32_t worth) {
    const float nearest =
        bounds_of(std::array{depth_[0][lane], depth_[1][lane], depth_[2][lane]}).near;
    for (int ty = top_[lane] >> tile_shift_; ty <= bottom_[lane] >> tile_shift_; ++ty) {
      for (int tx = left_[lane] >> tile_shift_; tx <= right_[lane] >> tile_shift_; ++tx) {
        const int tile = ty * tiles_x_ + tx;
        if (hides(tile, nearest)) continue;
        PackedTriangles& bin = (worker_.bin(tile).*kind).with_room(worker_.arena);
        worker_.bin(tile).worth += worth;
        const auto place = static_cast<std::size_t>(bin.count++);
        const std::int32_t origin_x = tx << (tile_shift_ + 8);
        const std::int32_t origin_y = ty << (tile_shift_ + 8);
        for (std::size_t i = 0; i < 3; ++i) {
          const auto x = static_cast<std::uint32_t>(x_[i][lane] - origin_x);
          const auto y = static_cast<std::uint32_t>(y_[i][lane] - origin_y);
          bin.corner[i][place] = (x & 0xFFFFU) | y << 16U;
          bin.depth[i][place] = depth_[i][lane];
        }
        bin.key[place] = key;
        ++worker_.statistics.triangles_binned;
      }
    }
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
  std::array<IntLanes, 3> x_;
  std::array<IntLanes, 3> y_;
  std::array<std::array<float, lanes>, 3> depth_;
  IntLanes left_, right_, top_, bottom_;
};

}  // namespace rasterlab::RASTERLAB_SIMD
