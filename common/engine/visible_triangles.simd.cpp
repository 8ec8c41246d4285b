#include "common/engine/visible_triangles.h"

#include "common/engine/blocks.h"
#include "common/engine/pixel_records.h"

#include <bit>
#include <type_traits>

namespace rasterlab::RASTERLAB_SIMD {

VisibleTriangles::VisibleTriangles(const DrawJob& job, const Tile& tile,
                                   const CornerVaryings& varyings, Worker& worker)
    : job_(job),
      mesh_(job.mesh->mesh()),
      tile_(tile),
      varyings_(varyings),
      scratch_(worker.scratch),
      statistics_(worker.statistics) {}

void VisibleTriangles::take_all() {
  prefetch_colors(0);
  forget_or_keep();
  collect();
  set_up();
  resolve_clipped_pixels();
}

void VisibleTriangles::take_one(std::uint32_t key, BlockMask covered) {
  scratch_.forget();
  reserve_keys(1);
  scratch_.key[scratch_.slot_count++] = key;
  scratch_.part.assign(1, {covered, 0});
  scratch_.parts_end.assign(1, 1);
  scratch_.scattered.clear();
  set_up();
  resolve_clipped_pixels();
}

// ---------------------------------------------------------------------------------------------
// Which triangles are seen

namespace {

/// Slots. With more, their records would be further away than what they are made of.
constexpr std::size_t most_kept = 4096;

constexpr int table_bits = 14;
constexpr std::uint32_t spread = 2654435761U;

/// Triangles: a few times what a processor can wait for at once, and not more than fits near it.
constexpr std::size_t fetched_at_once = 128;

/// Where in the hash table a key belongs.
std::size_t table_index(std::uint32_t key) {
  return key * spread >> (32 - table_bits);
}

/// The pixels of a block whose keys, given a vector at a time, fulfil a condition.
template <class Condition>
BlockMask pixels_where(const std::uint32_t* key, const Condition& condition) {
  BlockMask mask = 0;
  for (int pixel = 0; pixel < 64; pixel += lanes) {
    mask |= BlockMask{bits(condition(load(key + pixel)))} << pixel;
  }
  return mask;
}

}  // namespace

/// Those of the tiles before, whose neighbours may see them too. Not where some were clipped: of
/// these a tile only has the parts that it sees.
void VisibleTriangles::forget_or_keep() {
  if (scratch_.slot_count > most_kept || !scratch_.clipped.empty()) scratch_.forget();
  first_new_ = scratch_.slot_count;
}

void VisibleTriangles::collect() {
  const auto blocks = static_cast<std::size_t>(tile_.block_count());
  scratch_.table.resize(std::size_t{1} << table_bits);
  reserve_keys(static_cast<std::size_t>(tile_.pixel_count()));
  scratch_.part.clear();
  scratch_.scattered.clear();
  scratch_.parts_end.resize(blocks);
  if (tile_.undisputed != nullptr) {
    scratch_.slot_of_plane.assign(tile_.undisputed->planes().size(), -1);
  }
  for (std::size_t block = 0; block < blocks; ++block) {
    if (tile_.undisputed != nullptr && tile_.undisputed->has(static_cast<int>(block))) {
      collect_undisputed(static_cast<int>(block));
    } else {
      collect_block(static_cast<int>(block));
    }
    scratch_.parts_end[block] = static_cast<std::uint32_t>(scratch_.part.size());
  }
  find_slots_of_scattered();
}

void VisibleTriangles::collect_undisputed(int block) {
  const BlockMask in_picture = inside(block);
  for (const UndisputedBlocks::Part& part : tile_.undisputed->parts(block)) {
    if ((part.pixels & in_picture) == 0) continue;
    std::int32_t& slot = scratch_.slot_of_plane[static_cast<std::size_t>(part.plane)];
    if (slot < 0) slot = slot_of(tile_.undisputed->plane_of(part).key);
    scratch_.part.push_back({part.pixels & in_picture, slot});
  }
}

void VisibleTriangles::collect_block(int block) {
  const std::uint32_t* key = tile_.key + block * 64;
  const Ints first(static_cast<std::int32_t>(job_.first_key));
  const BlockMask seen =
      pixels_where(key, [&](Ints keys) { return keys >= first; }) & inside(block);
  const auto pixels_of = [&](std::uint32_t one) {
    const Ints wanted(static_cast<std::int32_t>(one));
    return pixels_where(key, [&](Ints keys) { return keys == wanted; });
  };
  // From both ends: two searches that needn't wait for each other.
  for (BlockMask rest = seen; rest != 0;) {
    const std::uint32_t one = key[std::countr_zero(rest)];
    const std::uint32_t other = key[63 - std::countl_zero(rest)];
    const BlockMask of_one = rest & pixels_of(one);
    const BlockMask of_other = rest & pixels_of(other);
    const bool maybe_scattered =
        rest == seen && 4 * std::popcount(of_one | of_other) < std::popcount(seen);
    if (maybe_scattered && are_scattered(block, seen)) {
      add_scattered(block, seen);
      return;
    }
    scratch_.part.push_back({of_one, slot_of(one)});
    if (other != one) scratch_.part.push_back({of_other, slot_of(other)});
    rest &= ~(of_one | of_other);
  }
}

BlockMask VisibleTriangles::inside(int block) const {
  const PixelOffset place = place_of_block(tile_, block);
  const int columns = std::clamp(tile_.width - place.x, 0, 8);
  const int rows = std::clamp(tile_.height - place.y, 0, 8);
  if (columns == 0 || rows == 0) return 0;
  constexpr BlockMask every_row = 0x0101010101010101;
  return (every_row >> (64 - 8 * rows)) * (0xFFU >> (8 - columns));
}

/// Slots in place of keys. A table entry is believed when the list of keys confirms it, so it need
/// not be cleared; a triangle that lost its entry to another is only set up twice. Without
/// branches, for nobody guesses where a triangle is seen first.
void VisibleTriangles::find_slots(std::span<std::int32_t> values) {
  std::uint32_t* const table = scratch_.table.data();
  std::uint32_t* const keys = scratch_.key.data();
  auto count = static_cast<std::uint32_t>(scratch_.slot_count);
  for (std::int32_t& value : values) {
    const auto key = static_cast<std::uint32_t>(value);
    std::uint32_t& entry = table[table_index(key)];
    const std::uint32_t old = entry;
    const std::uint32_t known = std::uint32_t{old < count} & std::uint32_t{keys[old] == key};
    const std::uint32_t slot = count ^ ((count ^ old) & (0U - known));
    keys[count] = key;
    entry = slot;
    value = static_cast<std::int32_t>(slot);
    count += 1U - known;
  }
  scratch_.slot_count = count;
}

std::int32_t VisibleTriangles::slot_of(std::uint32_t key) {
  auto value = static_cast<std::int32_t>(key);
  find_slots({&value, 1});
  return value;
}

void VisibleTriangles::reserve_keys(std::size_t more) {
  const std::size_t size = scratch_.slot_count + more + 1;
  if (scratch_.key.size() < size) scratch_.key.resize(size);
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
  Truth direct;  ///< not clipped: these are right

  /// Twice the area, with y down.
  Doubles exact_area() const {
    return exact_product(x[1] - x[0], y[2] - y[0]) - exact_product(y[1] - y[0], x[2] - x[0]);
  }

  static Doubles exact_product(Ints a, Ints b) { return to_doubles(a) * to_doubles(b); }
};

void VisibleTriangles::reserve_slots(std::size_t count) {
  const std::size_t size = count * static_cast<std::size_t>(varyings_.record_size());
  if (scratch_.record.size() < size) scratch_.record.resize(size);
  if (scratch_.triangle.size() < count) scratch_.triangle.resize(count);
}

void VisibleTriangles::set_up() {
  const std::size_t end = scratch_.slot_count;
  reserve_slots(end);
  for (std::size_t some = first_new_; some < end; some += fetched_at_once) {
    const std::size_t some_end = std::min(some + fetched_at_once, end);
    fetch_vertices(some, some_end - some);
    for (std::size_t first = some; first < some_end; first += lanes) {
      set_up_some(first, std::min<std::size_t>(lanes, some_end - first));
    }
  }
  statistics_.triangles_shaded += end - first_new_;
}

/// Reads of all these triangles' vertices, one after the other, so that they are near when they are
/// asked for: triangles seen in a tile may lie anywhere in the mesh, and each would have to wait
/// for memory by itself. (Prefetch instructions do not do it: where a page isn't known they do
/// nothing.)
void VisibleTriangles::fetch_vertices(std::size_t first_slot, std::size_t count) {
  const auto keys = std::span(scratch_.key).subspan(first_slot, count);
  std::uint32_t vertices = 0;
  for (const std::uint32_t key : keys) vertices += mesh_.triangles[triangle_of(key)].front();
  float sum = static_cast<float>(vertices);
  for (const std::uint32_t key : keys) {
    for (const std::uint32_t vertex : mesh_.triangles[triangle_of(key)]) {
      if (!mesh_.normals.empty()) sum += mesh_.normals[vertex].x();
      if (scratch_.likely_constant) continue;
      sum += mesh_.positions[vertex].x();
      if (!mesh_.texture_coordinates.empty()) sum += mesh_.texture_coordinates[vertex].x();
    }
  }
  scratch_.fetched = sum;
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

VisibleTriangles::TriangleLanes VisibleTriangles::in_window(const CornerLanes& corners) const {
  TriangleLanes triangles;
  triangles.direct = Ints(0) == Ints(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array<Number, 3> p = position(corners.vertex[i]);
    const ClipPoints clip = to_clip(job_.transform, p[0], p[1], p[2]);
    const WindowPoints window = to_window(job_.transform, clip);
    triangles.direct = triangles.direct && window.direct;
    triangles.x[i] = window.x;
    triangles.y[i] = window.y;
    triangles.w[i] = clip.w;
  }
  return triangles;
}

/// Varyings first: triangles that are the same all over lie anywhere. Where there is one such, the
/// next ones are likely like it, and their positions needn't be fetched.
void VisibleTriangles::set_up_some(std::size_t first_slot, std::size_t count) {
  std::array<std::uint32_t, lanes> key;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    key[lane] = scratch_.key[first_slot + std::min(lane, count - 1)];
  }
  const CornerLanes corners =
      corner_order(load(key.data()) - Ints(static_cast<std::int32_t>(job_.first_key)));
  std::array<std::int32_t, lanes> first;
  store(corners.first, first.data());
  std::uint32_t varying = 0;
  for (std::size_t lane = 0; lane < count; ++lane) {
    const std::size_t slot = first_slot + lane;
    const bool varies = varyings_.write_record(job_.shader, mesh_, triangle_of(key[lane]),
                                               first[lane], record(slot) + word::count);
    scratch_.triangle[slot].is_constant = !varies;
    if (varies) {
      varying |= 1U << lane;
    } else {
      scratch_.any_constant = true;
    }
  }
  scratch_.likely_constant = varying == 0;
  if (varying == 0) return;
  const TriangleLanes triangles = in_window(corners);
  write_geometry(triangles, first_slot, count);
  for (varying &= ~bits(triangles.direct); varying != 0; varying &= varying - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(varying));
    scratch_.clipped.push_back(static_cast<std::uint32_t>(first_slot + lane));
  }
}

