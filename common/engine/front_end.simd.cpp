// The front end: from clusters of triangles to bins of what may be seen in each tile.
#include "common/engine/kernels.h"
#include "common/engine/simd_kernels.h"
#include "common/engine/window_vertex.h"

#include <bit>
#include <limits>

namespace rasterlab::RASTERLAB_SIMD {

namespace {

// ---------------------------------------------------------------------------------------------
// Clusters against the view

/// The range of a linear function over boxes.
struct Range {
  Number low;
  Number high;
};

struct Boxes {
  std::array<Number, 3> center;
  std::array<Number, 3> half_size;

  /// Of row · (p, 1), with a margin for rounding, here and in the vertices' own transform.
  Range of(const std::array<float, 4>& row) const {
    Number middle(row[3]);
    Number reach(0.0F);
    Number terms = magnitude(middle);
    for (std::size_t i = 0; i < 3; ++i) {
      middle += center[i] * Number(row[i]);
      reach += half_size[i] * magnitude(Number(row[i]));
      terms += magnitude(center[i] * Number(row[i]));
    }
    reach += (terms + reach) * Number(1e-5F);
    return {middle - reach, middle + reach};
  }
};

std::array<float, 4> sum_of(const std::array<float, 4>& a, const std::array<float, 4>& b,
                            float sign) {
  std::array<float, 4> sum;
  for (std::size_t i = 0; i < 4; ++i) sum[i] = a[i] + sign * b[i];
  return sum;
}

/// Whether boxes lie wholly on the outer side of a side of the view. Written so that what is not a
/// number is not outside.
Truth outside_view(const ClipTransform& transform, const Boxes& boxes) {
  const auto& row = transform.row;
  Truth outside = boxes.of(sum_of(row[3], row[2], 1)).high < Number(0);  // the near plane
  for (std::size_t axis = 0; axis < 2; ++axis) {
    outside = outside || boxes.of(sum_of(row[3], row[axis], 1)).high < Number(0) ||
              boxes.of(sum_of(row[3], row[axis], -1)).high < Number(0);
  }
  return outside;
}

std::array<float, 4> depth_row(const ClipTransform& transform) {
  std::array<float, 4> row;
  for (std::size_t i = 0; i < 4; ++i) row[i] = static_cast<float>(transform.depth_row[i]);
  return row;
}

/// The largest reversed depth in the boxes; infinite when they reach behind the eye.
Number nearest_depth(const ClipTransform& transform, const Boxes& boxes) {
  const Number w = boxes.of(transform.row[3]).low;
  const Number numerator = boxes.of(depth_row(transform)).high;
  const Number nearest = numerator / w * Number(1.00001F);
  return select(w > Number(0) && nearest >= Number(0), nearest,
                Number(std::numeric_limits<float>::infinity()));
}

Boxes load_boxes(const Clusters& clusters, std::uint32_t first) {
  Boxes boxes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    boxes.center[axis] = load(clusters.center[axis].data() + first);
    boxes.half_size[axis] = load(clusters.half_size[axis].data() + first);
  }
  return boxes;
}

// ---------------------------------------------------------------------------------------------
// Clusters against what is already drawn

/// Pixels a cluster's box may touch; empty when that isn't known.
struct PixelBounds {
  int left, right, top, bottom;
};

/// The range of (a / w + 1) · half, in pixels, for `lanes` boxes in front of the eye.
struct PixelRange {
  Number low, high;
};
PixelRange pixel_range(Range a, Range w, float half) {
  const Number low = select(a.low < Number(0), a.low / w.low, a.low / w.high);
  const Number high = select(a.high > Number(0), a.high / w.low, a.high / w.high);
  return {(low + Number(1)) * Number(half) - Number(1),
          (high + Number(1)) * Number(half) + Number(1)};
}

/// Whether everything drawn in these pixels is nearer than `nearest`.
bool is_hidden(const FrameAccess& frame, const PixelBounds& bounds, float nearest) {
  const int size = frame.tile_size();
  constexpr int most_tiles = 16;
  const int tiles_wide = bounds.right / size - bounds.left / size + 1;
  if (tiles_wide * (bounds.bottom / size - bounds.top / size + 1) > most_tiles) return false;
  const int per_row = size / 8;
  for (int ty = bounds.top / size; ty <= bounds.bottom / size; ++ty) {
    for (int tx = bounds.left / size; tx <= bounds.right / size; ++tx) {
      const int tile = ty * frame.tiles_x() + tx;
      if (frame.tile_far(tile) > nearest) continue;
      const float* far = frame.block_fars() + static_cast<std::ptrdiff_t>(tile) * per_row * per_row;
      const int first_x = std::max(bounds.left - tx * size, 0) / 8;
      const int last_x = std::min(bounds.right - tx * size, size - 1) / 8;
      const int first_y = std::max(bounds.top - ty * size, 0) / 8;
      const int last_y = std::min(bounds.bottom - ty * size, size - 1) / 8;
      for (int y = first_y; y <= last_y; ++y) {
        for (int x = first_x; x <= last_x; ++x) {
          if (!(far[y * per_row + x] > nearest)) return false;
        }
      }
    }
  }
  return true;
}

/// Which of at most `lanes` clusters are hidden, as bits.
std::uint32_t find_hidden(const DrawJob& job, std::span<const VisibleCluster> visible) {
  const Clusters& clusters = job.mesh->clusters();
  std::array<std::int32_t, lanes> index = {};
  for (std::size_t i = 0; i < visible.size(); ++i) {
    index[i] = static_cast<std::int32_t>(visible[i].index);
  }
  Boxes boxes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    boxes.center[axis] = gather_numbers(clusters.center[axis].data(), load(index.data()));
    boxes.half_size[axis] = gather_numbers(clusters.half_size[axis].data(), load(index.data()));
  }
  const ClipTransform& transform = job.transform;
  const Range w = boxes.of(transform.row[3]);
  const PixelRange x = pixel_range(boxes.of(transform.row[0]), w, transform.half_width);
  Range up = boxes.of(transform.row[1]);
  const PixelRange y = pixel_range({-up.high, -up.low}, w, transform.half_height);
  const Number last_x(static_cast<float>(job.frame.width() - 1));
  const Number last_y(static_cast<float>(job.frame.height() - 1));
  const auto inside = [](Number value, Number last) {
    return to_whole(minimum(maximum(value, Number(0)), last));
  };
  std::array<std::array<std::int32_t, lanes>, 4> bounds;
  store(inside(x.low, last_x), bounds[0].data());
  store(inside(x.high, last_x), bounds[1].data());
  store(inside(y.low, last_y), bounds[2].data());
  store(inside(y.high, last_y), bounds[3].data());
  const std::uint32_t in_front = bits(w.low > Number(0));
  std::uint32_t hidden = 0;
  for (std::size_t i = 0; i < visible.size(); ++i) {
    if ((in_front >> i & 1U) != 0 &&
        is_hidden(job.frame, {bounds[0][i], bounds[1][i], bounds[2][i], bounds[3][i]},
                  visible[i].nearest)) {
      hidden |= 1U << i;
    }
  }
  return hidden;
}

