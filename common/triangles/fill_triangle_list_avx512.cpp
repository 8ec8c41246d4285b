// Many small triangles, eight at a time.
//
// A triangle of ten pixels is drawn in less time than a processor needs to notice that it guessed
// its number of rows wrongly. Here eight triangles are computed side by side, row by row from the
// top of each, and what they cover is put into one queue, without asking which of them has how many
// rows. So there is a wrong guess in some triangles, not some in each.
#include "common/triangles/fill_triangle_list_avx512.h"

#include "common/lines/avx512.h"
#include "common/triangles/fill_spans.h"

#if defined(__x86_64__)

#include <algorithm>
#include <array>
#include <bit>

namespace rasterlab {
namespace {

constexpr std::size_t at_once = 8;

/// What is larger in pixels is as quickly drawn by itself.
constexpr int widest = 63;
constexpr int highest = 32;

constexpr int widest_store = 21;  // pixels

/// One number for each of eight triangles.
struct Numbers {
  __m512d of;
};

/// The corners in units of 1/256 pixel. Whole numbers, but held as doubles.
struct SnappedCorners {
  std::array<Numbers, 3> x;
  std::array<Numbers, 3> y;
};

/// One corner, x and y in turn, of each second triangle from the one at `triangle` on.
RASTERLAB_AVX512 inline __m512d snap_each_second(const double* triangle, int corner) {
  static_assert(sizeof(Corners) == 6 * sizeof(double));
  const __m512i places = _mm512_add_epi64(_mm512_set1_epi64(2LL * corner),
                                          _mm512_setr_epi64(0, 1, 10, 11, 0, 0, 0, 0));
  const auto two = [places](const double* first) RASTERLAB_AVX512 {
    return _mm512_castpd512_pd256(
        _mm512_permutex2var_pd(_mm512_loadu_pd(first), places, _mm512_loadu_pd(first + 10)));
  };
  const __m512d pixels =
      _mm512_insertf64x4(_mm512_castpd256_pd512(two(triangle)), two(triangle + 24), 1);
  return _mm512_roundscale_pd(_mm512_mul_pd(pixels, _mm512_set1_pd(subpixels)),
                              _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
}

RASTERLAB_AVX512 inline SnappedCorners snap_corners(const Corners* triangles) {
  const auto* const first = reinterpret_cast<const double*>(triangles);
  SnappedCorners corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const __m512d even = snap_each_second(first, static_cast<int>(i));
    const __m512d odd = snap_each_second(first + 6, static_cast<int>(i));
    corners.x[i].of = _mm512_unpacklo_pd(even, odd);
    corners.y[i].of = _mm512_unpackhi_pd(even, odd);
  }
  return corners;
}

/// From the least to the largest of three.
struct Range {
  __m512d low;
  __m512d high;
};

RASTERLAB_AVX512 inline Range range_of(const std::array<Numbers, 3>& numbers) {
  return {_mm512_min_pd(_mm512_min_pd(numbers[0].of, numbers[1].of), numbers[2].of),
          _mm512_max_pd(_mm512_max_pd(numbers[0].of, numbers[1].of), numbers[2].of)};
}

/// Where a range is within ±max_coordinate and at most `longest` pixels long.
RASTERLAB_AVX512 inline __mmask8 is_short(const Range& range, int longest) {
  constexpr double bound = max_coordinate * subpixels;
  const __m512d most = _mm512_set1_pd(static_cast<double>(subpixels * longest));
  __mmask8 is = _mm512_cmp_pd_mask(_mm512_sub_pd(range.high, range.low), most, _CMP_LE_OQ);
  is = _mm512_mask_cmp_pd_mask(is, range.low, _mm512_set1_pd(-bound), _CMP_GE_OQ);
  return _mm512_mask_cmp_pd_mask(is, range.high, _mm512_set1_pd(bound), _CMP_LE_OQ);
}

/// The first rows whose centres are at or below y, within 0 … height.
RASTERLAB_AVX512 inline __m256i first_rows(__m512d y, int height) {
  const __m512d centers =
      _mm512_sub_pd(_mm512_mul_pd(y, _mm512_set1_pd(1.0 / subpixels)), _mm512_set1_pd(0.5));
  const __m256i rows =
      _mm512_cvtpd_epi32(_mm512_roundscale_pd(centers, _MM_FROUND_TO_POS_INF | _MM_FROUND_NO_EXC));
  return _mm256_max_epi32(_mm256_min_epi32(rows, _mm256_set1_epi32(height)),
                          _mm256_setzero_si256());
}

/// A side as the line through it: in the row whose centre is `r` rows below the first one's, what
/// is right of it begins with pixel ⌊x + (down + 256 r) · slope⌋. Exact as Side in
/// fill_spans_avx512.cpp is.
struct Side {
  __m512d x;      ///< in pixels
  __m512d down;   ///< to the centre of the first row, in 1/256 pixel
  __m512d slope;  ///< pixels for 1/256 pixel
  __mmask8 left;  ///< the triangle is right of it
  __mmask8 right;
};

struct Eight {
  std::array<Side, 3> sides;
  __m256i first;   ///< row
  __m256i rows;    ///< how many; none of a triangle that is not small, or has no area
  __mmask8 small;  ///< not to be drawn by itself
};

/// From corner i to the next.
RASTERLAB_AVX512 inline __m512d along_side(const std::array<Numbers, 3>& corners, std::size_t i) {
  return _mm512_sub_pd(corners[(i + 1) % 3].of, corners[i].of);
}

RASTERLAB_AVX512 inline Eight set_up(const Corners* triangles, int height) {
  const SnappedCorners corner = snap_corners(triangles);
  const Range y = range_of(corner.y);
  const __m512d zero = _mm512_setzero_pd();
  const __m512d scale = _mm512_set1_pd(1.0 / subpixels);
  const __m512d area =
      _mm512_sub_pd(_mm512_mul_pd(along_side(corner.x, 0), along_side(corner.y, 1)),
                    _mm512_mul_pd(along_side(corner.y, 0), along_side(corner.x, 1)));
  const __mmask8 turned = _mm512_cmp_pd_mask(area, zero, _CMP_LT_OQ);
  Eight eight;
  eight.first = first_rows(y.low, height);
  const __m512d center =
      _mm512_add_pd(_mm512_mul_pd(_mm512_cvtepi32_pd(eight.first), _mm512_set1_pd(subpixels)),
                    _mm512_set1_pd(0.5 * subpixels));
  for (std::size_t i = 0; i < 3; ++i) {
    const __m512d dy = along_side(corner.y, i);
    const __mmask8 up = _mm512_cmp_pd_mask(dy, zero, _CMP_LT_OQ);
    const __mmask8 down = _mm512_cmp_pd_mask(dy, zero, _CMP_GT_OQ);
    eight.sides[i] = {
        _mm512_add_pd(_mm512_mul_pd(corner.x[i].of, scale), _mm512_set1_pd(0.5 - 0x1p-33)),
        _mm512_sub_pd(center, corner.y[i].of),
        _mm512_div_pd(_mm512_mul_pd(along_side(corner.x, i), scale), dy),
        static_cast<__mmask8>((turned & down) | (~turned & up)),
        static_cast<__mmask8>((turned & up) | (~turned & down))};
  }
  // A coordinate that is not a number may get lost in a range, but not in the area.
  eight.small =
      _mm512_mask_cmp_pd_mask(is_short(range_of(corner.x), widest), area, area, _CMP_ORD_Q) &
      is_short(y, highest);
  const __mmask8 drawn = _mm512_mask_cmp_pd_mask(eight.small, area, zero, _CMP_NEQ_OQ);
  eight.rows = _mm256_maskz_sub_epi32(drawn, first_rows(y.high, height), eight.first);
  return eight;
}

/// Stores that wait: where, and which bytes.
class Queue {
 public:
  RASTERLAB_AVX512 void add(__mmask8 which, __m512i offsets, __m512i masks) {
    _mm512_storeu_si512(&offsets_[size_], _mm512_maskz_compress_epi64(which, offsets));
    _mm512_storeu_si512(&masks_[size_], _mm512_maskz_compress_epi64(which, masks));
    size_ += static_cast<std::size_t>(std::popcount(static_cast<unsigned>(which)));
  }

