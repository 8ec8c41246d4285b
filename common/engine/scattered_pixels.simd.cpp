// What VisibleTriangles does with pixels one by one (scattered_pixels.h).
#include "common/engine/pixel_records.h"
#include "common/engine/visible_triangles.h"

#include <bit>

namespace rasterlab::RASTERLAB_SIMD {

namespace {

/// Pixels of a block whose key is also that of the pixel `distance` further on.
BlockMask same_further_on(const std::uint32_t* key, int distance) {
  BlockMask mask = 0;
  for (int pixel = 0; pixel < 64 - distance; pixel += lanes) {
    const int from = std::min(pixel, 64 - distance - lanes);
    mask |= BlockMask{bits(load(key + from) == load(key + from + distance))} << from;
  }
  return mask;
}

}  // namespace

/// About as many triangles as half the pixels are: counted are the pixels that neither the next one
/// nor the one below goes on with.
bool VisibleTriangles::are_scattered(int block, BlockMask seen) const {
  const std::uint32_t* key = tile_.key + block * 64;
  constexpr BlockMask last_column = 0x8080808080808080;
  const BlockMask go_on = (same_further_on(key, 1) & ~last_column) | same_further_on(key, 8);
  return 2 * std::popcount(seen & ~go_on) > std::popcount(seen);
}

void VisibleTriangles::add_scattered(int block, BlockMask seen) {
  ScatteredPixels& all = scratch_.scattered;
  all.in_block[static_cast<std::size_t>(block)] = seen;
  const PixelOffset place = in_picture(place_of_block(tile_, block));
  const std::uint32_t* key = tile_.key + block * 64;
  for (int pixel = 0; pixel < 64; pixel += lanes) {
    const std::uint32_t here = lanes_at(seen, pixel);
    const auto append = [&](Ints values, ScatteredPixels::Values& to) {
      store_packed(truth_of(here), values, to.data() + all.count);
    };
    const Ints number = iota(pixel);
    append(number + Ints(64 * block), all.place);
    append((number & Ints(7)) + Ints(place.x), all.column);
    append(shift_right<3>(number) + Ints(place.y), all.row);
    append(load(key + pixel), all.slot);
    all.count += static_cast<std::size_t>(std::popcount(here));
  }
}

void VisibleTriangles::find_slots_of_scattered() {
  ScatteredPixels& all = scratch_.scattered;
  find_slots({all.slot.data(), all.count});
  all.repeat_last();
}

void VisibleTriangles::divide_clipped_scattered(std::span<const PartOfClipped> clipped) {
  ScatteredPixels& all = scratch_.scattered;
  for (std::size_t i = 0; i < all.count; ++i) {
    const int block = all.place[i] / 64;
    const int pixel = all.place[i] % 64;
    const auto shows = [&](const PartOfClipped& part) {
      return part.whole == all.slot[i] && (covered(part.corner, block) >> pixel & 1U) != 0;
    };
    const auto part = std::find_if(clipped.begin(), clipped.end(), shows);
    if (part != clipped.end()) all.slot[i] = part->slot;
  }
  all.repeat_last();
}

void VisibleTriangles::paint_scattered() {
  ScatteredPixels& all = scratch_.scattered;
  std::size_t left = 0;
  for (std::size_t i = 0; i < all.count; ++i) {
    const ShadedTriangle& seen = triangle(all.slot[i]);
    if (seen.is_constant) {
      all.color[static_cast<std::size_t>(all.place[i])] = seen.color;
      continue;
    }
    for (auto* values : {&all.place, &all.column, &all.row, &all.slot}) {
      (*values)[left] = (*values)[i];
    }
    ++left;
  }
  all.count = left;
  all.repeat_last();
}

void VisibleTriangles::weigh_scattered(std::size_t first, WeightsInBlock& weights) const {
  const ScatteredPixels& all = scratch_.scattered;
  for (int i = 0; i < 64; i += lanes) {
    const std::size_t at = first + static_cast<std::size_t>(i);
    if (at >= all.count) return;
    const OwnRecords<word::count> records(*this, &all.slot[at]);
    const Ints x = load(&all.column[at]);
    const Ints y = load(&all.row[at]);
    Edges edges = edges_at(records, x, y);
    if (scratch_.any_large) replace_large(&all.slot[at], x, y, edges);
    weights.set(i, edges.weights(to_doubles(records.number(word::ratio1)),
                                 to_doubles(records.number(word::ratio2))));
  }
}

/// Of lanes whose triangles are large, the edge functions that 32 bits don't hold.
void VisibleTriangles::replace_large(const std::int32_t* slot, Ints x, Ints y, Edges& edges) const {
  alignas(64) std::array<std::int32_t, lanes> column;
  alignas(64) std::array<std::int32_t, lanes> row;
  alignas(64) std::array<std::array<double, lanes>, 3> edge;
  store(x, column.data());
  store(y, row.data());
  store(edges.e0, edge[0].data());
  store(edges.e1, edge[1].data());
  store(edges.e2, edge[2].data());
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const ShadedTriangle& shaded = triangle(slot[lane]);
    if (!shaded.is_large) continue;
    const float* words = record(slot[lane]);
    const double e1 = large_edge(shaded, words, 1, column[lane], row[lane]);
    const double e2 = large_edge(shaded, words, 2, column[lane], row[lane]);
    edge[0][lane] = shaded.edges[2] - (e1 + e2);
    edge[1][lane] = e1;
    edge[2][lane] = e2;
  }
  edges = {load(edge[0].data()), load(edge[1].data()), load(edge[2].data())};
}

}  // namespace rasterlab::RASTERLAB_SIMD
