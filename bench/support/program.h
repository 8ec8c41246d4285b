// What the programs that measure a stage's ladders share: the command line, and where results go.
#pragma once

#include "bench/support/ladder.h"

#include <functional>
#include <string>
#include <vector>

namespace rasterlab::bench {

/// A ladder's name and how it is made, when its turn comes.
using MakeLadder = std::function<TimedLadder()>;

struct Program {
  std::string name;         ///< "bench_01_lines"
  std::string description;  ///< for --help
  std::vector<MakeLadder> ladders;
};

/// Parses the command line, measures each ladder, prints its table, and writes them all to
/// NAME.json in the folder of --out. Returns the exit status: 0 done, 1 for what cannot be written,
/// 2 for bad usage.
int run_program(int argc, char** argv, const Program& program);

}  // namespace rasterlab::bench
