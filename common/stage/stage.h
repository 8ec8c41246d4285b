// What the seven executables share: the command line, the manifest, where results go, how errors
// end.
//
// A stage's main.cpp is a table of its exercises and a call of run_stage():
//
//   int main(int argc, char** argv) {
//     return run_stage(argc, argv, {.name = "01_lines", .exercises = {{"01.3", &fading_line}, …}});
//   }
#pragma once

#include "common/stage/given_files.h"
#include "common/stage/guard.h"
#include "common/stage/run.h"

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace rasterlab {

/// An exercise as the stage runs it; its title and all else stand in exercises.json.
struct Exercise {
  std::string id;
  std::function<void(Run&)> run;
};

/// A rung of a ladder as `--algorithm list` prints it.
struct Rung {
  std::string name;
  std::string known_fault;
};

/// The rungs of one exercise's ladder, worst first.
struct Ladder {
  std::string exercise;
  std::vector<Rung> rungs;
};

/// A further way to use a stage, as by `--lines FILE`: adds its flags, and runs instead of the
/// exercises when its flags were given.
struct OwnInput {
  std::function<void(CLI::App&)> add_flags;
  std::function<bool()> given;
  std::function<void(Run&)> run;
};

/// The stage's exercises.json, built into its executable.
extern const char* const stage_manifest;

struct Stage {
  std::string name;  ///< "01_lines"
  std::vector<Exercise> exercises;
  std::vector<Ladder> ladders = {};
  std::vector<OwnInput> own_inputs = {};
  /// Adds subcommands (`01_lines convert IN OUT`), each with its callback.
  std::function<void(CLI::App&)> add_commands = {};
  const char* manifest = stage_manifest;
};

/// Parses the command line and does what it says. Returns the exit status: 0 done, 1 bad input, 2
/// bad usage. Each error is one line on standard error, "NAME: message"; a failed check also leaves
/// `backtrace_log.txt`.
int run_stage(int argc, char** argv, const Stage& stage);

}  // namespace rasterlab
