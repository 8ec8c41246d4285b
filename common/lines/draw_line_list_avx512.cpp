// Many segments, by way of marks.
//
// Drawn one by one, a segment of a few hundred pixels touches nearly as many cache lines. Here each
// leaves marks first, one bit a pixel, which is little enough for a near cache; in the end one pass
// over the image paints what is marked. Flat segments mark pixels in rows, steep ones in columns
// (which are rows of other marks), so that both are runs of bits, half as many as pixels.
//
// A tile is eight rows of 64 bits, one vector. A segment walks from tile to tile and marks eight
// runs at once.
#include "common/lines/draw_line_list_avx512.h"

#include "common/lines/avx512.h"

#if defined(__x86_64__)

#include <algorithm>

namespace rasterlab {
// <solution>
namespace {

constexpr std::size_t at_once = 8;
constexpr int tile_rows = 8;
constexpr int tile_bits = 64;

constexpr int longest_segment = 1 << 15;

/// A bit for each pixel, in strips of 64 columns: a word a row, one below the other. Each strip has
/// a multiple of 64 rows. A tile begins in any row, and may end in the next strip or in the rows to
/// spare after the last, where it has no bits.
class Strips {
 public:
  Strips(int columns, int rows)
      : rows_(whole_words(rows) * tile_bits),
        words_(whole_words(columns) * rows_ + std::size_t{tile_rows}) {}

  std::uint64_t* words(int strip, int row) {
    return &words_[static_cast<std::size_t>(strip) * rows_ + static_cast<std::size_t>(row)];
  }

  /// Of the first word.
  std::int64_t address() const { return reinterpret_cast<std::int64_t>(words_.data()); }

  /// From a strip to the next, in bytes.
  std::int64_t pitch() const { return static_cast<std::int64_t>(rows_ * sizeof words_[0]); }

  static std::size_t whole_words(int bits) {
    return static_cast<std::size_t>((bits + tile_bits - 1) / tile_bits);
  }

 private:
  std::size_t rows_;
  std::vector<std::uint64_t> words_;
};

struct Marks {
  explicit Marks(const Image<Rgb8>& image)
      : rows(image.width(), image.height()), columns(image.height(), image.width()) {}

