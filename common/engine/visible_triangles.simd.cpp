#include "common/engine/visible_triangles.h"

#include <bit>

namespace rasterlab::RASTERLAB_SIMD {

VisibleTriangles::VisibleTriangles(const DrawJob& job, const Tile& tile,
                                   const CornerVaryings& varyings, Worker& worker)
    : job_(job),
      mesh_(job.mesh->mesh()),
      tile_(tile),
      varyings_(varyings),
      blocks_shift_(std::countr_zero(static_cast<unsigned>(tile.blocks_per_row()))),
      scratch_(worker.scratch),
      statistics_(worker.statistics) {}

void VisibleTriangles::take_all() {
  collect();
  set_up();
  resolve_clipped_pixels();
}

void VisibleTriangles::take_one(std::uint32_t key, BlockMask covered) {
  scratch_.slot.assign(64, no_slot);
  scratch_.block_slot.assign(1, mixed);
  scratch_.key.assign(1, key);
  for (BlockMask rest = covered; rest != 0; rest &= rest - 1) {
    scratch_.slot[static_cast<std::size_t>(std::countr_zero(rest))] = 0;
  }
  set_up();
  resolve_clipped_pixels();
}

// ---------------------------------------------------------------------------------------------
// Which triangles are seen

namespace {

constexpr int table_bits = 12;

/// Where in the hash table keys belong.
Ints table_index(Ints key) {
  return shift_right<32 - table_bits>(key * Ints(static_cast<std::int32_t>(2654435761U))) &
         Ints((1 << table_bits) - 1);
}

bool same_everywhere(const std::uint32_t* key) {
  const Ints first(static_cast<std::int32_t>(key[0]));
  Truth same = load(key) == first;
  for (int pixel = lanes; pixel < 64; pixel += lanes) same = same && load(key + pixel) == first;
  return all(same);
}

}  // namespace

void VisibleTriangles::collect() {
  const auto blocks = static_cast<std::size_t>(tile_.block_count());
  scratch_.slot.resize(blocks * 64);
  scratch_.block_slot.resize(blocks);
  scratch_.table.resize(std::size_t{1} << table_bits);
  scratch_.key.clear();
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::uint32_t* key = tile_.key + block * 64;
    std::int32_t* slot = scratch_.slot.data() + block * 64;
    if (same_everywhere(key)) {
      scratch_.block_slot[block] = key[0] >= job_.first_key ? slot_of(key[0]) : no_slot;
      std::fill_n(slot, 64, scratch_.block_slot[block]);
    } else {
      scratch_.block_slot[block] = mixed;
      collect_block(key, slot);
    }
  }
}

/// slot_of() for a vector at a time, as far as triangles have a slot already.
void VisibleTriangles::collect_block(const std::uint32_t* key, std::int32_t* slot) {
  for (int pixel = 0; pixel < 64; pixel += lanes) {
    const Ints wanted = load(key + pixel);
    const Truth owned = wanted >= Ints(static_cast<std::int32_t>(job_.first_key));
    const Ints last(static_cast<std::int32_t>(scratch_.key.size()) - 1);
    const Ints entry = gather_ints(scratch_.table.data(), table_index(wanted));
    Truth known = entry <= last;
    if (!scratch_.key.empty()) {
      known = known && gather_ints(scratch_.key.data(), minimum(entry, last)) == wanted;
    }
    store(select(owned && known, entry, Ints(no_slot)), slot + pixel);
    for (std::uint32_t rest = bits(owned && !known); rest != 0; rest &= rest - 1) {
      const int lane = std::countr_zero(rest);
      slot[pixel + lane] = slot_of(key[pixel + lane]);
    }
  }
}

/// A table entry is believed when the list of keys confirms it, so it need not be cleared; a
/// triangle that lost its entry to another is only set up twice.
std::int32_t VisibleTriangles::slot_of(std::uint32_t key) {
  const Ints index = table_index(Ints(static_cast<std::int32_t>(key)));
  std::uint32_t& entry = scratch_.table[static_cast<std::size_t>(hn::GetLane(index.v))];
  if (entry >= scratch_.key.size() || scratch_.key[entry] != key) {
    entry = static_cast<std::uint32_t>(scratch_.key.size());
    scratch_.key.push_back(key);
  }
  return static_cast<std::int32_t>(entry);
}

// ---------------------------------------------------------------------------------------------
// Setting them up

/// The mesh's triangles in these lanes; corner 0 is the one with the lowest vertex index.
struct VisibleTriangles::CornerLanes {
  std::array<Ints, 3> vertex;
  Ints first;  ///< which of the mesh's corners is corner 0
};