// ---------------------------------------------------------------------------------------------
// A cluster's vertices

struct ClusterVertices {
  alignas(64) std::array<std::int32_t, Cluster::max_vertices + 16> x;
  alignas(64) std::array<std::int32_t, Cluster::max_vertices + 16> y;
  alignas(64) std::array<float, Cluster::max_vertices + 16> depth;
  alignas(64) std::array<std::int32_t, Cluster::max_vertices + 16> direct;
  bool all_direct;
  bool short_sides;  ///< all within 64 pixels of each other: 32-bit arithmetic is exact
};

void transform_vertices(const ClipTransform& transform, const Clusters& clusters,
                        const Cluster& cluster, ClusterVertices& vertices) {
  Truth all_direct = Ints(0) == Ints(0);
  Ints low_x(std::numeric_limits<std::int32_t>::max());
  Ints high_x(std::numeric_limits<std::int32_t>::min());
  Ints low_y = low_x;
  Ints high_y = high_x;
  for (std::uint32_t i = 0; i < cluster.vertex_count; i += lanes) {
    const std::uint32_t from = cluster.first_vertex + i;
    const Number px = load(clusters.position[0].data() + from);
    const Number py = load(clusters.position[1].data() + from);
    const Number pz = load(clusters.position[2].data() + from);
    const ClipPoints clip = to_clip(transform, px, py, pz);
    const WindowPoints window = to_window(transform, clip);
    store(window.x, vertices.x.data() + i);
    store(window.y, vertices.y.data() + i);
    store(reversed_depth(transform, px, py, pz, clip.w), vertices.depth.data() + i);
    store(select(window.direct, Ints(1), Ints(0)), vertices.direct.data() + i);
    const Truth used = first_lanes(std::min(lanes, static_cast<int>(cluster.vertex_count - i)));
    all_direct = all_direct && (window.direct || !used);
    low_x = select(used, minimum(low_x, window.x), low_x);
    high_x = select(used, maximum(high_x, window.x), high_x);
    low_y = select(used, minimum(low_y, window.y), low_y);
    high_y = select(used, maximum(high_y, window.y), high_y);
  }
  vertices.all_direct = all(all_direct);
  vertices.short_sides = vertices.all_direct && largest(high_x) - smallest(low_x) <= 64 * 256 &&
                         largest(high_y) - smallest(low_y) <= 64 * 256;
}

