// The front end: from clusters of triangles to bins of what may be seen in each tile.
#include "common/engine/binning.h"
#include "common/engine/facing_away.h"
#include "common/engine/folded_parts.h"
#include "common/engine/hidden_clusters.h"
#include "common/engine/simd_kernels.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace rasterlab::RASTERLAB_SIMD {

namespace {

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

/// Of a cluster that is left out.
void skip_vertices(const DrawJob& job, const Cluster& cluster, Statistics& statistics) {
  if (job.skip.skipped_vertices) {
    statistics.vertices_skipped += cluster.vertex_count;
    return;
  }
  ClusterVertices vertices;
  transform_vertices(job.transform, job.mesh->clusters(), cluster, vertices);
  keep(vertices);
  statistics.vertices += cluster.vertex_count;
}

// ---------------------------------------------------------------------------------------------
// A cluster's triangles

/// Whether triangles of this sign of area are to be drawn. Counter-clockwise, seen with y up, is
/// negative here, where y is down.
Truth kept_side(Cull cull, Number area) {
  switch (cull) {
    case Cull::back:
      return area < Number(0);
    case Cull::front:
      return area > Number(0);
    case Cull::none:
      break;
  }
  return area != Number(0);
}

/// Negative, of those that culling leaves out: no pixel is inside all edges of such a triangle.
void orient(Triangles& t, Number area, Truth culled) {
  const Truth clockwise = area > Number(0);
  const Truth swap = (culled && clockwise) || !(culled || clockwise);
  const auto exchange = [swap](auto& a, auto& b) {
    const auto old = a;
    a = select(swap, b, a);
    b = select(swap, old, b);
  };
  exchange(t.x[1], t.x[2]);
  exchange(t.y[1], t.y[2]);
  exchange(t.depth[1], t.depth[2]);
}

/// Depths are mixed of the first corner's and of what the others add. Beyond the far plane, below
/// 0, they may be so far away that added to one of them a nearer one is lost: where a triangle
/// reaches there, its nearest corner becomes the first.
void start_before_far_plane(Triangles& t) {
  const Truth beyond = minimum(minimum(t.depth[0], t.depth[1]), t.depth[2]) < Number(0);
  if (!any(beyond)) return;
  for (int times = 0; times < 2; ++times) {
    const Truth turn = beyond && t.depth[0] < maximum(t.depth[1], t.depth[2]);
    const auto rotate = [turn](auto& a) {
      a = {select(turn, a[1], a[0]), select(turn, a[2], a[1]), select(turn, a[0], a[2])};
    };
    rotate(t.x);
    rotate(t.y);
    rotate(t.depth);
  }
}

void start_before_far_plane(LargeTriangle& t) {
  if (*std::min_element(t.depth.begin(), t.depth.end()) >= 0) return;
  const auto nearest = std::max_element(t.depth.begin(), t.depth.end()) - t.depth.begin();
  std::rotate(t.x.begin(), t.x.begin() + nearest, t.x.end());
  std::rotate(t.y.begin(), t.y.begin() + nearest, t.y.end());
  std::rotate(t.depth.begin(), t.depth.begin() + nearest, t.depth.end());
}

Truth in_picture(const DrawJob& job, const SampleBounds& bounds) {
  return bounds.right >= Ints(0) && bounds.left < Ints(job.frame.width()) &&
         bounds.bottom >= Ints(0) && bounds.top < Ints(job.frame.height());
}

/// One triangle of a clipped polygon.
void bin_part(const DrawJob& job, const ClippedPart& part, bool culled, std::uint32_t key,
              Binning& binning) {
  LargeTriangle triangle;
  triangle.key = key;
  auto& x = triangle.x;
  auto& y = triangle.y;
  auto& depth = triangle.depth;
  for (std::size_t c = 0; c < 3; ++c) {
    x[c] = part.snapped[c].x;
    y[c] = part.snapped[c].y;
    depth[c] = part.corner[c]->reversed_depth();
  }
  if ((part.side() < 0) != culled) {
    std::swap(x[1], x[2]);
    std::swap(y[1], y[2]);
    std::swap(depth[1], depth[2]);
  }
  start_before_far_plane(triangle);
  const PixelBounds pixels = pixels_of(part, job.frame);
  if (pixels.left <= pixels.right && pixels.top <= pixels.bottom) {
    binning.add_large(triangle, pixels);
  }
}

TrianglePositions positions_of(const Clusters& clusters, const Cluster& cluster,
                               std::uint32_t index) {
  TrianglePositions positions;
  for (std::size_t c = 0; c < 3; ++c) {
    const std::uint32_t vertex = cluster.first_vertex + clusters.corner[c][index];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      positions[c][axis] = clusters.position[axis][vertex];
    }
  }
  return positions;
}

