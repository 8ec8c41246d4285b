// How time and memory follow what is visible, threads and size: our side only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace rasterlab::bench {

struct ScalingResult {
  std::string name;
  double value;   ///< a median, …
  double spread;  ///< … and how far apart its quartiles are, in the same unit
  double limit;
  bool at_least;  ///< whether the limit is a lower one
  /// Of two threads: what they were meanwhile against one where neither needs the other nor memory.
  std::optional<double> machine = {};

  bool reached() const { return at_least ? value >= limit : value <= limit; }
};

/// Measures all, each in a process of its own, and prints a line each.
std::vector<ScalingResult> measure_scaling();

nlohmann::json to_json(const std::vector<ScalingResult>& results);

}  // namespace rasterlab::bench
