// What the seven executables share: the command line, the manifest, where results go, how errors end.
//
// A stage's main.cpp is a table of its exercises and a call of run_stage():
//
//   int main(int argc, char** argv) {
//     return run_stage(argc, argv, {.name = "01_lines", .exercises = {{"01.3", &fading_line}, …}});
//   }
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace rasterlab {

/// A command line that asks for what is not there. Ends an executable with exit status 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Size {
  int width = 0;
  int height = 0;
};

/// One run of a stage: what was asked for, and where results go.
class Run {
 public:
  /// Writes a picture as `NAME.png` into the output folder, or to the file that --out names. NAME has no extension;
  /// by convention it starts with the exercise id and says what it shows: "01.5_bresenham".
  template <class Pixel>
  void picture(const std::string& name, const Image<Pixel>& image);

  /// A printout: shown on standard output when its exercise was asked for by --exercise, and written as `NAME.txt`
  /// when all were.
  void printout(const std::string& name, const std::string& text);

  /// A file of any other kind, made by `write`, which gets the path to write to; renamed into place afterwards.
  void file(const std::string& file_name, const std::function<void(const std::filesystem::path&)>& write);

  /// --size, else `fallback`.
  Size size(Size fallback) const { return size_.value_or(fallback); }

  /// Whether a rung of a ladder is to be drawn: all are, unless --algorithm chose one.
  bool draws(std::string_view rung) const { return algorithm_.empty() || algorithm_ == rung; }

  /// The object --stats prints; exercises add what they counted.
  nlohmann::json& statistics() { return statistics_; }
  bool wants_statistics() const { return stats_; }

  /// Shows "LABEL 12/100" on a terminal, nothing elsewhere.
  void progress(const std::string& label, int done, int total) const;

 private:
  friend class StageProgram;

  std::filesystem::path path_of(const std::string& file_name);
  void finish_exercise();

  std::filesystem::path out_;
  bool out_is_file_ = false;
  bool single_exercise_ = false;
  bool quiet_ = false;
  bool stats_ = false;
  std::optional<Size> size_;
  std::string algorithm_;
  nlohmann::json statistics_ = nlohmann::json::object();
  int files_written_ = 0;
};

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

/// A further way to use a stage, as by `--lines FILE`: adds its flags, and runs instead of the exercises when its
/// flags were given.
struct OwnInput {
  std::function<void(CLI::App&)> add_flags;
  std::function<bool()> given;
  std::function<void(Run&)> run;
};

struct Stage {
  std::string name;  ///< "01_lines"
  std::vector<Exercise> exercises;
  std::vector<Ladder> ladders = {};
  std::vector<OwnInput> own_inputs = {};
  /// Adds subcommands (`01_lines convert IN OUT`), each with its callback.
  std::function<void(CLI::App&)> add_commands = {};
};

/// The stage's exercises.json, built into its executable.
extern const char* const stage_manifest;

/// Parses the command line and does what it says. Returns the exit status: 0 done, 1 bad input, 2 bad usage. Each error
/// is one line on standard error, "NAME: message"; a failed check also leaves `backtrace_log.txt`.
int run_stage(int argc, char** argv, const Stage& stage);

/// The same error handling for an executable that is no stage: runs `body`, turns what it throws into a line and an exit
/// status.
int run_guarded(const std::string& program, const std::function<int()>& body);

/// A file of the repository's `data` folder.
std::filesystem::path data_path(const std::string& file_name);

/// The Stanford bunny of Debian's glmark2-data.
std::filesystem::path bunny_path();

}  // namespace rasterlab