  bool is_full() const { return size_ > offsets_.size() - at_once; }

  RASTERLAB_AVX512 void write(std::uint8_t* image, __m512i pattern) {
    for (std::size_t i = 0; i < size_; ++i)
      _mm512_mask_storeu_epi8(image + offsets_[i], masks_[i], pattern);
    size_ = 0;
  }

 private:
  alignas(64) std::array<std::int64_t, 256> offsets_;
  alignas(64) std::array<std::uint64_t, 256> masks_;
  std::size_t size_ = 0;
};

/// The pixels of one row of each triangle, begin ≤ x < begin + pixels; none for pixels ≤ 0.
struct Spans {
  __m256i begin;
  __m256i pixels;
};

RASTERLAB_AVX512 inline Spans spans_of(const Eight& eight, int row, int width) {
  const __m512d below = _mm512_set1_pd(static_cast<double>(subpixels * row));
  __m512d begin = _mm512_setzero_pd();
  __m512d end = _mm512_set1_pd(width);
  for (const Side& side : eight.sides) {
    const __m512d x = _mm512_fmadd_pd(_mm512_add_pd(side.down, below), side.slope, side.x);
    begin = _mm512_mask_max_pd(begin, side.left, begin, x);
    end = _mm512_mask_min_pd(end, side.right, end, x);
  }
  const __m256i first = _mm512_cvttpd_epi32(begin);
  return {first, _mm256_sub_epi32(_mm512_cvttpd_epi32(end), first)};
}

/// Draws to an image by way of a queue.
class Drawing {
 public:
  RASTERLAB_AVX512 Drawing(Image<Rgb8>& image, const Rgb8& color)
      : image_(image),
        bytes_(reinterpret_cast<std::uint8_t*>(image.row(0))),
        pattern_(color_pattern(color)) {}

