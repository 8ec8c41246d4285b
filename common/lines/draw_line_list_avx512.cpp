// Many segments, eight at a time, by way of marks.
//
// Drawn one by one, a segment of a few hundred pixels touches nearly as many cache lines. Here each
// leaves marks first, one bit a pixel, which is little enough for a near cache. Flat segments mark
// rows, steep ones columns, so that both are runs of bits, and half as many as pixels. In the end
// one pass over the image paints what is marked.
#include "common/lines/draw_line_list_avx512.h"

#include "common/lines/avx512.h"

#if defined(__x86_64__)

#include <algorithm>
#include <cstring>

namespace rasterlab {
// <solution>
namespace {

constexpr std::size_t at_once = 8;
constexpr int word_bits = 64;

/// The most bits that can be set at once, wherever in a byte they begin.
constexpr int longest_run = word_bits - 7;

constexpr int longest_segment = 1 << 15;

/// A bit for each pixel, in rows or in columns; to spare are a word at the end of each, and seven
/// rows before and after all.
class Bits {
 public:
  Bits(int rows, int bits)
      : words_(static_cast<std::size_t>((bits + word_bits - 1) / word_bits) + 1),
        bits_((static_cast<std::size_t>(rows) + 2 * spare_rows) * words_) {}

  std::uint64_t& word(int row, int index) {
    return bits_[(static_cast<std::size_t>(row) + spare_rows) * words_ +
                 static_cast<std::size_t>(index)];
  }

  /// Of row 0.
  std::int64_t address() const {
    return reinterpret_cast<std::int64_t>(&bits_[spare_rows * words_]);
  }

  /// From row to row, in bytes.
  std::int64_t step() const { return static_cast<std::int64_t>(words_ * sizeof bits_[0]); }

 private:
  static constexpr std::size_t spare_rows = at_once - 1;

  std::size_t words_;
  std::vector<std::uint64_t> bits_;
};

struct Marks {
  explicit Marks(const Image<Rgb8>& image)
      : rows(image.height(), image.width()), columns(image.width(), image.height()) {}

