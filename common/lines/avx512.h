// What functions need that are written for AVX-512, whichever processor the rest is compiled for.
#pragma once

namespace rasterlab {

/// Whether this processor has what RASTERLAB_AVX512 functions need.
bool has_avx512();

}  // namespace rasterlab

#if defined(__x86_64__)

#include "common/image/pixel.h"

#include <array>
#include <cstddef>
#include <cstdint>

// g++ 12 takes the header's way to say "whatever value" for a mistake (GCC bug 105593).
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#ifndef __clang__
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <immintrin.h>
#pragma GCC diagnostic pop

// Only these functions are compiled for it, so that a binary runs on any processor.
#define RASTERLAB_AVX512 __attribute__((target("avx512f,avx512bw,avx512dq,avx512vl,bmi2")))

namespace rasterlab {

/// 0, 1, 2, 0, 1, 2 …
alignas(64) inline constexpr auto channels = [] {
  std::array<std::uint8_t, 64> which{};
  for (std::size_t i = 0; i < which.size(); ++i) which[i] = static_cast<std::uint8_t>(i % 3);
  return which;
}();

/// A colour's three bytes over and over.
RASTERLAB_AVX512 inline __m512i color_pattern(const Rgb8& color) {
  return _mm512_shuffle_epi8(_mm512_set1_epi32(color.r | color.g << 8 | color.b << 16),
                             _mm512_load_si512(channels.data()));
}

}  // namespace rasterlab

#endif
