#include "common/stage/stage.h"

#include "common/image/check.h"
#include "common/stage/manifest.h"

#include <algorithm>
#include <chrono>
#include <iostream>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace rasterlab {
namespace {

/// "640x480" to a size.
Size parse_size(const std::string& text) {
  Size size;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &size.width, &size.height, &rest) != 2 ||
      size.width < 1 || size.height < 1 ||
      static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) >
          max_pixel_count) {
    throw UsageError("--size " + text +
                     ": expected WIDTHxHEIGHT in pixels, each at least 1, as in 640x480, and at "
                     "most 2^28 pixels");
  }
  return size;
}

const ManifestEntry& entry_with(const std::vector<ManifestEntry>& manifest, const std::string& id) {
  for (const ManifestEntry& entry : manifest) {
    if (entry.id == id) return entry;
  }
  throw std::logic_error("exercise " + id + " stands in main.cpp but not in exercises.json");
}

void print_exercises(const Stage& stage) {
  const std::vector<ManifestEntry> manifest = parse_manifest(stage.manifest);
  for (const Exercise& exercise : stage.exercises) {
    const ManifestEntry& entry = entry_with(manifest, exercise.id);
    std::cout << exercise.id << "  " << entry.title << "\n";
    for (const std::string& name : entry.writes) std::cout << "        " << name << "\n";
  }
}

void print_ladders(const Stage& stage) {
  for (const Ladder& ladder : stage.ladders) {
    std::cout << ladder.exercise << ", worst first\n";
    for (const Rung& rung : ladder.rungs)
      std::cout << "  " << rung.name << ": " << rung.known_fault << "\n";
  }
}

/// The names of the rungs, for an error message.
std::string rung_names(const Stage& stage) {
  std::string names = "list";
  for (const Ladder& ladder : stage.ladders) {
    for (const Rung& rung : ladder.rungs) names += ", " + rung.name;
  }
  return names;
}

const Ladder* ladder_with(const Stage& stage, const std::string& rung) {
  for (const Ladder& ladder : stage.ladders) {
    for (const Rung& candidate : ladder.rungs) {
      if (candidate.name == rung) return &ladder;
    }
  }
  return nullptr;
}

/// The exercises that the flags ask for; --algorithm alone asks for its ladder.
std::vector<Exercise> chosen_exercises(const Stage& stage, const RunSettings& settings) {
  std::string id = settings.exercise;
  if (!settings.algorithm.empty()) {
    const Ladder* ladder = ladder_with(stage, settings.algorithm);
    if (ladder == nullptr) {
      throw UsageError("--algorithm " + settings.algorithm + ": expected one of " +
                       rung_names(stage));
    }
    if (id.empty()) id = ladder->exercise;
  }
  std::vector<Exercise> chosen;
  std::string known;
  for (const Exercise& exercise : stage.exercises) {
    if (id.empty() || exercise.id == id) chosen.push_back(exercise);
    known += (known.empty() ? "" : ", ") + exercise.id;
  }
  if (chosen.empty() && !id.empty())
    throw UsageError("--exercise " + id + ": expected one of " + known);
  return chosen;
}

/// Runs one thing and notes how long it took.
void run_timed(Run& run, const std::string& id, const std::function<void(Run&)>& what) {
  const auto start = std::chrono::steady_clock::now();
  try {
    what(run);
  } catch (const NotWritten& gap) {
    // A starter shows what there is and says what is missing.
    std::cerr << id << ": "
              << (gap.exercise() == id ? "" : "needs " + gap.exercise() + ", which is ")
              << "not written yet\n";
    return;
  }
  const std::chrono::duration<double, std::milli> elapsed =
      std::chrono::steady_clock::now() - start;
  run.statistics()["milliseconds"][id] = elapsed.count();
}

/// The command line of a stage and what it asks for.
class StageProgram {
 public:
  explicit StageProgram(const Stage& stage)
      : stage_(stage), app_("RasterLab, stage " + stage.name) {
    app_.name(stage.name);
    app_.option_defaults()->always_capture_default(false);
    add_common_flags();
    for (const OwnInput& input : stage_.own_inputs) input.add_flags(app_);
    if (stage_.add_commands) stage_.add_commands(app_);
  }

  int run(int argc, char** argv) {
    if (!parse_command_line(app_, argc, argv)) return 0;
    if (!app_.get_subcommands().empty()) return 0;  // a subcommand has run by its callback
    if (list_) {
      print_exercises(stage_);
    } else if (settings_.algorithm == "list") {
      print_ladders(stage_);
    } else {
      run_what_was_asked();
    }
    return 0;
  }

 private:
  void add_common_flags() {
    settings_.out = std::filesystem::path("out") / stage_.name;
    app_.add_flag("--list", list_, "List the exercises: id, title, what each writes");
    app_.add_option("--exercise", settings_.exercise, "Run only this exercise")->type_name("ID");
    app_.add_option("--out", settings_.out,
                    "Folder for the results (default " + settings_.out.string() +
                        "), or one picture's file, whose extension chooses the format")
        ->type_name("DIR_OR_FILE");
    app_.add_option_function<std::string>(
            "--size", [this](const std::string& text) { settings_.size = parse_size(text); },
            "Picture size, where the exercise does not fix it")
        ->type_name("WxH");
    if (!stage_.ladders.empty()) {
      app_.add_option("--algorithm", settings_.algorithm,
                      "Only this rung of a ladder; 'list' names them, worst first")
          ->type_name("NAME");
    }
    app_.add_flag(
        "--stats", settings_.statistics,
        "Print one JSON object: times, counts of work done and of work skipped by reason");
    app_.add_flag("-q,--quiet", settings_.quiet, "Do not print a line per file written");
  }

  void run_what_was_asked() {
    if (settings_.statistics) settings_.quiet = true;  // standard output is the JSON object alone
    Run run(settings_);
    const auto own = std::find_if(stage_.own_inputs.begin(), stage_.own_inputs.end(),
                                  [](const OwnInput& input) { return input.given(); });
    if (own != stage_.own_inputs.end()) {
      run_timed(run, "own_input", own->run);
    } else {
      for (const Exercise& exercise : chosen_exercises(stage_, settings_))
        run_timed(run, exercise.id, exercise.run);
    }
    run.finish();
    if (settings_.statistics) std::cout << run.statistics().dump(2) << std::endl;
  }

  const Stage& stage_;
  CLI::App app_;
  RunSettings settings_;
  bool list_ = false;
};

}  // namespace

int run_stage(int argc, char** argv, const Stage& stage) {
  return run_guarded(stage.name, [&] { return StageProgram(stage).run(argc, argv); });
}

}  // namespace rasterlab
