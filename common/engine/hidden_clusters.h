// Clusters behind what is already drawn.
#pragma once

#include "common/engine/cluster_boxes.h"
#include "common/engine/kernels.h"

namespace rasterlab::RASTERLAB_SIMD {

/// Pixels in the picture, first and last ones included.
struct PixelBounds {
  int left, right, top, bottom;
};

/// The range of (a / w + 1) · half, in pixels, for `lanes` boxes in front of the eye.
struct PixelRange {
  Number low, high;
};
inline PixelRange pixel_range(Range a, Range w, float half) {
  const Number low = select(a.low < Number(0), a.low / w.low, a.low / w.high);
  const Number high = select(a.high > Number(0), a.high / w.low, a.high / w.high);
  return {(low + Number(1)) * Number(half) - Number(1),
          (high + Number(1)) * Number(half) + Number(1)};
}

/// Whether everything drawn in these pixels is nearer than `nearest`.
inline bool is_hidden(const FrameAccess& frame, const PixelBounds& bounds, float nearest) {
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
inline std::uint32_t find_hidden(const DrawJob& job, std::span<const VisibleCluster> visible) {
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

}  // namespace rasterlab::RASTERLAB_SIMD