/// Triangles that need clipping, one by one.
void bin_clipped(const DrawJob& job, const Clusters& clusters, const Cluster& cluster,
                 std::uint32_t index, Binning& binning, Statistics& statistics) {
  const TrianglePositions positions = positions_of(clusters, cluster, index);
  const std::uint32_t key = job.first_key + clusters.triangle[index];
  const ClippedPolygon polygon = clip_triangle(job.transform, positions);
  const ClippedParts parts = parts_of(job.transform, polygon);
  const bool culled = !any(kept_side(job.cull, Number(static_cast<float>(parts.side))));
  if (culled && job.skip.back_faces) {
    ++statistics.triangles_culled;
    return;
  }
  if (!culled && parts.any_turned_over()) {
    for_each_run(parts, job.frame, key,
                 [&](const LargeTriangle& triangle, const PixelBounds& pixels) {
                   binning.add_large(triangle, pixels);
                 });
    return;
  }
  for (const ClippedPart& part : parts.all()) bin_part(job, part, culled, key, binning);
}

/// Those so thin that snapping may have turned them over. A coordinate is off by less than 2½ of
/// 1/256 pixel, by single precision and by snapping, and so twice the area by less than 5 times
/// what the box around the triangle is wide and high, and 50.
Truth maybe_turned_over(const Triangles& t, Number area) {
  const auto extent = [](const std::array<Ints, 3>& a) {
    return maximum(maximum(a[0], a[1]), a[2]) - minimum(minimum(a[0], a[1]), a[2]);
  };
  return magnitude(area) < Number(6) * as_numbers(extent(t.x) + extent(t.y)) + Number(64);
}

/// Of these triangles those that snapping has turned over: drawn, they would lie on their
/// neighbours (common/projection/cut_outline.h has the same rule).
std::uint32_t turned_over(const DrawJob& job, const Clusters& clusters, const Cluster& cluster,
                          std::uint32_t from, std::uint32_t triangles, Number area) {
  std::uint32_t over = 0;
  const std::uint32_t clockwise = bits(area > Number(0));
  for (; triangles != 0; triangles &= triangles - 1) {
    const auto lane = static_cast<std::uint32_t>(std::countr_zero(triangles));
    const TrianglePositions p = positions_of(clusters, cluster, from + lane);
    const auto corner = [&](std::size_t i) { return to_clipped_corner(job.transform, p[i]); };
    const int side = seen_side(corner(0), corner(1), corner(2));
    const int snapped_side = (clockwise >> lane & 1) != 0 ? 1 : -1;
    if (side == -snapped_side) over |= 1U << lane;
  }
  return over;
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
        bin_clipped(job, clusters, cluster, from + lane, binning, statistics);
      }
    }
    const Number area = twice_area(t, vertices.short_sides);
    const Truth flat = alive && area == Number(0);
    const Truth culled = alive && !flat && !kept_side(job.cull, area);
    const Truth shown = alive && !(flat && truth_if(job.skip.zero_area)) &&
                        !(culled && truth_if(job.skip.back_faces));
    const SampleBounds bounds = sample_bounds(t, job.skip.missed_samples ? 0 : 128);
    const Truth hits = shown && bounds.left <= bounds.right && bounds.top <= bounds.bottom;
    Truth seen = hits && in_picture(job, bounds);
    if (job.cull == Cull::none) {
      const std::uint32_t thin = bits(seen && !flat && maybe_turned_over(t, area));
      if (thin != 0) {
        seen = seen && !truth_of(turned_over(job, clusters, cluster, from, thin, area));
      }
    }
    orient(t, area, culled);
    start_before_far_plane(t);
    statistics.triangles_culled += static_cast<unsigned>(std::popcount(bits(culled && !shown)));
    statistics.triangles_without_area += static_cast<unsigned>(std::popcount(bits(flat && !shown)));
    statistics.triangles_missed += static_cast<unsigned>(std::popcount(bits(shown && !seen)));
    binning.add(t, area, seen, bounds, clusters.triangle.data() + from);
  }
}
}  // namespace

void find_visible(const DrawJob& job, std::uint32_t begin, std::uint32_t end,
                  std::vector<VisibleCluster>& visible, Statistics& statistics) {
  const Clusters& clusters = job.mesh->clusters();
  const WayToEye way(job.transform);
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
    if (job.skip.facing_away && job.cull != Cull::none) {
      const std::uint32_t away =
          kept & bits(facing_away(job, way, boxes, load_facings(clusters.facing, first)));
      statistics.clusters_facing_away += static_cast<unsigned>(std::popcount(away));
      kept &= ~away;
    }
    for (std::uint32_t out = bits(inside) & ~kept; out != 0; out &= out - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(out));
      skip_vertices(job, clusters.list[first + lane], statistics);
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
    const std::uint32_t hidden = job.skip.hidden_clusters ? find_hidden(job, some) : 0;
    for (std::size_t i = 0; i < some.size(); ++i) {
      const Cluster& cluster = clusters.list[some[i].index];
      if ((hidden >> i & 1U) != 0) {
        ++worker.statistics.clusters_hidden;
        skip_vertices(job, cluster, worker.statistics);
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