/// Of the first lane's triangle, from its corner 0 on.
ClippedPolygon VisibleTriangles::clipped(const CornerLanes& corners) const {
  TrianglePositions positions;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3f& p =
        mesh_.positions[static_cast<std::size_t>(hn::GetLane(corners.vertex[i].v))];
    positions[i] = {p.x(), p.y(), p.z()};
  }
  return clip_triangle(job_.transform, positions);
}

bool VisibleTriangles::shows_front(std::int32_t slot) const {
  const std::uint32_t triangle = triangle_of(scratch_.key[static_cast<std::size_t>(slot)]);
  const CornerLanes corners = corner_order(Ints(static_cast<std::int32_t>(triangle)));
  const TriangleLanes lanes_of_one = in_window(corners);
  const bool positive = all(lanes_of_one.direct)
                            ? all(to_number(lanes_of_one.exact_area()) > Number(0))
                            : parts_of(job_.transform, clipped(corners)).side > 0;
  return positive == job_.mirrored;
}

/// Into the lanes' records, four at a time and the last one by itself.
void VisibleTriangles::write_words(const std::array<Ints, word::count>& words,
                                   std::size_t first_slot, std::size_t count) {
  static_assert(word::count % 4 == 1);
  std::array<float*, lanes> to{};
  for (std::size_t lane = 0; lane < count; ++lane) to[lane] = record(first_slot + lane);
  for (std::size_t i = 0; i + 4 < words.size(); i += 4) {
    std::array<Number, 4> fours;
    for (std::size_t j = 0; j < 4; ++j) fours[j] = from_bit_pattern(words[i + j]);
    store_fours(fours.data(), to.data(), static_cast<int>(count));
    for (std::size_t lane = 0; lane < count; ++lane) to[lane] += 4;
  }
  alignas(64) std::array<float, lanes> last;
  store(from_bit_pattern(words.back()), last.data());
  for (std::size_t lane = 0; lane < count; ++lane) *to[lane] = last[lane];
}

