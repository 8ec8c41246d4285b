// A triangle, eight rows at a time.
//
// A small triangle has few pixels, and what takes time is that a processor cannot predict how many
// there are in each row: a branch that goes the other way than expected costs as much as ten rows.
// So there are few branches here. All three sides are computed in every row, as if they had no
// ends: the pixels of a row are right of every left side and left of every right one. And a row is
// written by one store that leaves out the bytes that are not the triangle's, however many they
// are.
#include "common/triangles/fill_spans_avx512.h"

#include "common/lines/avx512.h"

#if defined(__x86_64__)

#include <algorithm>
#include <array>

namespace rasterlab {
namespace {

constexpr int rows_at_once = 8;
constexpr int widest_store = 21;  // pixels

/// The corners in units of 1/256 pixel. Whole numbers, but held as doubles; the fourth of each
/// means nothing.
struct SnappedColumns {
  __m256d x;
  __m256d y;
};

RASTERLAB_AVX512 inline SnappedColumns snap_columns(const Corners& corners) {
  static_assert(sizeof(Corners) == 6 * sizeof(double));
  const __m512d pixels = _mm512_maskz_loadu_pd(0b111111, corners.data());
  const __m512d units = _mm512_roundscale_pd(_mm512_mul_pd(pixels, _mm512_set1_pd(subpixels)),
                                             _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
  const __m512i xs = _mm512_setr_epi64(0, 2, 4, 4, 0, 0, 0, 0);
  const __m512i ys = _mm512_setr_epi64(1, 3, 5, 5, 0, 0, 0, 0);
  return {_mm512_castpd512_pd256(_mm512_permutexvar_pd(xs, units)),
          _mm512_castpd512_pd256(_mm512_permutexvar_pd(ys, units))};
}

/// The rows first ≤ y < last of the image whose centres are at or below the top corner and above
/// the bottom one.
struct Rows {
  int first;
  int last;
};

RASTERLAB_AVX512 inline Rows rows_of(__m256d y, int height) {
  const __m256d centers =
      _mm256_sub_pd(_mm256_mul_pd(y, _mm256_set1_pd(1.0 / subpixels)), _mm256_set1_pd(0.5));
  __m128i rows =
      _mm256_cvtpd_epi32(_mm256_roundscale_pd(centers, _MM_FROUND_TO_POS_INF | _MM_FROUND_NO_EXC));
  rows = _mm_max_epi32(_mm_min_epi32(rows, _mm_set1_epi32(height)), _mm_setzero_si128());
  const int a = _mm_extract_epi32(rows, 0);
  const int b = _mm_extract_epi32(rows, 1);
  const int c = _mm_extract_epi32(rows, 2);
  return {std::min(a, std::min(b, c)), std::max(a, std::max(b, c))};
}

/// A side as the line through it: in the row whose centre is at `center`, what is right of it
/// begins with pixel ⌊x + (center − y) · slope⌋.
///
/// Exact by the reasoning of TriangleSide (spans.h): ½ pixel less 2^-33 is part of x, which is
/// exact; the slope, its product and the sum are rounded by less than 2^-34 together where the
/// result is within ±2^16 pixels, twice what corners are. Farther out only lines are that lead past
/// their sides' ends, and there, as a triangle is convex, another side decides.
struct Side {
  __m512d x;      ///< in pixels
  __m512d y;      ///< in 1/256 pixel
  __m512d slope;  ///< pixels for 1/256 pixel
  __mmask8 left;  ///< in all lanes or in none: the triangle is right of it
  __mmask8 right;
};

RASTERLAB_AVX512 inline __m512d in_all_lanes(__m256d values, int which) {
  return _mm512_permutexvar_pd(_mm512_set1_epi64(which), _mm512_castpd256_pd512(values));
}

/// False for a triangle without area.
RASTERLAB_AVX512 inline bool make_sides(const SnappedColumns& corner, std::array<Side, 3>& sides) {
  const __m256d dx = _mm256_sub_pd(_mm256_permute4x64_pd(corner.x, 0b00'00'10'01), corner.x);
  const __m256d dy = _mm256_sub_pd(_mm256_permute4x64_pd(corner.y, 0b00'00'10'01), corner.y);
  const double area = dx[0] * dy[1] - dy[0] * dx[1];  // below 2^51: exact
  const unsigned up = _mm256_cmp_pd_mask(dy, _mm256_setzero_pd(), _CMP_LT_OQ);
  const unsigned down = _mm256_cmp_pd_mask(dy, _mm256_setzero_pd(), _CMP_GT_OQ);
  const unsigned turned = area < 0 ? up ^ down : 0;
  const unsigned left = up ^ turned;
  const unsigned right = down ^ turned;
  const __m256d scale = _mm256_set1_pd(1.0 / subpixels);
  const __m256d slope = _mm256_div_pd(_mm256_mul_pd(dx, scale), dy);
  const __m256d x = _mm256_add_pd(_mm256_mul_pd(corner.x, scale), _mm256_set1_pd(0.5 - 0x1p-33));
  for (int i = 0; i < 3; ++i) {
    const auto all_if = [i](unsigned bits) {
      return static_cast<__mmask8>(0U - (bits >> static_cast<unsigned>(i) & 1U));
    };
    sides[static_cast<std::size_t>(i)] = {in_all_lanes(x, i), in_all_lanes(corner.y, i),
                                          in_all_lanes(slope, i), all_if(left), all_if(right)};
  }
  return area != 0;
}

/// The pixels of some rows, begin ≤ x < begin + pixels.
struct Spans {
  __m256i begin;
  __m256i pixels;
};

RASTERLAB_AVX512 inline Spans spans_of(const std::array<Side, 3>& sides, __m256i rows, int width) {
  const __m512d center =
      _mm512_add_pd(_mm512_mul_pd(_mm512_cvtepi32_pd(rows), _mm512_set1_pd(subpixels)),
                    _mm512_set1_pd(0.5 * subpixels));
  const __m512d last = _mm512_set1_pd(width);
  __m512d begin = _mm512_setzero_pd();
  __m512d end = last;
  for (const Side& side : sides) {
    const __m512d x =
        _mm512_add_pd(side.x, _mm512_mul_pd(_mm512_sub_pd(center, side.y), side.slope));
    begin = _mm512_mask_max_pd(begin, side.left, begin, x);
    end = _mm512_mask_min_pd(end, side.right, end, x);
  }
  const __m256i first = _mm512_cvttpd_epi32(_mm512_min_pd(begin, last));
  const __m256i past = _mm512_cvttpd_epi32(_mm512_max_pd(end, _mm512_setzero_pd()));
  return {first, _mm256_max_epi32(_mm256_sub_epi32(past, first), _mm256_setzero_si256())};
}

/// Writes a row of any length, `bytes` of them.
RASTERLAB_AVX512 inline void store_row(std::uint8_t* row, int bytes, __m512i pattern) {
  for (; bytes > 3 * widest_store; bytes -= 3 * widest_store, row += 3 * widest_store)
    _mm512_storeu_si512(row, pattern);
  _mm512_mask_storeu_epi8(row, _bzhi_u64(~std::uint64_t{0}, static_cast<unsigned>(bytes)), pattern);
}

/// Where eight rows go, and which bytes of them.
struct Places {
  alignas(64) std::array<std::int64_t, rows_at_once> offsets;
  alignas(64) std::array<std::uint64_t, rows_at_once> masks;
  alignas(32) std::array<int, rows_at_once> bytes;
};

/// Writes rows of at most `widest_store` pixels, or of ten when `narrow`. The narrower the store,
/// the seldomer it reaches into a cache line that is not needed.
RASTERLAB_AVX512 inline void store_rows(std::uint8_t* image, const Places& places, int count,
                                        bool narrow, __m512i pattern) {
  const auto rows = static_cast<std::size_t>(count);
  if (narrow) {
    for (std::size_t i = 0; i < rows; ++i) {
      _mm256_mask_storeu_epi8(image + places.offsets[i], static_cast<__mmask32>(places.masks[i]),
                              _mm512_castsi512_si256(pattern));
    }
  } else {
    for (std::size_t i = 0; i < rows; ++i)
      _mm512_mask_storeu_epi8(image + places.offsets[i], places.masks[i], pattern);
  }
}

}  // namespace

RASTERLAB_AVX512 std::int64_t fill_spans_avx512(Image<Rgb8>& image, const Corners& corners,
                                                const Rgb8& color) {
  const SnappedColumns corner = snap_columns(corners);
  std::array<Side, 3> sides;
  if (!make_sides(corner, sides)) return 0;
  const Rows rows = rows_of(corner.y, image.height());
  const __m512i pattern = color_pattern(color);
  auto* const first = reinterpret_cast<std::uint8_t*>(image.row(0));
  const __m256i three = _mm256_set1_epi32(3);
  __m256i pixels = _mm256_setzero_si256();
  Places places;
  for (int y = rows.first; y < rows.last; y += rows_at_once) {
    const int count = std::min(rows.last - y, rows_at_once);
    const __m256i row =
        _mm256_add_epi32(_mm256_set1_epi32(y), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
    const __mmask8 there = _mm256_cmplt_epi32_mask(row, _mm256_set1_epi32(rows.last));
    Spans spans = spans_of(sides, row, image.width());
    spans.pixels = _mm256_maskz_mov_epi32(there, spans.pixels);
    pixels = _mm256_add_epi32(pixels, spans.pixels);
    const __m256i bytes = _mm256_mullo_epi32(spans.pixels, three);
    const __m512i offset = _mm512_add_epi64(
        _mm512_mul_epu32(_mm512_cvtepu32_epi64(row), _mm512_set1_epi64(3LL * image.width())),
        _mm512_cvtepu32_epi64(_mm256_mullo_epi32(spans.begin, three)));
    _mm512_store_si512(places.offsets.data(), offset);
    if (_mm256_cmpgt_epi32_mask(spans.pixels, _mm256_set1_epi32(widest_store)) == 0) {
      const __m512i one = _mm512_set1_epi64(1);
      _mm512_store_si512(
          places.masks.data(),
          _mm512_sub_epi64(_mm512_sllv_epi64(one, _mm512_cvtepu32_epi64(bytes)), one));
      const bool narrow = _mm256_cmpgt_epi32_mask(spans.pixels, _mm256_set1_epi32(10)) == 0;
      store_rows(first, places, count, narrow, pattern);
    } else {
      _mm256_store_si256(reinterpret_cast<__m256i*>(places.bytes.data()), bytes);
      for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
        store_row(first + places.offsets[i], places.bytes[i], pattern);
    }
  }
  return _mm512_reduce_add_epi32(_mm512_zextsi256_si512(pixels));
}

}  // namespace rasterlab

#else

namespace rasterlab {

std::int64_t fill_spans_avx512(Image<Rgb8>&, const Corners&, const Rgb8&) {
  return 0;
}

}  // namespace rasterlab

#endif
