// A ladder as it is measured: ways to do one thing, each timed and judged on the same inputs.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace rasterlab::bench {

/// Errors by name, as the field names them; in the order they are printed in. Not a number where
/// the oracle is not sure.
using Errors = std::vector<std::pair<std::string, double>>;

/// What is timed: one of ours; somebody else's, which ours is compared with; or what the machine
/// needs at least, whoever does it.
enum class Role { rung, peer, limit };

struct TimedRung {
  std::string name;
  std::string fault;           ///< what is known to be wrong with it
  std::function<void()> work;  ///< does all of the ladder's work once
  Errors errors;
  Role role = Role::rung;
};

struct TimedLadder {
  std::string name;
  std::string stage;             ///< "01"
  std::string unit;              ///< of work, as "pixel"
  double units = 1;              ///< of work in one call
  std::string error;             ///< which of the errors the plot shows
  std::vector<TimedRung> rungs;  ///< worst first; limit and peer before
};

}  // namespace rasterlab::bench