void VisibleTriangles::write_geometry(const TriangleLanes& t, std::size_t first_slot,
                                      std::size_t count) {
  const Ints px(128);  // the centre of the picture's first pixel
  const Ints py(128);
  const auto& x = t.x;
  const auto& y = t.y;
  const auto exact_product = &TriangleLanes::exact_product;
  const Doubles exact_area = t.exact_area();
  const Number area = to_number(exact_area);
  const Ints side = select(area > Number(0), Ints(1), Ints(-1));
  const auto length = [](Ints a) { return magnitude(as_numbers(a)); };
  const Number steps =
      length(x[0] - x[1]) + length(x[0] - x[2]) + length(y[0] - y[1]) + length(y[0] - y[2]);
  // Within a block edge functions differ by 7 steps each way.
  const Truth is_large = magnitude(area) + steps * Number(2048) >= Number(2147483000.0F);
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
  write_words(words, first_slot, count);
  const std::uint32_t large = bits(is_large);
  const std::uint32_t front = bits(side == Ints(job_.mirrored ? 1 : -1));
  for (std::size_t lane = 0; lane < count; ++lane) {
    ShadedTriangle& triangle = scratch_.triangle[first_slot + lane];
    triangle.is_large = (large >> lane & 1U) != 0;
    triangle.front = (front >> lane & 1U) != 0;
  }
  if (large == 0) return;
  scratch_.any_large = true;
  const std::array<Doubles, 3> exact = {exact_product(words[word::step1_y], py - y[2]) +
                                            exact_product(words[word::step1_x], px - x[2]),
                                        exact_product(words[word::step2_y], py - y[0]) +
                                            exact_product(words[word::step2_x], px - x[0]),
                                        exact_area * to_doubles(side)};
  for (std::size_t i = 0; i < exact.size(); ++i) {
    alignas(64) std::array<double, lanes> values;
    store(exact[i], values.data());
    for (std::size_t lane = 0; lane < count; ++lane) {
      scratch_.triangle[first_slot + lane].edges[i] = values[lane];
    }
  }
}

