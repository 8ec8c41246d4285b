// A triangle, eight rows at a time.
//
// A small triangle has few pixels, and what takes time is what a processor cannot foresee. So there
// are few branches: corners are sorted without, and a row is written by one store that leaves out
// the bytes that are not the triangle's, however many they are. And numbers stay in registers: to
// load one again from an address whose last twelve bits a store before it has too, to whatever
// pixel, may take until that pixel has come from a farther cache.
#include "common/triangles/fill_spans_avx512.h"

#include "common/lines/avx512.h"
#include "common/triangles/fill_spans.h"

#if defined(__x86_64__)

#include <algorithm>
#include <array>

namespace rasterlab {
namespace {

constexpr int rows_at_once = 8;
constexpr int widest_store = 21;   // pixels
constexpr int widest_narrow = 10;  // pixels, in half such a store

/// The corners from the top down: x + ½ − 2^-33 and y − ½, on the grid of 1/256 pixel otherwise.
struct SortedCorners {
  __m128d top;
  __m128d middle;
  __m128d bottom;
};

RASTERLAB_AVX512 inline void sort_two(__m128d& above, __m128d& below) {
  const __m128d swapped = _mm_permute_pd(_mm_cmpgt_pd(above, below), 0b11);
  const __m128d higher = _mm_blendv_pd(above, below, swapped);
  below = _mm_blendv_pd(below, above, swapped);
  above = higher;
}

RASTERLAB_AVX512 inline SortedCorners sort_corners(__m512d pixels) {
  constexpr int to_256ths = 8 << 4 | _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC;
  static_assert(subpixels == 1 << 8);
  const __m512d snapped = _mm512_roundscale_pd(pixels, to_256ths);
  const __m512d moved =
      _mm512_add_pd(snapped, _mm512_broadcast_f64x2(_mm_setr_pd(0.5 - 0x1p-33, -0.5)));
  SortedCorners corners = {_mm512_castpd512_pd128(moved), _mm512_extractf64x2_pd(moved, 1),
                           _mm512_extractf64x2_pd(moved, 2)};
  sort_two(corners.top, corners.middle);
  sort_two(corners.middle, corners.bottom);
  sort_two(corners.top, corners.middle);
  return corners;
}

/// The rows first ≤ y < last of the image whose centres are at or below the top corner and above
/// the bottom one; of four lanes the first two.
RASTERLAB_AVX512 inline __m128i rows_of(const SortedCorners& corners, int height) {
  const __m128d ends = _mm_round_pd(_mm_unpackhi_pd(corners.top, corners.bottom),
                                    _MM_FROUND_TO_POS_INF | _MM_FROUND_NO_EXC);
  const __m128i above_last = _mm_min_epi32(_mm_cvtpd_epi32(ends), _mm_set1_epi32(height));
  return _mm_max_epi32(above_last, _mm_setzero_si128());
}

/// Two lines bound the triangle in every row: one from the top corner to the bottom one, and one by
/// way of the middle corner. What is right of a line begins with pixel ⌊x + (row − y) · slope⌋ of a
/// row. Each number is in all lanes.
///
/// Exact by the reasoning of TriangleSide (spans.h): x and row − y are exact, and where the line is
/// a side, (row − y) · slope is at most the side's width, below 2^16. So the roundings of the
/// slope and of the sum come to less than 2^-35, and 2^-33 less than ½ was added to x.
struct Lines {
  __m512d top_x;
  __m512d top_y;
  __m512d slope;
  __m512d middle_x;
  __m512d middle_y;
  __m512d upper_slope;  ///< above the middle corner
  __m512d lower_slope;
};

RASTERLAB_AVX512 inline __m512d first_in_all(__m128d pair) {
  return _mm512_broadcastsd_pd(pair);
}
RASTERLAB_AVX512 inline __m512d second_in_all(__m128d pair) {
  return _mm512_broadcastsd_pd(_mm_permute_pd(pair, 0b11));
}

RASTERLAB_AVX512 inline Lines lines_of(const SortedCorners& corners) {
  const __m128d upper = _mm_sub_pd(corners.middle, corners.top);
  const __m128d lower = _mm_sub_pd(corners.bottom, corners.middle);
  const __m128d whole = _mm_sub_pd(corners.bottom, corners.top);
  const __m128d slopes = _mm_div_pd(_mm_unpacklo_pd(upper, lower), _mm_unpackhi_pd(upper, lower));
  return {.top_x = first_in_all(corners.top),
          .top_y = second_in_all(corners.top),
          .slope = first_in_all(_mm_div_sd(whole, _mm_permute_pd(whole, 0b01))),
          .middle_x = first_in_all(corners.middle),
          .middle_y = second_in_all(corners.middle),
          .upper_slope = first_in_all(slopes),
          .lower_slope = second_in_all(slopes)};
}

/// The pixels of some rows, begin ≤ x < begin + pixels.
struct Spans {
  __m256i begin;
  __m256i pixels;
};

RASTERLAB_AVX512 inline __m256i clamp(__m256i columns, int width) {
  return _mm256_min_epi32(_mm256_max_epi32(columns, _mm256_setzero_si256()),
                          _mm256_set1_epi32(width));
}

/// For rows of the triangle; of others `pixels` means nothing.
RASTERLAB_AVX512 inline Spans spans_of(const Lines& lines, __m256i rows, int width) {
  const __m512d row = _mm512_cvtepi32_pd(rows);
  const __m512d below_middle = _mm512_sub_pd(row, lines.middle_y);
  const __mmask8 is_above = _mm512_movepi64_mask(_mm512_castpd_si512(below_middle));
  const __m512d slope = _mm512_mask_mov_pd(lines.lower_slope, is_above, lines.upper_slope);
  const __m512d x = _mm512_fmadd_pd(below_middle, slope, lines.middle_x);
  const __m512d other_x =
      _mm512_fmadd_pd(_mm512_sub_pd(row, lines.top_y), lines.slope, lines.top_x);
  const __m256i begin = clamp(_mm512_cvttpd_epi32(_mm512_min_pd(x, other_x)), width);
  const __m256i end = clamp(_mm512_cvttpd_epi32(_mm512_max_pd(x, other_x)), width);
  return {begin, _mm256_sub_epi32(end, begin)};
}

/// In which lane which of eight rows is, so that pairs of numbers unpack in order.
RASTERLAB_AVX512 inline __m256i eight_rows() {
  return _mm256_setr_epi32(0, 1, 4, 5, 2, 3, 6, 7);
}

/// Writes `bytes` bytes of a row of any length.
RASTERLAB_AVX512 inline void store_row(std::uint8_t* row, unsigned bytes, __m512i pattern) {
  for (; bytes > 3 * widest_store; bytes -= 3 * widest_store, row += 3 * widest_store)
    _mm512_storeu_si512(row, pattern);
  _mm512_mask_storeu_epi8(row, _bzhi_u64(~std::uint64_t{0}, bytes), pattern);
}

RASTERLAB_AVX512 inline __m256i three_times(__m256i numbers) {
  return _mm256_add_epi32(_mm256_add_epi32(numbers, numbers), numbers);
}

/// Writes the first `count` of eight rows; row i is `strides` lane of it from `image` on. The
/// narrower the stores, the seldomer they reach into a cache line that is not needed.
RASTERLAB_AVX512 inline void store_rows(std::uint8_t* image, __m256i strides, const Spans& spans,
                                        int count, __m512i pattern) {
  const __m256i bytes = three_times(spans.pixels);
  const __m256i offsets = _mm256_add_epi32(strides, three_times(spans.begin));
  const bool narrow = _mm256_cmpgt_epi32_mask(spans.pixels, _mm256_set1_epi32(widest_narrow)) == 0;
  const __m256i all = _mm256_set1_epi32(-1);
  const __m256i what = narrow ? _mm256_andnot_si256(_mm256_sllv_epi32(all, bytes), all) : bytes;
  // A row's offset and what of it is written, in one number each.
  alignas(32) std::array<std::uint64_t, rows_at_once> rows;
  auto* const half = reinterpret_cast<__m256i*>(rows.data());
  _mm256_store_si256(half, _mm256_unpacklo_epi32(what, offsets));
  _mm256_store_si256(half + 1, _mm256_unpackhi_epi32(what, offsets));
  const auto last = static_cast<std::size_t>(count);
  if (narrow) {
    for (std::size_t i = 0; i < last; ++i) {
      _mm256_mask_storeu_epi8(image + (rows[i] >> 32), static_cast<__mmask32>(rows[i]),
                              _mm512_castsi512_si256(pattern));
    }
  } else {
    for (std::size_t i = 0; i < last; ++i)
      store_row(image + (rows[i] >> 32), static_cast<unsigned>(rows[i]), pattern);
  }
}

}  // namespace

RASTERLAB_AVX512 std::int64_t fill_spans_avx512(Image<Rgb8>& image, const Corners& corners,
                                                const Rgb8& color) {
  static_assert(sizeof(Corners) == 6 * sizeof(double));
  const __m512d coordinates = _mm512_maskz_loadu_pd(0b111111, corners.data());
  const __mmask8 beyond =
      _mm512_cmp_pd_mask(_mm512_abs_pd(coordinates), _mm512_set1_pd(max_coordinate), _CMP_NLE_UQ);
  if (beyond != 0) return span_fills().front().fill(image, corners, color);
  const SortedCorners sorted = sort_corners(coordinates);
  const Lines lines = lines_of(sorted);
  const __m128i ends = rows_of(sorted, image.height());
  const int first = _mm_cvtsi128_si32(ends);
  const int last = _mm_extract_epi32(ends, 1);
  const __m512i pattern = color_pattern(color);
  const std::ptrdiff_t stride = std::ptrdiff_t{3} * image.width();
  const __m256i strides =
      _mm256_mullo_epi32(eight_rows(), _mm256_set1_epi32(static_cast<int>(stride)));
  const __m256i past = _mm256_set1_epi32(last);
  __m256i rows = _mm256_add_epi32(_mm256_broadcastd_epi32(ends), eight_rows());
  __m256i drawn = _mm256_setzero_si256();
  auto* to = reinterpret_cast<std::uint8_t*>(image.row(0)) + first * stride;
  for (int y = first; y < last; y += rows_at_once) {
    Spans spans = spans_of(lines, rows, image.width());
    spans.pixels = _mm256_maskz_mov_epi32(_mm256_cmplt_epi32_mask(rows, past), spans.pixels);
    drawn = _mm256_add_epi32(drawn, spans.pixels);
    store_rows(to, strides, spans, std::min(last - y, rows_at_once), pattern);
    rows = _mm256_add_epi32(rows, _mm256_set1_epi32(rows_at_once));
    to += rows_at_once * stride;
  }
  return _mm512_reduce_add_epi32(_mm512_zextsi256_si512(drawn));
}

}  // namespace rasterlab

#else

namespace rasterlab {

std::int64_t fill_spans_avx512(Image<Rgb8>&, const Corners&, const Rgb8&) {
  return 0;
}

}  // namespace rasterlab

#endif
