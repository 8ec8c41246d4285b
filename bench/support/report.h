// What was measured of a ladder, on a terminal and as JSON.
#pragma once

#include "bench/support/ladder.h"

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace rasterlab::bench {

/// A ladder and, for each of its rungs, nanoseconds per unit of work, one sample per repetition.
struct MeasuredLadder {
  TimedLadder ladder;
  std::vector<std::vector<double>> samples;
};

/// An array with one object per rung:
///
///   ladder, stage, unit, rung, role ("rung", "peer" or "limit"), fault
///   ns_median, ns_min, ns_spread   nanoseconds per unit; distance of the quartiles by the median
///   repetitions
///   errors                         an object: name → value, null where none is to be trusted
///   plotted_error                  which of them the plot shows
///   ratio                          where the ladder has a peer: the peer's time by this one's,
///                                  {median, spread} over the repetitions
///   commit, machine
nlohmann::ordered_json to_json(const std::vector<MeasuredLadder>& measured);

/// The ladder as a table, one line per rung.
std::string table(const MeasuredLadder& measured);

}  // namespace rasterlab::bench
