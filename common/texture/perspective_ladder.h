// The rungs of exercise 06.3, by name.
#pragma once

#include "common/texture/perspective_weights.h"

#include <array>
#include <string>

namespace rasterlab {

struct NamedPerspectiveRung {
  std::string name;
  PerspectiveRung weights;
  std::string known_fault;
};

/// Exercise 06.3's ladder, worst first.
const std::array<NamedPerspectiveRung, 4>& perspective_ladder();

}  // namespace rasterlab
