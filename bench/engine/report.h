// What was measured, on a terminal, as JSON and as a page.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace rasterlab::bench {

/// Pixels per million that may differ between two sides, in coverage or in colour, before it is
/// asked who is right.
inline constexpr double difference_limit = 20;

struct Result {
  std::string scene;
  std::string shading;
  int threads = 0;
  std::vector<double> ours;  ///< milliseconds, one per repetition
  std::vector<double> peer;
  std::vector<double> ours_cpu;  ///< milliseconds of all threads together
  std::vector<double> peer_cpu;
  double triangles = 0;
  double pixels = 0;               ///< covered
  double coverage_difference = 0;  ///< pixels per million
  double our_error = 0;  ///< where sides disagree: pixels per million unlike exact_coverage()
  double peer_error = 0;
  double color_difference = 0;  ///< pixels per million that differ by more than 3 codes
  /// Where those are too many: how many when llvmpipe weighs texels with floats, not with 8 bits.
  double exact_color_difference = 0;
  double prepare_ms = 0;
  double peak_memory_mb = 0;

  double ratio() const;
  double cpu_ratio() const;
};

/// One object per result, with at least scene, shading, threads, ours_ms, peer_ms, ratio, commit.
nlohmann::json to_json(const std::vector<Result>& results);
std::vector<Result> from_json(const nlohmann::json& json);

std::string to_html(const std::vector<Result>& results);

void print_header();
void print_row(const Result& result);
/// Geometric means, and what falls short.
void print_summary(const std::vector<Result>& results);

}  // namespace rasterlab::bench