// ---------------------------------------------------------------------------------------------
// A cluster's triangles

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

SampleBounds sample_bounds(const Triangles& t) {
  const Ints low_x = minimum(minimum(t.x[0], t.x[1]), t.x[2]);
  const Ints high_x = maximum(maximum(t.x[0], t.x[1]), t.x[2]);
  const Ints low_y = minimum(minimum(t.y[0], t.y[1]), t.y[2]);
  const Ints high_y = maximum(maximum(t.y[0], t.y[1]), t.y[2]);
  return {shift_right<8>(low_x + Ints(127)), shift_right<8>(high_x - Ints(128)),
          shift_right<8>(low_y + Ints(127)), shift_right<8>(high_y - Ints(128))};
}

/// Sign of twice the area, (v1 − v0) × (v2 − v0).
Ints area_sign(const Triangles& t, bool short_sides) {
  const Ints ax = t.x[1] - t.x[0];
  const Ints ay = t.y[1] - t.y[0];
  const Ints bx = t.x[2] - t.x[0];
  const Ints by = t.y[2] - t.y[0];
  if (short_sides) return ax * by - ay * bx;
  const Number area = to_number(to_doubles(ax) * to_doubles(by) - to_doubles(ay) * to_doubles(bx));
  return select(area > Number(0), Ints(1), select(area < Number(0), Ints(-1), Ints(0)));
}

/// Where triangles of one cluster go.
class Binning {
 public:
  Binning(const DrawJob& job, Worker& worker)
      : job_(job),
        worker_(worker),
        tile_shift_(std::countr_zero(static_cast<unsigned>(job.frame.tile_size()))),
        tiles_x_(job.frame.tiles_x()) {}