// ---------------------------------------------------------------------------------------------
// Triangles that were clipped: their pixels belong to one of the parts

void VisibleTriangles::resolve_clipped_pixels() {
  if (scratch_.clipped.empty()) return;
  std::vector<PartOfClipped> parts;
  std::vector<float> corners(static_cast<std::size_t>(3 * varyings_.count));
  for (const std::uint32_t whole : scratch_.clipped) {
    const std::uint32_t triangle = triangle_of(scratch_.key[whole]);
    const CornerLanes order = corner_order(Ints(static_cast<std::int32_t>(triangle)));
    const ClippedPolygon polygon = clipped(order);
    varyings_.write(job_.shader, mesh_, triangle, hn::GetLane(order.first.v), corners.data());
    const ClippedParts clipped = parts_of(job_.transform, polygon);
    for (const ClippedPart& part : clipped.all()) {
      if (part.side() != clipped.side) continue;
      parts.push_back({static_cast<std::int32_t>(whole), slot_count(), part.snapped});
      add_slot(part, corners.data());
    }
  }
  divide_clipped_triangles(parts);
  divide_clipped_scattered(parts);
}

void VisibleTriangles::add_slot(const ClippedPart& part, const float* corners) {
  const std::size_t slot = scratch_.slot_count;
  reserve_keys(1);
  reserve_slots(slot + 1);
  scratch_.key[scratch_.slot_count++] = 0;
  TriangleLanes lanes_of_part;
  const auto count = static_cast<std::size_t>(varyings_.count);
  const auto value = [&](std::size_t c, std::size_t i) {
    const ClippedCorner& corner = *part.corner[c];
    const double a0 = corners[i];
    return static_cast<float>(
        a0 + (corner.b1 * (corners[count + i] - a0) + corner.b2 * (corners[2 * count + i] - a0)));
  };
  float* numbers = record(slot) + word::count;
  bool differ = false;
  for (std::size_t i = 0; i < count; ++i) {
    numbers[i] = value(0, i);
    for (std::size_t c = 1; c < 3; ++c) {
      const float difference = value(c, i) - numbers[i];
      numbers[c * count + i] = difference;
      differ = differ || difference != 0;
    }
  }
  for (std::size_t c = 0; c < 3; ++c) {
    lanes_of_part.x[c] = Ints(part.snapped[c].x);
    lanes_of_part.y[c] = Ints(part.snapped[c].y);
    lanes_of_part.w[c] = Number(static_cast<float>(part.corner[c]->w));
  }
  write_geometry(lanes_of_part, slot, 1);
  scratch_.triangle[slot].is_constant = !differ;
  scratch_.any_constant = scratch_.any_constant || !differ;
}

