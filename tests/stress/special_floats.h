// The floats that arithmetic stumbles over.
#pragma once

#include <array>
#include <limits>

namespace rasterlab::stress {

inline constexpr std::array<float, 20> special_floats = [] {
  using Limits = std::numeric_limits<float>;
  return std::array<float, 20>{0,
                               -0.0F,
                               1,
                               -1,
                               Limits::quiet_NaN(),
                               -Limits::quiet_NaN(),
                               Limits::signaling_NaN(),
                               Limits::infinity(),
                               -Limits::infinity(),
                               Limits::max(),
                               -Limits::max(),
                               Limits::max() / 16,
                               Limits::min(),
                               -Limits::min(),
                               Limits::denorm_min(),
                               -Limits::denorm_min(),
                               0x1p-24F,
                               -0x1p-24F,
                               0x1p24F,
                               -0x1p24F};
}();

}  // namespace rasterlab::stress
