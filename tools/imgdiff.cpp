// Compares two pictures and says what kind of wrong the one is.
#include "common/image/difference.h"
#include "common/image/files.h"
#include "common/stage/guard.h"

#include <cstdint>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

namespace rasterlab {
namespace {

constexpr const char* description =
    "Compares two pictures, channel by channel, and says what kind of wrong the first one is.\n"
    "PNG, JPEG, TGA, PBM, PGM, PPM (text, binary, 8 and 16 bit) and PFM (float), in any mixture:\n"
    "grey is compared as colour, and the coarser numbers are brought to the range of the finer.\n";

constexpr const char* footer =
    "Without limits every pixel must be the same. With one of the two limits the other is open;\n"
    "with both, at most so many pixels may differ, and none of them by more than the difference.\n"
    "Exit status: 0 the same within the limits; 1 different, or a file cannot be read or written;\n"
    "2 bad usage.";

struct Settings {
  std::filesystem::path actual;
  std::filesystem::path expected;
  std::optional<double> max_difference;
  std::optional<std::int64_t> total_pixels;
  int neighbor_radius = 0;
  std::filesystem::path out;
  bool quiet = false;
};

void add_flags(CLI::App& app, Settings& settings) {
  app.add_option("A", settings.actual, "The picture to judge")->required()->type_name("FILE");
  app.add_option("B", settings.expected, "The picture it should be")->required()->type_name("FILE");
  app.add_option(
         "--max-difference", settings.max_difference,
         "Largest difference of a channel: of 255 for 8 bit, of 65535 for 16 bit, the values "
         "themselves for floats")
      ->type_name("N");
  app.add_option("--total-pixels", settings.total_pixels, "How many pixels may differ")
      ->type_name("N");
  app.add_option(
         "--neighbor-radius", settings.neighbor_radius,
         "A pixel counts as the same when its like is at most so many pixels away (default 0)")
      ->type_name("N");
  app.add_option("--out", settings.out,
                 "Write the difference as a picture: black where nothing differs, else amplified")
      ->type_name("FILE");
  app.add_flag("-q,--quiet", settings.quiet, "Say nothing: only the exit status tells");
}

void check_not_negative(const char* flag, double value) {
  if (value >= 0) return;
  throw UsageError(std::string(flag) + " " + std::to_string(value) + ": expected 0 or more");
}

void check(const Settings& settings) {
  check_not_negative("--max-difference", settings.max_difference.value_or(0));
  check_not_negative("--total-pixels", static_cast<double>(settings.total_pixels.value_or(0)));
  check_not_negative("--neighbor-radius", settings.neighbor_radius);
}

Tolerance tolerance(const Settings& settings) {
  if (!settings.max_difference && !settings.total_pixels) {
    return {.neighbor_radius = settings.neighbor_radius};
  }
  return {.max_difference = settings.max_difference.value_or(Tolerance::any_difference),
          .total_pixels = settings.total_pixels ? static_cast<std::size_t>(*settings.total_pixels)
                                                : Tolerance::any_number,
          .neighbor_radius = settings.neighbor_radius};
}

int compare(const Settings& settings) {
  const AnyImage actual = read_any_image(settings.actual);
  const AnyImage expected = read_any_image(settings.expected);
  const Difference difference = compare_images(actual, expected, tolerance(settings));
  if (!settings.out.empty()) write_image(settings.out, difference_picture(actual, expected));
  if (!settings.quiet) {
    if (!difference.matches) std::cout << describe(difference);
    if (!settings.out.empty()) std::cout << "wrote " << settings.out.string() << "\n";
  }
  return difference.matches ? 0 : 1;
}

int run(int argc, char** argv) {
  Settings settings;
  CLI::App app(description, "imgdiff");
  app.footer(footer);
  add_flags(app, settings);
  if (!parse_command_line(app, argc, argv)) return 0;
  check(settings);
  return compare(settings);
}

}  // namespace
}  // namespace rasterlab

int main(int argc, char** argv) {
  return rasterlab::run_guarded("imgdiff", [&] { return rasterlab::run(argc, argv); });
}