  /// Draws the small ones of eight triangles.
  RASTERLAB_AVX512 void draw(const Eight& eight) {
    const __m512i stride = _mm512_set1_epi64(3LL * image_.width());
    __m512i row = _mm512_mul_epu32(_mm512_cvtepu32_epi64(eight.first), stride);
    const int most = _mm512_reduce_max_epi32(_mm512_zextsi256_si512(eight.rows));
    __mmask8 drawn = 0;
    for (int r = 0; r < most; ++r) {
      const Spans spans = spans_of(eight, r, image_.width());
      __mmask8 there = _mm256_cmpgt_epi32_mask(eight.rows, _mm256_set1_epi32(r));
      there = _mm256_mask_cmpgt_epi32_mask(there, spans.pixels, _mm256_setzero_si256());
      pixels_ = _mm512_mask_add_epi64(pixels_, there, pixels_, _mm512_cvtepi32_epi64(spans.pixels));
      add(there, row, spans);
      drawn |= there;
      row = _mm512_add_epi64(row, stride);
    }
    triangles_ += std::popcount(static_cast<unsigned>(drawn));
  }

  /// Returns what was drawn of all of those.
  RASTERLAB_AVX512 DrawnTriangles finish() {
    queue_.write(bytes_, pattern_);
    return {_mm512_reduce_add_epi64(pixels_), triangles_};
  }

 private:
  /// Adds the rows in parts of one store each; for most triangles that is one.
  RASTERLAB_AVX512 void add(__mmask8 which, __m512i row, const Spans& spans) {
    const __m256i three = _mm256_set1_epi32(3);
    const __m512i one = _mm512_set1_epi64(1);
    const __m512i longest = _mm512_set1_epi64(3 * widest_store);
    __m512i offset =
        _mm512_add_epi64(row, _mm512_cvtepu32_epi64(_mm256_mullo_epi32(spans.begin, three)));
    __m512i bytes = _mm512_cvtepi32_epi64(_mm256_mullo_epi32(spans.pixels, three));
    for (;;) {
      const __m512i length = _mm512_min_epi64(bytes, longest);
      queue_.add(which, offset, _mm512_sub_epi64(_mm512_sllv_epi64(one, length), one));
      if (queue_.is_full()) queue_.write(bytes_, pattern_);
      which = _mm512_mask_cmpgt_epi64_mask(which, bytes, longest);
      if (which == 0) return;
      offset = _mm512_add_epi64(offset, longest);
      bytes = _mm512_sub_epi64(bytes, longest);
    }
  }

  Image<Rgb8>& image_;
  std::uint8_t* bytes_;
  __m512i pattern_;
  __m512i pixels_ = _mm512_setzero_si512();
  std::int64_t triangles_ = 0;
  Queue queue_;
};

}  // namespace

RASTERLAB_AVX512 DrawnTriangles fill_triangle_list_avx512(Image<Rgb8>& image,
                                                          std::span<const Corners> triangles,
                                                          const Rgb8& color) {
  Drawing drawing(image, color);
  DrawnTriangles drawn;
  std::array<Corners, at_once> eight;
  eight.fill({Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()});
  for (; !triangles.empty(); triangles = triangles.subspan(std::min(triangles.size(), at_once))) {
    const Corners* from = triangles.data();
    if (triangles.size() < at_once) {
      std::copy(triangles.begin(), triangles.end(), eight.begin());
      from = eight.data();
    }
    const Eight set = set_up(from, image.height());
    drawing.draw(set);
    for (unsigned large = static_cast<__mmask8>(~set.small); large != 0; large &= large - 1)
      drawn.add(fill_spans(image, from[std::countr_zero(large)], color));
  }
  const DrawnTriangles small = drawing.finish();
  return {drawn.pixels + small.pixels, drawn.triangles + small.triangles};
}

}  // namespace rasterlab

#else

namespace rasterlab {

DrawnTriangles fill_triangle_list_avx512(Image<Rgb8>&, std::span<const Corners>, const Rgb8&) {
  return {};
}

}  // namespace rasterlab

#endif