/// Their window corners and w.
struct VisibleTriangles::TriangleLanes {
  std::array<Ints, 3> x;
  std::array<Ints, 3> y;
  std::array<Number, 3> w;
};

void VisibleTriangles::reserve_slots(std::size_t count) {
  const std::size_t size = count * static_cast<std::size_t>(varyings_.record_size());
  if (scratch_.record.size() < size) scratch_.record.resize(size);
  if (scratch_.exact_edges.size() < count) scratch_.exact_edges.resize(count);
}

void VisibleTriangles::set_up() {
  const std::size_t count = scratch_.key.size();
  scratch_.clipped.clear();
  reserve_slots(count);
  for (std::size_t first = 0; first < count; first += lanes) {
    set_up_some(first, std::min<std::size_t>(lanes, count - first));
  }
  statistics_.triangles_shaded += count;
}

VisibleTriangles::CornerLanes VisibleTriangles::corner_order(Ints triangle) const {
  const auto* flat = reinterpret_cast<const std::int32_t*>(mesh_.triangles.data());
  const Ints at = triangle * Ints(3);
  const Ints a = gather_ints(flat, at);
  const Ints b = gather_ints(flat + 1, at);
  const Ints c = gather_ints(flat + 2, at);
  const Truth from_b = b < a && b <= c;
  const Truth from_c = !from_b && c < a && c < b;
  return {{select(from_b, b, select(from_c, c, a)), select(from_b, c, select(from_c, a, b)),
           select(from_b, a, select(from_c, b, c))},
          select(from_b, Ints(1), select(from_c, Ints(2), Ints(0)))};
}

std::array<Number, 3> VisibleTriangles::position(Ints vertex) const {
  const auto* flat = reinterpret_cast<const float*>(mesh_.positions.data());
  const Ints at = vertex * Ints(3);
  return {gather_numbers(flat, at), gather_numbers(flat + 1, at), gather_numbers(flat + 2, at)};
}

void VisibleTriangles::set_up_some(std::size_t first_slot, std::size_t count) {
  std::array<std::uint32_t, lanes> key;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    key[lane] = scratch_.key[first_slot + std::min(lane, count - 1)];
  }
  const CornerLanes corners =
      corner_order(load(key.data()) - Ints(static_cast<std::int32_t>(job_.first_key)));
  TriangleLanes triangles;
  Truth direct = Ints(0) == Ints(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array<Number, 3> p = position(corners.vertex[i]);
    const ClipPoints clip = to_clip(job_.transform, p[0], p[1], p[2]);
    const WindowPoints window = to_window(job_.transform, clip);
    direct = direct && window.direct;
    triangles.x[i] = window.x;
    triangles.y[i] = window.y;
    triangles.w[i] = clip.w;
  }
  write_geometry(triangles, first_slot, count);
  std::array<std::int32_t, lanes> first;
  store(corners.first, first.data());
  const std::uint32_t usable = bits(direct);
  for (std::size_t lane = 0; lane < count; ++lane) {
    const std::size_t slot = first_slot + lane;
    if ((usable >> lane & 1U) == 0) {
      scratch_.clipped.push_back(static_cast<std::uint32_t>(slot));
      continue;
    }
    float* values = record(slot) + word::count;
    varyings_.write(job_.shader, mesh_, triangle_of(key[lane]), first[lane], values);
    write_differences(values);
  }
}

/// Of corners 1 and 2, the differences from corner 0 in place of the values.
void VisibleTriangles::write_differences(float* corners) const {
  for (int i = 0; i < varyings_.count; ++i) {
    corners[varyings_.count + i] -= corners[i];
    corners[2 * varyings_.count + i] -= corners[i];
  }
}