  Strips rows;
  Strips columns;
};

/// Eight segments, each as bits `first` to `last` of its marks and as rows `top` to top + minor.
struct EightSegments {
  __mmask8 right;   ///< those with both ends in the image that are not too long
  __mmask8 steep;   ///< those that mark columns
  __mmask8 rising;  ///< those whose first bit is in the lowest row
  __m256i major;
  __m256i minor;
  __m512i first;
  __m512i last;
  __m512i top;
};

/// One of the four coordinates of eight segments.
RASTERLAB_AVX512 inline __m256i coordinates(const Segment* segments, int which) {
  static_assert(sizeof(Segment) == 4 * sizeof(int));
  const __m512i places =
      _mm512_add_epi32(_mm512_set1_epi32(which),
                       _mm512_setr_epi32(0, 4, 8, 12, 16, 20, 24, 28, 0, 0, 0, 0, 0, 0, 0, 0));
  return _mm512_castsi512_si256(_mm512_permutex2var_epi32(
      _mm512_loadu_si512(segments), places, _mm512_loadu_si512(segments + at_once / 2)));
}

RASTERLAB_AVX512 inline EightSegments eight_segments(const Image<Rgb8>& image,
                                                     const Segment* segments) {
  const __m256i x0 = coordinates(segments, 0);
  const __m256i y0 = coordinates(segments, 1);
  const __m256i x1 = coordinates(segments, 2);
  const __m256i y1 = coordinates(segments, 3);
  const __m256i image_width = _mm256_set1_epi32(image.width());
  const __m256i image_height = _mm256_set1_epi32(image.height());
  const __m256i dx = _mm256_sub_epi32(x1, x0);
  const __m256i dy = _mm256_sub_epi32(y1, y0);
  const __m256i width = _mm256_abs_epi32(dx);
  const __m256i height = _mm256_abs_epi32(dy);
  EightSegments eight;
  eight.major = _mm256_max_epi32(width, height);
  eight.minor = _mm256_min_epi32(width, height);
  eight.right = _mm256_cmplt_epu32_mask(x0, image_width);  // negative ones are large
  eight.right = _mm256_mask_cmplt_epu32_mask(eight.right, x1, image_width);
  eight.right = _mm256_mask_cmplt_epu32_mask(eight.right, y0, image_height);
  eight.right = _mm256_mask_cmplt_epu32_mask(eight.right, y1, image_height);
  eight.right =
      _mm256_mask_cmplt_epi32_mask(eight.right, eight.major, _mm256_set1_epi32(longest_segment));
  eight.steep = _mm256_cmpgt_epi32_mask(height, width);
  eight.rising = static_cast<__mmask8>(_mm256_movepi32_mask(dx) ^ _mm256_movepi32_mask(dy));
  const __m256i left = _mm256_min_epi32(x0, x1);
  const __m256i upper = _mm256_min_epi32(y0, y1);
  eight.first = _mm512_cvtepi32_epi64(_mm256_mask_blend_epi32(eight.steep, left, upper));
  eight.last = _mm512_add_epi64(eight.first, _mm512_cvtepi32_epi64(eight.major));
  eight.top = _mm512_cvtepi32_epi64(_mm256_mask_blend_epi32(eight.steep, upper, left));
  return eight;
}

using EightNumbers = std::array<std::int64_t, at_once>;

/// Eight segments' ways from tile to tile, from the top row on; places of bits are counted from the
/// first of a tile.
struct Walks {
  alignas(64) EightNumbers tile;     ///< the address of the first one
  alignas(64) EightNumbers tiles;    ///< how many there are
  alignas(64) EightNumbers beside;   ///< from strip to strip, in bytes
  alignas(64) EightNumbers first;    ///< bit of the segment
  alignas(64) EightNumbers major;    ///< from there to its last bit
  alignas(64) EightNumbers run;      ///< the length of one, in 2^-32 as all that follow
  alignas(64) EightNumbers begin;    ///< of the run in the first row
  alignas(64) EightNumbers per_row;  ///< run or, where it rises, −run
  alignas(64) EightNumbers beyond;   ///< how far the eight runs go beyond their strip
};

RASTERLAB_AVX512 inline void store(EightNumbers& to, __m512i values) {
  _mm512_store_si512(to.data(), values);
}

/// The length of a run in 2^-32, rounded down; of a single one, more than twice the segment's.
/// Exact: a quotient by less than 2^15 that is not whole is more than a double's error from it.
RASTERLAB_AVX512 inline __m512i run_lengths(const EightSegments& eight) {
  const __m512d major = _mm512_max_pd(_mm512_cvtepi32_pd(eight.major), _mm512_set1_pd(1));
  const __m512d minor = _mm512_max_pd(_mm512_cvtepi32_pd(eight.minor), _mm512_set1_pd(0.25));
  return _mm512_cvttpd_epi64(_mm512_div_pd(_mm512_mul_pd(major, _mm512_set1_pd(0x1p32)), minor));
}

/// Counted from the left or upper end, run r = 0 … minor begins in step ⌈(r − ½) · major / minor⌉
/// and ends where the next one begins, but for the segment's ends. What is rounded up there is
/// either whole or 2^-16 at least from being so, and `run` is rounded down: up to 2^15 of them are
/// less than 2^-17 too small, which rounding up makes good. In rows without pixels runs, counted
/// on, are outside the segment's ends.
RASTERLAB_AVX512 inline void make_walks(const EightSegments& eight, const Marks& marks,
                                        Walks& walks) {
  const auto of_rows_or_columns = [&](std::int64_t rows, std::int64_t columns) RASTERLAB_AVX512 {
    return _mm512_mask_blend_epi64(eight.steep, _mm512_set1_epi64(rows),
                                   _mm512_set1_epi64(columns));
  };
  const auto negated_if_rising = [&](__m512i values) RASTERLAB_AVX512 {
    return _mm512_mask_sub_epi64(values, eight.rising, _mm512_setzero_si512(), values);
  };
  const __m512i address = of_rows_or_columns(marks.rows.address(), marks.columns.address());
  const __m512i pitch = of_rows_or_columns(marks.rows.pitch(), marks.columns.pitch());
  const __m512i minor = _mm512_cvtepi32_epi64(eight.minor);
  const __m512i first_strip = _mm512_srli_epi64(eight.first, 6);
  const __m512i last_strip = _mm512_srli_epi64(eight.last, 6);
  const __m512i strip = _mm512_mask_blend_epi64(eight.rising, first_strip, last_strip);
  const __m512i in_strip =
      _mm512_add_epi64(_mm512_mullo_epi64(strip, pitch), _mm512_slli_epi64(eight.top, 3));
  const __m512i turns = _mm512_sub_epi64(last_strip, first_strip);
  const __m512i tiles_down = _mm512_add_epi64(_mm512_srli_epi64(minor, 3), _mm512_set1_epi64(1));
  store(walks.tile, _mm512_add_epi64(address, in_strip));
  store(walks.tiles, _mm512_add_epi64(tiles_down, turns));
  store(walks.beside, negated_if_rising(pitch));

  const __m512i first = _mm512_sub_epi64(eight.first, _mm512_slli_epi64(strip, 6));
  const __m512i run = run_lengths(eight);
  const __m512i half_run_back = _mm512_sub_epi64(_mm512_srli_epi64(run, 1), run);
  __m512i begin = _mm512_add_epi64(_mm512_slli_epi64(first, 32), half_run_back);
  begin = _mm512_add_epi64(begin, _mm512_set1_epi64((std::int64_t{1} << 32) - 1));
  begin = _mm512_mask_add_epi64(begin, eight.rising, begin, _mm512_mullo_epi64(minor, run));
  store(walks.first, first);
  store(walks.major, _mm512_cvtepi32_epi64(eight.major));
  store(walks.run, run);
  store(walks.begin, begin);
  store(walks.per_row, negated_if_rising(run));

  const __m512i eight_runs = _mm512_slli_epi64(run, 3);
  const __m512i right_end = _mm512_add_epi64(begin, eight_runs);
  const __m512i left_end = _mm512_sub_epi64(begin, _mm512_sub_epi64(eight_runs, run));
  const __m512i beyond =
      _mm512_sub_epi64(right_end, _mm512_set1_epi64(std::int64_t{tile_bits} << 32));
  store(walks.beyond,
        _mm512_mask_sub_epi64(beyond, eight.rising, _mm512_setzero_si512(), left_end));
}

/// Marks a segment: where the eight runs of a tile go beyond its strip, the next tile is the one
/// beside, else the one below. That ends in the last tile: as each run has a bit, none above the
/// last eight goes beyond the last strip, and those go beyond all others. No branch but the loop's
/// depends on the segment.
RASTERLAB_AVX512 inline void mark_segment(const Walks& walks, std::size_t which) {
  constexpr std::int64_t strip = std::int64_t{tile_bits} << 32;
  constexpr std::int64_t below = tile_rows * sizeof(std::uint64_t);
  constexpr std::uint64_t all = ~std::uint64_t{0};
  const __m512i every_bit = _mm512_set1_epi64(-1);
  const __m512i zero = _mm512_setzero_si512();
  const __m512i rows = _mm512_setr_epi64(0, 1, 2, 3, 4, 5, 6, 7);
  const std::int64_t run = walks.run[which];
  const std::int64_t per_row = walks.per_row[which];
  const std::int64_t beside = walks.beside[which];
  const std::int64_t major = walks.major[which];
  const std::int64_t per_strip = beside < 0 ? strip : -strip;
  std::int64_t tile = walks.tile[which];
  std::int64_t first = walks.first[which];
  std::int64_t beyond = walks.beyond[which];
  // Where runs begin, and how many bits before the tile's end they end, rounded up below.
  __m512i begins = _mm512_add_epi64(_mm512_set1_epi64(walks.begin[which]),
                                    _mm512_mullo_epi64(rows, _mm512_set1_epi64(per_row)));
  __m512i ends =
      _mm512_sub_epi64(_mm512_set1_epi64(strip + (std::int64_t{1} << 32) - 1 - run), begins);
  for (std::int64_t left = walks.tiles[which]; left > 0; --left) {
    const std::uint64_t segment = (all << std::max<std::int64_t>(first, 0)) &
                                  (all >> std::max<std::int64_t>(63 - first - major, 0));
    // Shifting by more than there are bits leaves none.
    const __m512i after_begin =
        _mm512_sllv_epi64(every_bit, _mm512_max_epi64(_mm512_srai_epi64(begins, 32), zero));
    const __m512i before_end =
        _mm512_srlv_epi64(every_bit, _mm512_max_epi64(_mm512_srai_epi64(ends, 32), zero));
    const __m512i bits = _mm512_and_si512(_mm512_and_si512(after_begin, before_end),
                                          _mm512_set1_epi64(static_cast<std::int64_t>(segment)));
    auto* words = reinterpret_cast<std::uint64_t*>(tile);
    _mm512_storeu_si512(words, _mm512_or_si512(bits, _mm512_loadu_si512(words)));

    const std::int64_t turn = -beyond >> 63;  // all bits or none
    tile += below + (turn & (beside - below));
    first += turn & (per_strip >> 32);
    beyond += tile_rows * run - (turn & (tile_rows * run + strip));
    const __m512i moved =
        _mm512_set1_epi64(tile_rows * per_row + (turn & (per_strip - tile_rows * per_row)));
    begins = _mm512_add_epi64(begins, moved);
    ends = _mm512_sub_epi64(ends, moved);
  }
}

/// Marks what can be marked, and draws the rest.
RASTERLAB_AVX512 DrawnLines mark(Image<Rgb8>& image, std::span<const Segment> segments,
                                 const Rgb8& color, Marks& marks) {
  DrawnLines drawn;
  Walks walks;
  std::array<Segment, at_once> last_ones;
  last_ones.fill({Point(-1, -1), Point(-1, -1)});
  for (; !segments.empty(); segments = segments.subspan(std::min(segments.size(), at_once))) {
    const std::size_t count = std::min(segments.size(), at_once);
    const Segment* from = segments.data();
    if (count < at_once) {
      std::copy_n(from, count, last_ones.begin());
      from = last_ones.data();
    }
    const EightSegments eight = eight_segments(image, from);
    make_walks(eight, marks, walks);
    for (std::size_t i = 0; i < count; ++i) {
      std::int64_t pixels = walks.major[i] + 1;
      if ((unsigned{eight.right} >> i & 1U) != 0) {
        mark_segment(walks, i);
      } else {
        pixels = draw_line_runs(image, from[i].p0, from[i].p1, color);
      }
      drawn.add(pixels);
    }
  }
  return drawn;
}

/// Eight words of marks.
struct Words {
  __m512i of;
};

/// 64 × 64 bits.
using Square = std::array<Words, at_once>;

/// The bits of which bit `power` of their place is 0.
RASTERLAB_AVX512 inline __m512i lower_bits(unsigned power) {
  const std::uint64_t bits = ~std::uint64_t{0} / ((std::uint64_t{1} << (1U << power)) + 1);
  return _mm512_set1_epi64(static_cast<std::int64_t>(bits));
}

/// `yes` where `which` has a bit, else `no`.
RASTERLAB_AVX512 inline __m512i chosen(__m512i which, __m512i yes, __m512i no) {
  return _mm512_ternarylogic_epi64(which, yes, no, 0xca);
}

/// Exchanges bit `power` of the row with that of the column, where rows are in different vectors.
RASTERLAB_AVX512 inline void exchange_in_two(Square& square, unsigned power) {
  const std::size_t apart = (std::size_t{1} << power) / at_once;
  const __m512i lower = lower_bits(power);
  for (std::size_t i = 0; i < at_once; ++i) {
    if ((i & apart) != 0) continue;
    const __m512i above = square[i].of;
    const __m512i below = square[i + apart].of;
    square[i].of = chosen(lower, above, _mm512_slli_epi64(below, 1U << power));
    square[i + apart].of = chosen(lower, _mm512_srli_epi64(above, 1U << power), below);
  }
}

/// The same where they are in one: rotated to the left in the upper row, to the right in the lower.
RASTERLAB_AVX512 inline void exchange_in_one(Square& square, unsigned power) {
  const __m512i lanes = _mm512_setr_epi64(0, 1, 2, 3, 4, 5, 6, 7);
  const __m512i bit = _mm512_set1_epi64(1 << power);
  const __m512i other = _mm512_xor_si512(lanes, bit);
  const __mmask8 lower_row = _mm512_test_epi64_mask(lanes, bit);
  const __m512i turn = _mm512_mask_sub_epi64(bit, lower_row, _mm512_set1_epi64(tile_bits), bit);
  const __m512i lower = lower_bits(power);
  const __m512i kept = _mm512_mask_xor_epi64(lower, lower_row, lower, _mm512_set1_epi64(-1));
  for (Words& words : square) {
    const __m512i turned = _mm512_rolv_epi64(_mm512_permutexvar_epi64(other, words.of), turn);
    words.of = chosen(kept, words.of, turned);
  }
}

/// Exchanges rows and columns, one bit of their numbers after the other.
RASTERLAB_AVX512 inline void transpose(Square& square) {
  for (unsigned power = 0; power < 3; ++power) exchange_in_one(square, power);
  for (unsigned power = 3; power < 6; ++power) exchange_in_two(square, power);
}

/// What is marked of 64 × 64 pixels, row by row.
RASTERLAB_AVX512 inline void collect(Marks& marks, int left, int top, std::uint64_t* words) {
  const std::uint64_t* const columns = marks.columns.words(top / tile_bits, left);
  const std::uint64_t* const rows = marks.rows.words(left / tile_bits, top);
  Square square;
  for (std::size_t i = 0; i < square.size(); ++i)
    square[i].of = _mm512_loadu_si512(columns + at_once * i);
  transpose(square);
  for (std::size_t i = 0; i < square.size(); ++i) {
    const __m512i both = _mm512_or_si512(square[i].of, _mm512_loadu_si512(rows + at_once * i));
    _mm512_storeu_si512(words + at_once * i, both);
  }
}

/// Paints 64 pixels, which are three vectors of bytes.
class Brush {
 public:
  RASTERLAB_AVX512 explicit Brush(const Rgb8& color) {
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      alignas(64) std::array<std::uint8_t, part_size> bytes{};
      alignas(64) std::array<std::uint8_t, part_size> bits{};
      alignas(64) std::array<std::uint8_t, part_size> colors{};
      for (std::size_t i = 0; i < part_size; ++i) {
        const std::size_t byte = part_size * part + i;
        colors[i] = byte % 3 == 0 ? color.r : byte % 3 == 1 ? color.g : color.b;
        bytes[i] = static_cast<std::uint8_t>(byte / 3 / 8);
        bits[i] = static_cast<std::uint8_t>(1U << byte / 3 % 8);
      }
      parts_[part] = {_mm512_load_si512(bytes.data()), _mm512_load_si512(bits.data()),
                      _mm512_load_si512(colors.data())};
    }
  }

