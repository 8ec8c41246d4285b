// One run of a stage: what the command line asked for, and where results go.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace rasterlab {

struct Size {
  int width = 0;
  int height = 0;
};

/// The values of the flags every stage has (see `--help`).
struct RunSettings {
  std::filesystem::path out;  ///< --out, else out/NN_topic
  std::string exercise;       ///< --exercise; empty: all of them
  std::string algorithm;      ///< --algorithm; empty: every rung
  std::optional<Size> size;   ///< --size
  bool statistics = false;    ///< --stats
  bool quiet = false;         ///< -q
};

class Run {
 public:
  explicit Run(RunSettings settings);

  /// Writes a picture as `NAME.png` into the output folder. Where --out names one file, that is
  /// written by finish(), so that a run with several results is refused and leaves nothing. NAME
  /// has no extension and starts with the exercise's id: "01.5_bresenham". Pixels: grey, Rgb8,
  /// Rgba8 (float: `NAME.pfm`).
  template <class Pixel>
  void picture(const std::string& name, const Image<Pixel>& image);

  /// A printout: shown on standard output when its exercise was asked for by --exercise and no
  /// --stats, else written as `NAME.txt`.
  void printout(const std::string& name, const std::string& text);

  using Writer = std::function<void(const std::filesystem::path&)>;

  /// A file of any other kind, made by `write`, which gets the path to write to and may be called
  /// as late as in finish(): it holds what it writes.
  void file(const std::string& file_name, const Writer& write);

  /// Called when all went well: writes the single file that --out names.
  void finish();

  /// Says "wrote PATH" for a file made by other means, as one named by its own flag.
  void announce(const std::filesystem::path& path) const;

  /// --size, else `fallback`.
  Size size(Size fallback) const { return settings_.size.value_or(fallback); }

  /// Whether a rung of a ladder is to be drawn: all are, unless --algorithm chose one.
  bool draws(std::string_view rung) const {
    return settings_.algorithm.empty() || settings_.algorithm == rung;
  }

  /// The object --stats prints; exercises add what they counted.
  nlohmann::json& statistics() { return statistics_; }

  /// Shows "LABEL 12/100" on a terminal, nothing elsewhere.
  void progress(const std::string& label, int done, int total) const;

  const RunSettings& settings() const { return settings_; }

  /// Whether --out names a file, not a folder.
  bool out_is_file() const;

 private:
  std::filesystem::path path_in_folder(const std::string& file_name) const;
  void keep_as_single(const std::string& file_name, const Writer& write);

  RunSettings settings_;
  nlohmann::json statistics_ = nlohmann::json::object();
  Writer write_single_;      ///< for the single file that --out names
  std::string single_name_;  ///< what it would be called in a folder
};

}  // namespace rasterlab