  Bits rows;
  Bits columns;
};

/// Eight segments as runs: run r = 0 … minor begins where the one before it ends, and ends before
/// bit ⌊end + r · run⌋, both in 2^-32, but the last before `past`.
///
/// Counted from the left or upper end a run ends before step ⌈(r + ½) · major / minor⌉. What is
/// rounded up there is either whole or 2^-16 at least from being so, and `run` is rounded down: up
/// to 2^15 of them are less than 2^-17 too small, which rounding up makes good.
struct Runs {
  alignas(64) std::array<std::int64_t, at_once> row;   ///< the address of its bits
  alignas(64) std::array<std::int64_t, at_once> step;  ///< from row to row, in bytes
  alignas(64) std::array<std::int64_t, at_once> minor;
  alignas(64) std::array<std::int64_t, at_once> first;
  alignas(64) std::array<std::int64_t, at_once> past;
  alignas(64) std::array<std::int64_t, at_once> end;
  alignas(64) std::array<std::int64_t, at_once> run;
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

RASTERLAB_AVX512 inline void store(std::array<std::int64_t, at_once>& to, __m512i values) {
  _mm512_store_si512(to.data(), values);
}

/// The runs of eight segments; returns for which of them this is right: those with both ends in the
/// image that are not too long and have no too long runs.
RASTERLAB_AVX512 inline __mmask8 make_runs(const Segment* segments, const Image<Rgb8>& image,
                                           const Marks& marks, Runs& runs) {
  const __m256i x0 = coordinates(segments, 0);
  const __m256i y0 = coordinates(segments, 1);
  const __m256i x1 = coordinates(segments, 2);
  const __m256i y1 = coordinates(segments, 3);
  const __m256i image_width = _mm256_set1_epi32(image.width());
  const __m256i image_height = _mm256_set1_epi32(image.height());
  __mmask8 right = _mm256_cmplt_epu32_mask(x0, image_width);  // negative ones are large
  right = _mm256_mask_cmplt_epu32_mask(right, x1, image_width);
  right = _mm256_mask_cmplt_epu32_mask(right, y0, image_height);
  right = _mm256_mask_cmplt_epu32_mask(right, y1, image_height);
  const __m256i dx = _mm256_sub_epi32(x1, x0);
  const __m256i dy = _mm256_sub_epi32(y1, y0);
  const __m256i width = _mm256_abs_epi32(dx);
  const __m256i height = _mm256_abs_epi32(dy);
  const __m256i longest = _mm256_set1_epi32(longest_segment);
  const __m256i major = _mm256_max_epi32(width, height);
  const __m256i minor = _mm256_min_epi32(width, height);
  const __m256i minor_runs =
      _mm256_mullo_epi32(_mm256_min_epi32(minor, longest), _mm256_set1_epi32(longest_run));
  right = _mm256_mask_cmplt_epi32_mask(right, major, longest);
  right = _mm256_mask_cmplt_epi32_mask(right, major, minor_runs);

  const __mmask8 steep = _mm256_cmpgt_epi32_mask(height, width);
  const __mmask8 leftward = _mm256_movepi32_mask(dx);
  const __mmask8 upward = _mm256_movepi32_mask(dy);
  const auto backward = static_cast<__mmask8>((upward & steep) | (leftward & ~steep));
  const __m256i start_x = _mm256_mask_blend_epi32(backward, x0, x1);
  const __m256i start_y = _mm256_mask_blend_epi32(backward, y0, y1);
  const __m512i first = _mm512_cvtepi32_epi64(_mm256_mask_blend_epi32(steep, start_x, start_y));
  const __m512i across = _mm512_cvtepi32_epi64(_mm256_mask_blend_epi32(steep, start_y, start_x));
  const auto of_rows_or_columns = [steep](std::int64_t rows,
                                          std::int64_t columns) RASTERLAB_AVX512 {
    return _mm512_mask_blend_epi64(steep, _mm512_set1_epi64(rows), _mm512_set1_epi64(columns));
  };
  const __m512i step = of_rows_or_columns(marks.rows.step(), marks.columns.step());
  const __m512i address = of_rows_or_columns(marks.rows.address(), marks.columns.address());
  // Exact: a quotient by less than 2^15 that is not whole is more than a double's error from it.
  const __m512i run = _mm512_cvttpd_epi64(_mm512_div_pd(
      _mm512_mul_pd(_mm512_cvtepi32_pd(major), _mm512_set1_pd(0x1p32)), _mm512_cvtepi32_pd(minor)));
  store(runs.row, _mm512_add_epi64(address, _mm512_mullo_epi64(across, step)));
  store(runs.step, _mm512_mask_sub_epi64(step, leftward ^ upward, _mm512_setzero_si512(), step));
  store(runs.minor, _mm512_cvtepi32_epi64(minor));
  store(runs.first, first);
  store(runs.past, _mm512_add_epi64(_mm512_add_epi64(first, _mm512_cvtepi32_epi64(major)),
                                    _mm512_set1_epi64(1)));
  store(runs.end,
        _mm512_add_epi64(_mm512_add_epi64(_mm512_slli_epi64(first, 32), _mm512_srli_epi64(run, 1)),
                         _mm512_set1_epi64((std::int64_t{1} << 32) - 1)));
  store(runs.run, run);
  return right;
}

void set_bits(std::uint8_t* bytes, std::uint64_t bits) {
  std::uint64_t word = 0;
  std::memcpy(&word, bytes, sizeof word);
  word |= bits;
  std::memcpy(bytes, &word, sizeof word);
}

/// Marks the runs of a segment, eight at a time. Those after the last one have no bits, but each
/// its own row: setting the same bits again and again would have to wait each time.
RASTERLAB_AVX512 inline void mark_segment(const Runs& runs, std::size_t which) {
  const __m512i one = _mm512_set1_epi64(1);
  const __m512i seven = _mm512_set1_epi64(7);
  const __m512i lanes = _mm512_setr_epi64(0, 1, 2, 3, 4, 5, 6, 7);
  const __m512i first = _mm512_set1_epi64(runs.first[which]);
  const __m512i past = _mm512_set1_epi64(runs.past[which]);
  const __m512i run = _mm512_set1_epi64(runs.run[which]);
  const __m512i step = _mm512_set1_epi64(runs.step[which]);
  __m512i rows =
      _mm512_add_epi64(_mm512_set1_epi64(runs.row[which]), _mm512_mullo_epi64(lanes, step));
  __m512i ends =
      _mm512_add_epi64(_mm512_set1_epi64(runs.end[which]), _mm512_mullo_epi64(lanes, run));
  alignas(64) std::array<std::uint8_t*, at_once> places;
  alignas(64) std::array<std::uint64_t, at_once> bits;
  for (std::int64_t left = runs.minor[which]; left >= 0; left -= at_once) {
    const __m512i begin = _mm512_min_epi64(
        _mm512_max_epi64(_mm512_srai_epi64(_mm512_sub_epi64(ends, run), 32), first), past);
    const __m512i end = _mm512_min_epi64(_mm512_srai_epi64(ends, 32), past);
    const __m512i low = _mm512_sub_epi64(_mm512_sllv_epi64(one, _mm512_sub_epi64(end, begin)), one);
    _mm512_store_si512(places.data(), _mm512_add_epi64(rows, _mm512_srli_epi64(begin, 3)));
    _mm512_store_si512(bits.data(), _mm512_sllv_epi64(low, _mm512_and_si512(begin, seven)));
    for (std::size_t i = 0; i < at_once; ++i) set_bits(places[i], bits[i]);
    ends = _mm512_add_epi64(ends, _mm512_slli_epi64(run, 3));
    rows = _mm512_add_epi64(rows, _mm512_slli_epi64(step, 3));
  }
}

/// Marks what can be marked, and draws the rest.
RASTERLAB_AVX512 DrawnLines mark(Image<Rgb8>& image, std::span<const Segment> segments,
                                 const Rgb8& color, Marks& marks) {
  DrawnLines drawn;
  Runs runs;
  std::array<Segment, at_once> eight;
  eight.fill({Point(-1, -1), Point(-1, -1)});
  for (; !segments.empty(); segments = segments.subspan(std::min(segments.size(), at_once))) {
    const std::size_t count = std::min(segments.size(), at_once);
    const Segment* from = segments.data();
    if (count < at_once) {
      std::copy_n(from, count, eight.begin());
      from = eight.data();
    }
    const unsigned right = make_runs(from, image, marks, runs);
    for (std::size_t i = 0; i < count; ++i) {
      std::int64_t pixels = runs.past[i] - runs.first[i];
      if ((right >> i & 1U) != 0) {
        mark_segment(runs, i);
      } else {
        pixels = draw_line_runs(image, from[i].p0, from[i].p1, color);
      }
      drawn.add(pixels);
    }
  }
  return drawn;
}

/// Exchanges rows and columns.
void transpose(std::array<std::uint64_t, word_bits>& square) {
  std::uint64_t kept = ~std::uint64_t{0} >> word_bits / 2;
  for (std::size_t half = word_bits / 2; half > 0; half /= 2, kept ^= kept << half) {
    for (std::size_t i = 0; i < word_bits; ++i) {
      if ((i & half) != 0) continue;
      const std::uint64_t exchanged = (square[i] >> half ^ square[i + half]) & kept;
      square[i] ^= exchanged << half;
      square[i + half] ^= exchanged;
    }
  }
}

/// Marks in rows what is marked in columns, in 64 × 64 pixels from (left, top) on.
void turn_columns(Marks& marks, const Image<Rgb8>& image, int left, int top) {
  std::array<std::uint64_t, word_bits> square{};
  for (int i = 0; i < std::min(word_bits, image.width() - left); ++i)
    square[static_cast<std::size_t>(i)] = marks.columns.word(left + i, top / word_bits);
  transpose(square);
  for (int i = 0; i < std::min(word_bits, image.height() - top); ++i)
    marks.rows.word(top + i, left / word_bits) |= square[static_cast<std::size_t>(i)];
}

/// Paints up to 64 pixels of a row, 16 at a time: three bytes for each bit.
RASTERLAB_AVX512 inline void paint_word(Rgb8* pixel, std::uint64_t bits, __m512i pattern) {
  for (; bits != 0; bits >>= 16, pixel += 16)
    _mm512_mask_storeu_epi8(pixel, 7 * _pdep_u64(bits, 0x249249249249), pattern);
}

RASTERLAB_AVX512 void paint(Image<Rgb8>& image, Marks& marks, const Rgb8& color) {
  const __m512i pattern = color_pattern(color);
  for (int top = 0; top < image.height(); top += word_bits) {
    for (int left = 0; left < image.width(); left += word_bits)
      turn_columns(marks, image, left, top);
    for (int y = top; y < std::min(top + word_bits, image.height()); ++y) {
      for (int left = 0; left < image.width(); left += word_bits)
        paint_word(image.row(y) + left, marks.rows.word(y, left / word_bits), pattern);
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