/// In the lists of the blocks, the parts in place of the whole. A pixel on the line between two is
/// the first one's.
void VisibleTriangles::divide_clipped_triangles(std::span<const PartOfClipped> clipped) {
  std::vector<VisiblePart> divided;
  std::vector<std::uint32_t> ends;
  for (int block = 0; block < tile_.block_count(); ++block) {
    for (VisiblePart whole : parts(block)) {
      for (const PartOfClipped& part : clipped) {
        if (part.whole != whole.slot) continue;
        const BlockMask here = whole.mask & covered(part.corner, block);
        if (here != 0) divided.push_back({here, part.slot});
        whole.mask &= ~here;
      }
      if (whole.mask != 0) divided.push_back(whole);
    }
    ends.push_back(static_cast<std::uint32_t>(divided.size()));
  }
  scratch_.part.swap(divided);
  scratch_.parts_end.swap(ends);
}

/// Boundaries included: the depth pass has decided already that the pixel is this triangle's.
BlockMask VisibleTriangles::covered(const std::array<SnappedCorner, 3>& corner, int block) const {
  const PixelOffset place = place_of_block(tile_, block);
  const double side = twice_area(corner[0], corner[1], corner[2]) > 0 ? 1 : -1;
  BlockMask mask = 0;
  for (int first = 0; first < 64; first += lanes) {
    const Ints pixel = iota(first);
    const Ints x = ((pixel & Ints(7)) + Ints(tile_.left + place.x)) * Ints(256) + Ints(128);
    const Ints y = (shift_right<3>(pixel) + Ints(tile_.top + place.y)) * Ints(256) + Ints(128);
    Truth inside = Ints(0) == Ints(0);
    for (std::size_t i = 0; i < 3; ++i) {
      const SnappedCorner& a = corner[i];
      const SnappedCorner& b = corner[(i + 1) % 3];
      // Below 2^50, so exact.
      const Doubles edge = Doubles(b.x - a.x) * to_doubles(y - Ints(a.y)) -
                           Doubles(b.y - a.y) * to_doubles(x - Ints(a.x));
      inside = inside && to_number(edge * Doubles(side)) >= Number(0);
    }
    mask |= BlockMask{bits(inside)} << first;
  }
  return mask;
}

// ---------------------------------------------------------------------------------------------
// For shading

/// A triangle's edge functions, exactly, for a vector of a block's pixels and then for the next.
struct VisibleTriangles::EdgeWalk {
  std::array<Doubles, 3> e;
  std::array<BlockSteps<Doubles>, 3> steps;
  Doubles ratio1, ratio2;

  /// From the vector that begins with pixel `first` to the next.
  void move_on(int first) {
    for (std::size_t i = 0; i < 3; ++i) e[i] = steps[i].after(first / lanes, e[i]);
  }
  PixelWeights weights() const { return Edges{e[0], e[1], e[2]}.weights(ratio1, ratio2); }
  /// Where pixels see another triangle, what that has there.
  PixelWeights weights_beside(Truth is_other, const EdgeWalk& other) const {
    const auto either = [&](Doubles own, Doubles others) { return select(is_other, others, own); };
    const Edges edges = {either(e[0], other.e[0]), either(e[1], other.e[1]),
                         either(e[2], other.e[2])};
    return edges.weights(either(ratio1, other.ratio1), either(ratio2, other.ratio2));
  }
};