  RASTERLAB_AVX512 void paint(Rgb8* first, std::uint64_t marked) const {
    auto* bytes = reinterpret_cast<std::uint8_t*>(first);
    const __m512i word = _mm512_set1_epi64(static_cast<std::int64_t>(marked));
    for (const Part& part : parts_) {
      const __mmask64 painted =
          _mm512_test_epi8_mask(_mm512_shuffle_epi8(word, part.byte_of_word), part.bit_of_byte);
      _mm512_mask_storeu_epi8(bytes, painted, part.color);
      bytes += part_size;
    }
  }

 private:
  static constexpr std::size_t part_size = 64;

  struct Part {
    __m512i byte_of_word;  ///< where each byte's pixel is marked
    __m512i bit_of_byte;
    __m512i color;
  };

  std::array<Part, 3> parts_;
};

RASTERLAB_AVX512 void paint(Image<Rgb8>& image, Marks& marks, const Rgb8& color) {
  const Brush brush(color);
  const std::size_t strips = Strips::whole_words(image.width());
  std::vector<std::uint64_t> band(strips * tile_bits);
  for (int top = 0; top < image.height(); top += tile_bits) {
    for (std::size_t strip = 0; strip < strips; ++strip)
      collect(marks, static_cast<int>(strip) * tile_bits, top, &band[strip * tile_bits]);
    for (int y = top; y < std::min(top + tile_bits, image.height()); ++y) {
      const std::uint64_t* marked = &band[static_cast<std::size_t>(y - top)];
      for (int left = 0; left < image.width(); left += tile_bits, marked += tile_bits)
        if (*marked != 0) brush.paint(image.row(y) + left, *marked);
    }
  }
}

}  // namespace
// </solution>

DrawnLines draw_line_list_avx512(Image<Rgb8>& image, std::span<const Segment> segments,
                                 const Rgb8& color) {
  // <solution>
  Marks marks(image);
  const DrawnLines drawn = mark(image, segments, color, marks);
  paint(image, marks, color);
  return drawn;
  // <starter> return draw_line_runs(image, segments, color);
  // </solution>
}

}  // namespace rasterlab

#else

namespace rasterlab {

DrawnLines draw_line_list_avx512(Image<Rgb8>&, std::span<const Segment>, const Rgb8&) {
  return {};
}

}  // namespace rasterlab

#endif
