// A topic's ladder as a stage shows it with --algorithm.
#pragma once

#include "common/stage/stage.h"

#include <string>

namespace rasterlab {

/// Of a table whose rows have a `name` and a `known_fault`, worst first.
template <class Rungs>
Ladder ladder_of(const std::string& exercise, const Rungs& rungs) {
  Ladder ladder{.exercise = exercise, .rungs = {}};
  for (const auto& rung : rungs) ladder.rungs.push_back({rung.name, rung.known_fault});
  return ladder;
}

}  // namespace rasterlab