HWY_INLINE VisibleTriangles::EdgeWalk VisibleTriangles::walk(std::int32_t slot, int block) const {
  const float* words = record(slot);
  const ShadedTriangle& shaded = triangle(slot);
  const auto word = [&](int i) { return std::bit_cast<std::int32_t>(words[i]); };
  const Doubles column = to_doubles(load(places.x.data()));
  const Doubles row = to_doubles(load(places.y.data()));
  const PixelOffset corner = in_picture(place_of_block(tile_, block));
  EdgeWalk edges;
  const auto set = [&](std::size_t i, double at_corner, double right, double down) {
    edges.steps[i] =
        BlockSteps<Doubles>([&](PixelOffset way) { return Doubles(right * way.x + down * way.y); },
                            column * Doubles(right) + row * Doubles(down));
    edges.e[i] = Doubles(at_corner) + edges.steps[i].first;
  };
  const auto at_corner = [&](std::size_t i, int edge, int step_x, int step_y) -> double {
    if (shaded.is_large) return large_edge(shaded, words, static_cast<int>(i), corner.x, corner.y);
    const auto unsigned_word = [&](int w) { return static_cast<std::uint32_t>(word(w)); };
    return static_cast<std::int32_t>(
        unsigned_word(edge) + 256 * (unsigned_word(step_x) * static_cast<std::uint32_t>(corner.x) +
                                     unsigned_word(step_y) * static_cast<std::uint32_t>(corner.y)));
  };
  const double area = shaded.is_large ? shaded.edges[2] : word(word::area);
  const double e1 = at_corner(1, word::edge1, word::step1_x, word::step1_y);
  const double e2 = at_corner(2, word::edge2, word::step2_x, word::step2_y);
  const double right1 = 256.0 * word(word::step1_x);
  const double down1 = 256.0 * word(word::step1_y);
  const double right2 = 256.0 * word(word::step2_x);
  const double down2 = 256.0 * word(word::step2_y);
  set(0, area - (e1 + e2), -(right1 + right2), -(down1 + down2));
  set(1, e1, right1, down1);
  set(2, e2, right2, down2);
  edges.ratio1 = Doubles(words[word::ratio1]);
  edges.ratio2 = Doubles(words[word::ratio2]);
  return edges;
}

void VisibleTriangles::weigh_few(std::span<const VisiblePart> parts, int block,
                                 WeightsInBlock& weights) const {
  varyings_.derivatives || !job_.skip.unread_attributes ? weigh_few<true>(parts, block, weights)
                                                        : weigh_few<false>(parts, block, weights);
}

template <bool for_derivatives>
void VisibleTriangles::weigh_few(std::span<const VisiblePart> parts, int block,
                                 WeightsInBlock& weights) const {
  if (parts.size() == 1) {
    weigh_one<for_derivatives>(parts.front(), block, weights);
  } else {
    weigh_two<for_derivatives>(parts.front(), parts.back(), block, weights);
  }
}

template <bool for_derivatives>
void VisibleTriangles::weigh_one(const VisiblePart& part, int block,
                                 WeightsInBlock& weights) const {
  EdgeWalk edges = walk(part.slot, block);
  for (int first = 0; first < 64; first += lanes) {
    weights.set<for_derivatives>(first, edges.weights());
    edges.move_on(first);
  }
}

/// Whichever a pixel sees: with one division for both.
template <bool for_derivatives>
void VisibleTriangles::weigh_two(const VisiblePart& part, const VisiblePart& other, int block,
                                 WeightsInBlock& weights) const {
  EdgeWalk edges = walk(part.slot, block);
  EdgeWalk other_edges = walk(other.slot, block);
  for (int first = 0; first < 64; first += lanes) {
    const Truth is_other = truth_of(lanes_at(other.mask, first));
    weights.set<for_derivatives>(first, edges.weights_beside(is_other, other_edges));
    edges.move_on(first);
    other_edges.move_on(first);
  }
}

/// Beside the weights that are there.
void VisibleTriangles::weigh_large(const VisiblePart& part, int block,
                                   WeightsInBlock& weights) const {
  EdgeWalk edges = walk(part.slot, block);
  for (int first = 0; first < 64; first += lanes) {
    const Truth here = truth_of(lanes_at(part.mask, first));
    const PixelWeights own = edges.weights();
    const PixelWeights others = weights.at(first);
    weights.set(first, {select(here, own.b1, others.b1), select(here, own.b2, others.b2),
                        select(here, own.inverse, others.inverse)});
    edges.move_on(first);
  }
}