  void add(const Triangles& triangles, Truth alive, const SampleBounds& bounds,
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
    const Ints limit(SmallTriangles::max_side);
    const Truth few_samples =
        bounds.right - bounds.left < limit && bounds.bottom - bounds.top < limit;
    const std::uint32_t small = job_.discards() ? 0U : bits(few_samples);
    if (job_.skip.hidden) {
      const std::uint32_t hidden = bits(behind_blocks(alive && few_samples, triangles.depth));
      worker_.statistics.triangles_hidden += static_cast<unsigned>(std::popcount(hidden));
      mask &= ~hidden;
    }
    for (; mask != 0; mask &= mask - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(mask));
      const std::uint32_t key = job_.first_key + ids[lane];
      if ((small >> lane & 1U) != 0) {
        add_small(lane, key);
      } else {
        add_large({{x_[0][lane], x_[1][lane], x_[2][lane]},
                   {y_[0][lane], y_[1][lane], y_[2][lane]},
                   {depth_[0][lane], depth_[1][lane], depth_[2][lane]},
                   key},
                  left_[lane], right_[lane], top_[lane], bottom_[lane]);
      }
    }
  }

  /// A triangle with samples in the given pixels, which are in the picture.
  void add_large(const LargeTriangle& triangle, int left, int right, int top, int bottom) {
    auto* kept = worker_.arena.make<LargeTriangle>();
    *kept = triangle;
    const std::array<Edge, 3> edges = {Edge(triangle, 0), Edge(triangle, 1), Edge(triangle, 2)};
    const float nearest =
        std::max({triangle.depth[0], triangle.depth[1], triangle.depth[2]}) * 1.000001F;
    for (int ty = top >> tile_shift_; ty <= bottom >> tile_shift_; ++ty) {
      for (int tx = left >> tile_shift_; tx <= right >> tile_shift_; ++tx) {
        if (edges[0].misses(tx, ty, tile_shift_) || edges[1].misses(tx, ty, tile_shift_) ||
            edges[2].misses(tx, ty, tile_shift_)) {
          continue;
        }
        if (job_.skip.hidden && job_.frame.tile_far(ty * tiles_x_ + tx) > nearest) continue;
        worker_.add_large(ty * tiles_x_ + tx, kept);
        ++worker_.statistics.triangles_binned;
      }
    }
  }

 private:
  /// An edge function for asking whether a tile is wholly outside.
  struct Edge {
    std::int64_t at_first, step_x, step_y;

    Edge(const LargeTriangle& t, std::size_t i) {
      const std::size_t a = (i + 1) % 3;
      const std::size_t b = (i + 2) % 3;
      step_x = static_cast<std::int64_t>(t.y[a] - t.y[b]) * 256;
      step_y = static_cast<std::int64_t>(t.x[b] - t.x[a]) * 256;
      at_first = static_cast<std::int64_t>(t.x[b] - t.x[a]) * (128 - t.y[a]) -
                 static_cast<std::int64_t>(t.y[b] - t.y[a]) * (128 - t.x[a]);
    }

    bool misses(int tx, int ty, int shift) const {
      const std::int64_t size = std::int64_t{1} << shift;
      const std::int64_t x = tx * size + (step_x > 0 ? size - 1 : 0);
      const std::int64_t y = ty * size + (step_y > 0 ? size - 1 : 0);
      return at_first + x * step_x + y * step_y < 0;
    }
  };

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
    const Number nearest = maximum(maximum(depth[0], depth[1]), depth[2]);
    return asked && minimum(above, below) > nearest * Number(1.000001F);
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

  void add_small(std::size_t lane, std::uint32_t key) {
    for (int ty = top_[lane] >> tile_shift_; ty <= bottom_[lane] >> tile_shift_; ++ty) {
      for (int tx = left_[lane] >> tile_shift_; tx <= right_[lane] >> tile_shift_; ++tx) {
        SmallTriangles& bin = worker_.small_with_room(ty * tiles_x_ + tx);
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

/// Whether triangles of this sign of area are to be drawn. Counter-clockwise, seen with y up, is
/// negative here, where y is down.
Truth kept_side(Cull cull, Ints area) {
  switch (cull) {
    case Cull::back:
      return area < Ints(0);
    case Cull::front:
      return area > Ints(0);
    case Cull::none:
      break;
  }
  return !(area == Ints(0));
}

void make_area_positive(Triangles& t, Ints area) {
  const Truth swap = area < Ints(0);
  const auto exchange = [swap](auto& a, auto& b) {
    const auto old = a;
    a = select(swap, b, a);
    b = select(swap, old, b);
  };
  exchange(t.x[1], t.x[2]);
  exchange(t.y[1], t.y[2]);
  exchange(t.depth[1], t.depth[2]);
}

Truth in_picture(const DrawJob& job, const SampleBounds& bounds) {
  return bounds.right >= Ints(0) && bounds.left < Ints(job.frame.width()) &&
         bounds.bottom >= Ints(0) && bounds.top < Ints(job.frame.height());
}

/// One triangle of a clipped polygon.
void bin_part(const DrawJob& job, const ClippedPart& part, std::uint32_t key, Binning& binning) {
  LargeTriangle triangle;
  triangle.key = key;
  auto& [x, y, depth, unused] = triangle;
  for (std::size_t c = 0; c < 3; ++c) {
    x[c] = part.snapped[c].x;
    y[c] = part.snapped[c].y;
    depth[c] = part.corner[c]->reversed_depth();
  }
  const std::int64_t area = twice_area(part.snapped[0], part.snapped[1], part.snapped[2]);
  if (!any(kept_side(job.cull, Ints(area < 0 ? -1 : area > 0 ? 1 : 0)))) return;
  if (area < 0) {
    std::swap(x[1], x[2]);
    std::swap(y[1], y[2]);
    std::swap(depth[1], depth[2]);
  }
  const auto [low_x, high_x] = std::minmax({x[0], x[1], x[2]});
  const auto [low_y, high_y] = std::minmax({y[0], y[1], y[2]});
  const int left = std::max((low_x + 127) >> 8, 0);
  const int right = std::min((high_x - 128) >> 8, job.frame.width() - 1);
  const int top = std::max((low_y + 127) >> 8, 0);
  const int bottom = std::min((high_y - 128) >> 8, job.frame.height() - 1);
  if (left <= right && top <= bottom) binning.add_large(triangle, left, right, top, bottom);
}

/// Triangles that need clipping, one by one.
void bin_clipped(const DrawJob& job, const Clusters& clusters, const Cluster& cluster,
                 std::uint32_t index, Binning& binning) {
  TrianglePositions positions;
  for (std::size_t c = 0; c < 3; ++c) {
    const std::uint32_t vertex = cluster.first_vertex + clusters.corner[c][index];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      positions[c][axis] = clusters.position[axis][vertex];
    }
  }
  const std::uint32_t key = job.first_key + clusters.triangle[index];
  for_each_part(job.transform, clip_triangle(job.transform, positions),
                [&](const ClippedPart& part) { bin_part(job, part, key, binning); });
}

void bin_triangles(const DrawJob& job, const Clusters& clusters, const Cluster& cluster,
                   const ClusterVertices& vertices, Binning& binning, Statistics& statistics) {
  for (std::uint32_t i = 0; i < cluster.triangle_count; i += lanes) {
    const std::uint32_t from = cluster.first_triangle + i;
    const int count = std::min(lanes, static_cast<int>(cluster.triangle_count - i));
    const std::array<Ints, 3> corner = {load(clusters.corner[0].data() + from),
                                        load(clusters.corner[1].data() + from),
                                        load(clusters.corner[2].data() + from)};
    Triangles t;
    for (std::size_t c = 0; c < 3; ++c) {
      t.x[c] = gather_ints(vertices.x.data(), corner[c]);
      t.y[c] = gather_ints(vertices.y.data(), corner[c]);
      t.depth[c] = gather_numbers(vertices.depth.data(), corner[c]);
    }
    Truth alive = first_lanes(count);
    if (!vertices.all_direct) {
      const Ints direct = gather_ints(vertices.direct.data(), corner[0]) &
                          gather_ints(vertices.direct.data(), corner[1]) &
                          gather_ints(vertices.direct.data(), corner[2]);
      std::uint32_t clipped = bits(alive && direct == Ints(0));
      alive = alive && !(direct == Ints(0));
      statistics.triangles_clipped += static_cast<unsigned>(std::popcount(clipped));
      for (; clipped != 0; clipped &= clipped - 1) {
        const auto lane = static_cast<std::uint32_t>(std::countr_zero(clipped));
        bin_clipped(job, clusters, cluster, from + lane, binning);
      }
    }
    const Ints area = area_sign(t, vertices.short_sides);
    const Truth shown = alive && kept_side(job.cull, area);
    const SampleBounds bounds = sample_bounds(t);
    const Truth hits = shown && bounds.left <= bounds.right && bounds.top <= bounds.bottom;
    const Truth seen = hits && in_picture(job, bounds);
    make_area_positive(t, area);
    statistics.triangles_culled += static_cast<unsigned>(std::popcount(bits(alive && !shown)));
    statistics.triangles_missed += static_cast<unsigned>(std::popcount(bits(shown && !seen)));
    binning.add(t, seen, bounds, clusters.triangle.data() + from);
  }
}

}  // namespace

void find_visible(const DrawJob& job, std::uint32_t begin, std::uint32_t end,
                  std::vector<VisibleCluster>& visible, Statistics& statistics) {
  const Clusters& clusters = job.mesh->clusters();
  for (std::uint32_t first = begin; first < end; first += lanes) {
    const Boxes boxes = load_boxes(clusters, first);
    const Number nearest = nearest_depth(job.transform, boxes);
    std::array<float, lanes> nearest_of;
    store(nearest, nearest_of.data());
    const Truth inside = first_lanes(std::min(lanes, static_cast<int>(end - first)));
    std::uint32_t kept = bits(inside);
    if (job.skip.outside) {
      const std::uint32_t out = bits(inside && outside_view(job.transform, boxes));
      statistics.clusters_outside += static_cast<unsigned>(std::popcount(out));
      kept &= ~out;
    }
    statistics.clusters += static_cast<unsigned>(std::popcount(bits(inside)));
    for (; kept != 0; kept &= kept - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(kept));
      visible.push_back({first + lane, nearest_of[lane]});
    }
  }
}

void bin_clusters(const DrawJob& job, std::span<const VisibleCluster> visible, Worker& worker) {
  const Clusters& clusters = job.mesh->clusters();
  Binning binning(job, worker);
  ClusterVertices vertices;
  for (std::size_t first = 0; first < visible.size(); first += lanes) {
    const auto some = visible.subspan(first, std::min<std::size_t>(lanes, visible.size() - first));
    const std::uint32_t hidden = job.skip.hidden ? find_hidden(job, some) : 0;
    for (std::size_t i = 0; i < some.size(); ++i) {
      const Cluster& cluster = clusters.list[some[i].index];
      if ((hidden >> i & 1U) != 0) {
        ++worker.statistics.clusters_hidden;
        worker.statistics.vertices_skipped += cluster.vertex_count;
        continue;
      }
      transform_vertices(job.transform, clusters, cluster, vertices);
      worker.statistics.vertices += cluster.vertex_count;
      worker.statistics.triangles += cluster.triangle_count;
      bin_triangles(job, clusters, cluster, vertices, binning, worker.statistics);
    }
  }
}

}  // namespace rasterlab::RASTERLAB_SIMD