void VisibleTriangles::write_geometry(const TriangleLanes& t, std::size_t first_slot,
                                      std::size_t count) {
  const Ints px(tile_.left * 256 + 128);
  const Ints py(tile_.top * 256 + 128);
  const auto& x = t.x;
  const auto& y = t.y;
  const auto exact_product = [](Ints a, Ints b) { return to_doubles(a) * to_doubles(b); };
  const Doubles exact_area =
      exact_product(x[1] - x[0], y[2] - y[0]) - exact_product(y[1] - y[0], x[2] - x[0]);
  const Number area = to_number(exact_area);
  const Ints side = select(area > Number(0), Ints(1), Ints(-1));
  const Truth is_large = magnitude(area) >= Number(2147483648.0F);
  // Edge 1 runs from corner 2 to 0, edge 2 from 0 to 1. These are modulo 2^32.
  std::array<Ints, word::count> words;
  words[word::step1_x] = side * (y[2] - y[0]);
  words[word::step1_y] = side * (x[0] - x[2]);
  words[word::step2_x] = side * (y[0] - y[1]);
  words[word::step2_y] = side * (x[1] - x[0]);
  words[word::edge1] = words[word::step1_y] * (py - y[2]) + words[word::step1_x] * (px - x[2]);
  words[word::edge2] = words[word::step2_y] * (py - y[0]) + words[word::step2_x] * (px - x[0]);
  words[word::area] = side * ((x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]));
  words[word::ratio1] = bit_pattern(t.w[0] / t.w[1]);
  words[word::ratio2] = bit_pattern(t.w[0] / t.w[2]);
  const Ints front(job_.mirrored ? 1 : -1);
  words[word::front] = select(side == front, Ints(1), Ints(0));
  words[word::is_large] = select(is_large, Ints(1), Ints(0));
  words[word::unused] = Ints(0);
  alignas(64) std::array<std::array<std::int32_t, lanes>, word::count> by_lane;
  for (std::size_t i = 0; i < words.size(); ++i) store(words[i], by_lane[i].data());
  for (std::size_t lane = 0; lane < count; ++lane) {
    float* to = record(first_slot + lane);
    for (std::size_t i = 0; i < words.size(); ++i) to[i] = std::bit_cast<float>(by_lane[i][lane]);
  }
  // Of all: a vector of pixels that has a large triangle asks the others for theirs as well.
  const std::array<Doubles, 3> exact = {exact_product(words[word::step1_y], py - y[2]) +
                                            exact_product(words[word::step1_x], px - x[2]),
                                        exact_product(words[word::step2_y], py - y[0]) +
                                            exact_product(words[word::step2_x], px - x[0]),
                                        exact_area * to_doubles(side)};
  for (std::size_t i = 0; i < exact.size(); ++i) {
    alignas(64) std::array<double, lanes> values;
    store(exact[i], values.data());
    for (std::size_t lane = 0; lane < count; ++lane) {
      scratch_.exact_edges[first_slot + lane][i] = values[lane];
    }
  }
}

// ---------------------------------------------------------------------------------------------
// Triangles that were clipped: their pixels belong to one of the parts

void VisibleTriangles::resolve_clipped_pixels() {
  std::vector<float> corners(static_cast<std::size_t>(3 * varyings_.count));
  std::size_t next_slot = scratch_.key.size();
  for (const std::uint32_t whole : scratch_.clipped) {
    const std::uint32_t triangle = triangle_of(scratch_.key[whole]);
    const CornerLanes order = corner_order(Ints(static_cast<std::int32_t>(triangle)));
    TrianglePositions positions;
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector3f& p =
          mesh_.positions[static_cast<std::size_t>(hn::GetLane(order.vertex[i].v))];
      positions[i] = {p.x(), p.y(), p.z()};
    }
    const ClippedPolygon polygon = clip_triangle(job_.transform, positions);
    varyings_.write(job_.shader, mesh_, triangle, hn::GetLane(order.first.v), corners.data());
    for_each_part(job_.transform, polygon, [&](const ClippedPart& part) {
      if (twice_area(part.snapped[0], part.snapped[1], part.snapped[2]) == 0) return;
      add_part(part, corners.data(), static_cast<std::int32_t>(whole), next_slot);
      ++next_slot;
    });
  }
}

void VisibleTriangles::add_part(const ClippedPart& part, const float* corners, std::int32_t whole,
                                std::size_t slot) {
  reserve_slots(slot + 1);
  TriangleLanes lanes_of_part;
  const auto count = static_cast<std::size_t>(varyings_.count);
  float* values = record(slot) + word::count;
  for (std::size_t c = 0; c < 3; ++c) {
    const ClippedCorner& corner = *part.corner[c];
    lanes_of_part.x[c] = Ints(part.snapped[c].x);
    lanes_of_part.y[c] = Ints(part.snapped[c].y);
    lanes_of_part.w[c] = Number(corner.w);
    for (std::size_t i = 0; i < count; ++i) {
      const double a0 = corners[i];
      values[c * count + i] = static_cast<float>(
          a0 + (corner.b1 * (corners[count + i] - a0) + corner.b2 * (corners[2 * count + i] - a0)));
    }
  }
  write_differences(values);
  write_geometry(lanes_of_part, slot, 1);
  for (std::size_t pixel = 0; pixel < scratch_.slot.size(); ++pixel) {
    if (scratch_.slot[pixel] == whole && covers(part.snapped, static_cast<int>(pixel))) {
      scratch_.slot[pixel] = static_cast<std::int32_t>(slot);
      scratch_.block_slot[pixel / 64] = mixed;
    }
  }
}