void VisibleTriangles::number_pixels(std::span<const VisiblePart> parts, int first, int end,
                                     RecordNumbers& numbers) const {
  std::array<Ints, 64 / lanes> number;
  for (Ints& own : number) own = Ints(0);
  numbers.front = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const VisiblePart& part = parts[i];
    const Ints own(static_cast<std::int32_t>(i));
    for (int pixel = first; pixel < end; pixel += lanes) {
      Ints& there = number[static_cast<std::size_t>(pixel / lanes)];
      there = select(truth_of(lanes_at(part.mask, pixel)), own, there);
    }
    numbers.front |= triangle(part.slot).front ? part.mask : 0;
  }
  for (int pixel = first; pixel < end; pixel += lanes) {
    store(number[static_cast<std::size_t>(pixel / lanes)],
          &numbers.number[static_cast<std::size_t>(pixel)]);
  }
}

void VisibleTriangles::weigh_each(std::span<const VisiblePart> parts,
                                  const std::array<float, 16>* words, const RecordNumbers& numbers,
                                  int block, int first, int end, WeightsInBlock& weights) const {
  for (int pixel = first; pixel < end; pixel += lanes) {
    weights.set(pixel, weights_of_each(EachRecord(words, numbers, pixel), block, pixel));
  }
  for (const VisiblePart& part : parts) {
    if (triangle(part.slot).is_large) weigh_large(part, block, weights);
  }
}

PixelWeights VisibleTriangles::weights_of_each(const EachRecord& r, int block, int first) const {
  const PixelOffset place = in_picture(place_of_block(tile_, block));
  const Ints pixel = iota(first);
  const Ints x = (pixel & Ints(7)) + Ints(place.x);
  const Ints y = shift_right<3>(pixel) + Ints(place.y);
  return edges_at(r, x, y).weights(to_doubles(r.number(word::ratio1)),
                                   to_doubles(r.number(word::ratio2)));
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

#if HWY_TARGET == HWY_AVX3
/// Two rows of eight pixels, from one register.
void write_two_rows(const std::uint32_t* packed, Rgb8* row, std::ptrdiff_t stride) {
  alignas(16) static constexpr std::array<std::uint8_t, 16> three_of_four = {
      0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 255, 255, 255, 255};
  alignas(64) static constexpr std::array<std::int32_t, 16> six_of_eight = {
      0, 1, 2, 4, 5, 6, 0, 0, 8, 9, 10, 12, 13, 14, 0, 0};
  const IntTag tag;
  const hn::Repartition<std::uint8_t, IntTag> bytes;
  const HalfIntTag half;
  const auto packed_bytes = hn::BitCast(bytes, hn::LoadU(UintTag(), packed));
  const auto threes =
      hn::TableLookupBytesOr0(packed_bytes, hn::LoadDup128(bytes, three_of_four.data()));
  const auto rows =
      hn::TableLookupLanes(hn::BitCast(tag, threes), hn::SetTableIndices(tag, six_of_eight.data()));
  const auto six = hn::FirstN(half, 6);
  hn::BlendedStore(hn::LowerHalf(half, rows), six, half, reinterpret_cast<std::int32_t*>(row));
  hn::BlendedStore(hn::UpperHalf(half, rows), six, half,
                   reinterpret_cast<std::int32_t*>(row + stride));
}
#endif

}  // namespace

void VisibleTriangles::prefetch_colors(int row) const {
  for (int y = row * 8; y < std::min(row * 8 + 8, tile_.height); ++y) {
    const auto* bytes = reinterpret_cast<const char*>(tile_.color + y * tile_.stride);
    const int last = tile_.width * 3 - 1;
    for (int at = 0; at < last; at += 64) __builtin_prefetch(bytes + at, 1);
    __builtin_prefetch(bytes + last, 1);
  }
}

void VisibleTriangles::write_colors(int block, const std::uint32_t* packed, BlockMask mask) const {
  const PixelOffset place = place_of_block(tile_, block);
  Rgb8* row = tile_.color + place.y * tile_.stride + place.x;
#if HWY_TARGET == HWY_AVX3
  if (mask == all_64) {
    for (int y = 0; y < 8; y += 2) {
      write_two_rows(packed + y * 8, row + y * tile_.stride, tile_.stride);
    }
    return;
  }
#endif
  for (; mask != 0; mask >>= 8U, row += tile_.stride, packed += 8) {
    std::uint32_t here = static_cast<std::uint32_t>(mask) & 0xFFU;
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