/// Boundaries included: the depth pass has decided already that the pixel is this triangle's.
bool VisibleTriangles::covers(const std::array<SnappedCorner, 3>& corner, int pixel) const {
  const Place block = place_of_block(pixel / 64);
  const SnappedCorner center = {(tile_.left + block.x + pixel % 8) * 256 + 128,
                                (tile_.top + block.y + pixel / 8 % 8) * 256 + 128};
  const bool clockwise = twice_area(corner[0], corner[1], corner[2]) > 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int64_t edge = twice_area(corner[i], corner[(i + 1) % 3], center);
    if (clockwise ? edge < 0 : edge > 0) return false;
  }
  return true;
}

// ---------------------------------------------------------------------------------------------
// For shading

Edges VisibleTriangles::exact_edges(int block, int first, const std::int32_t* slot) const {
  std::array<std::array<double, lanes>, 3> exact;
  std::array<std::array<std::int32_t, lanes>, 4> step;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const auto triangle = static_cast<std::size_t>(slot[lane]);
    for (std::size_t i = 0; i < 3; ++i) exact[i][lane] = scratch_.exact_edges[triangle][i];
    for (std::size_t i = 0; i < 4; ++i) {
      step[i][lane] = std::bit_cast<std::int32_t>(record(slot[lane])[word::step1_x + i]);
    }
  }
  const Place place = place_of_block(block);
  const Ints pixel = iota(first);
  const Doubles x = to_doubles(((pixel & Ints(7)) + Ints(place.x)) * Ints(256));
  const Doubles y = to_doubles((shift_right<3>(pixel) + Ints(place.y)) * Ints(256));
  const auto edge = [&](std::size_t i) {
    return load(exact[i].data()) + (x * to_doubles(load(step[2 * i].data())) +
                                    y * to_doubles(load(step[2 * i + 1].data())));
  };
  return {edge(0), edge(1), load(exact[2].data())};
}

namespace {

Rgb8 unpacked(std::uint32_t color) {
  return {static_cast<std::uint8_t>(color), static_cast<std::uint8_t>(color >> 8U),
          static_cast<std::uint8_t>(color >> 16U)};
}

/// Eight pixels, and not a byte beyond: the next pixel may be another thread's.
void write_row(const std::uint32_t* packed, Rgb8* row) {
#if HWY_TARGET == HWY_SCALAR
  for (int i = 0; i < 8; ++i) row[i] = unpacked(packed[i]);
#else
  // Leaves out every fourth byte; 255 stands for none.
  alignas(16) static constexpr std::array<std::uint8_t, 16> first = {
      0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 255, 255, 255, 255};
  alignas(16) static constexpr std::array<std::uint8_t, 16> second_low = {
      255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 0, 1, 2, 4};
  alignas(16) static constexpr std::array<std::uint8_t, 16> second_high = {
      5, 6, 8, 9, 10, 12, 13, 14, 255, 255, 255, 255, 255, 255, 255, 255};
  const hn::Full128<std::uint8_t> tag;
  const hn::Half<decltype(tag)> half;
  const auto four = [&](const std::uint32_t* from) {
    return hn::BitCast(tag, hn::LoadU(hn::Full128<std::uint32_t>(), from));
  };
  const auto take = [&](auto bytes, const std::array<std::uint8_t, 16>& which) {
    return hn::TableLookupBytesOr0(bytes, hn::Load(tag, which.data()));
  };
  auto* to = reinterpret_cast<std::uint8_t*>(row);
  const auto low = four(packed);
  const auto high = four(packed + 4);
  hn::StoreU(hn::Or(take(low, first), take(high, second_low)), tag, to);
  hn::StoreU(hn::LowerHalf(half, take(high, second_high)), half, to + 16);
#endif
}

}  // namespace

void VisibleTriangles::write_colors(int block, const std::uint32_t* packed, BlockMask mask) const {
  const Place place = place_of_block(block);
  Rgb8* row = tile_.color + place.y * tile_.stride + place.x;
  const int columns = std::min(tile_.width - place.x, 8);
  const int rows = std::min(tile_.height - place.y, 8);
  const std::uint32_t inside = columns > 0 ? 0xFFU >> (8 - columns) : 0U;
  for (int y = 0; y < rows; ++y, row += tile_.stride, packed += 8, mask >>= 8U) {
    std::uint32_t here = static_cast<std::uint32_t>(mask) & inside;
    if (here == 0xFFU) {
      write_row(packed, row);
      continue;
    }
    for (; here != 0; here &= here - 1) {
      const int x = std::countr_zero(here);
      row[x] = unpacked(packed[x]);
    }
  }
}

}  // namespace rasterlab::RASTERLAB_SIMD
