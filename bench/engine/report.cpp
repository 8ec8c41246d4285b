#include "bench/engine/report.h"

#include "bench/support/provenance.h"
#include "bench/support/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace rasterlab::bench {

namespace {

constexpr double ratio_target = 5;
constexpr double mean_target = 10;

double geometric_mean(const std::vector<Result>& results, int threads,
                      double (Result::*ratio)() const = &Result::ratio) {
  double sum = 0;
  int count = 0;
  for (const Result& r : results) {
    if (r.threads != threads || r.peer.empty()) continue;
    sum += std::log((r.*ratio)());
    ++count;
  }
  return count == 0 ? 0 : std::exp(sum / count);
}

std::vector<int> thread_counts(const std::vector<Result>& results) {
  std::vector<int> counts;
  for (const Result& r : results) counts.push_back(r.threads);
  std::sort(counts.begin(), counts.end());
  counts.erase(std::unique(counts.begin(), counts.end()), counts.end());
  return counts;
}

std::string format(const char* pattern, double value) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), pattern, value);
  return buffer.data();
}

/// A row's texts: the same on the terminal and on the page.
std::vector<std::string> cells(const Result& r) {
  const double ours = median(r.ours);
  const double peer = median(r.peer);
  return {r.scene,
          r.shading,
          std::to_string(r.threads),
          format("%.2f", ours),
          format("%.2f", smallest(r.ours)),
          format("%.0f%%", spread(r.ours) * 100),
          format("%.2f", peer),
          format("%.2f", smallest(r.peer)),
          format("%.0f%%", spread(r.peer) * 100),
          format("%.1f", r.ratio()),
          format("%.2f", median(r.ours_cpu)),
          format("%.2f", median(r.peer_cpu)),
          format("%.1f", r.cpu_ratio()),
          format("%.0f", r.triangles / ours / 1000),
          format("%.0f", r.pixels / ours / 1000),
          format("%.1f", r.coverage_difference),
          format("%.1f", r.color_difference),
          format("%.0f", r.peak_memory_mb)};
}

/// One sentence per result whose colours differ in too many pixels.
std::vector<std::string> remarks(const std::vector<Result>& results) {
  std::vector<std::string> sentences;
  for (const Result& r : results) {
    if (r.color_difference <= difference_limit) continue;
    sentences.push_back(r.scene + ", " + r.shading + ", " + std::to_string(r.threads) +
                        " thread(s): colours differ in " + format("%.1f", r.color_difference) +
                        " pixels per million, in " + format("%.1f", r.exact_color_difference) +
                        " where llvmpipe weighs texels with floats instead of 8 bits.");
  }
  return sentences;
}

struct Column {
  const char* title;
  int width;
};
constexpr std::array<Column, 18> columns = {{{"scene", -20},
                                             {"shading", -20},
                                             {"threads", 7},
                                             {"ours ms", 9},
                                             {"min", 8},
                                             {"spread", 7},
                                             {"peer ms", 9},
                                             {"min", 8},
                                             {"spread", 7},
                                             {"ratio", 7},
                                             {"CPU ours", 9},
                                             {"CPU peer", 9},
                                             {"CPU ratio", 9},
                                             {"Mtri/s", 7},
                                             {"Mpix/s", 7},
                                             {"coverage", 9},
                                             {"colour", 8},
                                             {"peak MB", 8}}};

}  // namespace

double Result::ratio() const {
  return ours.empty() || peer.empty() ? 0 : median(peer) / median(ours);
}

double Result::cpu_ratio() const {
  return ours_cpu.empty() || peer_cpu.empty() ? 0 : median(peer_cpu) / median(ours_cpu);
}

nlohmann::json to_json(const std::vector<Result>& results) {
  nlohmann::json array = nlohmann::json::array();
  for (const Result& r : results) {
    array.push_back({{"scene", r.scene},
                     {"shading", r.shading},
                     {"threads", r.threads},
                     {"ours_ms", median(r.ours)},
                     {"peer_ms", median(r.peer)},
                     {"ratio", r.ratio()},
                     {"commit", commit()},
                     {"machine", machine()},
                     {"ours_samples_ms", r.ours},
                     {"peer_samples_ms", r.peer},
                     {"ours_cpu_ms", median(r.ours_cpu)},
                     {"peer_cpu_ms", median(r.peer_cpu)},
                     {"cpu_ratio", r.cpu_ratio()},
                     {"ours_cpu_samples_ms", r.ours_cpu},
                     {"peer_cpu_samples_ms", r.peer_cpu},
                     {"triangles", r.triangles},
                     {"covered_pixels", r.pixels},
                     {"coverage_difference_per_million", r.coverage_difference},
                     {"our_coverage_error_per_million", r.our_error},
                     {"peer_coverage_error_per_million", r.peer_error},
                     {"color_difference_per_million", r.color_difference},
                     {"exact_color_difference_per_million", r.exact_color_difference},
                     {"prepare_ms", r.prepare_ms},
                     {"peak_memory_mb", r.peak_memory_mb}});
  }
  return array;
}

std::vector<Result> from_json(const nlohmann::json& json) {
  std::vector<Result> results;
  for (const nlohmann::json& o : json) {
    Result r;
    r.scene = o["scene"];
    r.shading = o["shading"];
    r.threads = o["threads"];
    r.ours = o["ours_samples_ms"].get<std::vector<double>>();
    r.peer = o["peer_samples_ms"].get<std::vector<double>>();
    r.ours_cpu = o["ours_cpu_samples_ms"].get<std::vector<double>>();
    r.peer_cpu = o["peer_cpu_samples_ms"].get<std::vector<double>>();
    r.triangles = o["triangles"];
    r.pixels = o["covered_pixels"];
    r.coverage_difference = o["coverage_difference_per_million"];
    r.our_error = o["our_coverage_error_per_million"];
    r.peer_error = o["peer_coverage_error_per_million"];
    r.color_difference = o["color_difference_per_million"];
    r.exact_color_difference = o["exact_color_difference_per_million"];
    r.prepare_ms = o["prepare_ms"];
    r.peak_memory_mb = o["peak_memory_mb"];
    results.push_back(std::move(r));
  }
  return results;
}

std::string to_html(const std::vector<Result>& results) {
  std::ostringstream page;
  page
      << "<!doctype html><meta charset=\"utf-8\"><title>RasterLab engine against llvmpipe</title>"
         "<style>body{font:15px system-ui;margin:2em}td,th{padding:2px 10px;text-align:right}"
         "td:nth-child(-n+2),th:nth-child(-n+2){text-align:left}tr:nth-child(even){background:"
         "#f3f3f3}.short{color:#b00;font-weight:bold}</style>"
         "<h1>RasterLab's engine against llvmpipe</h1><p>Commit "
      << commit() << ", " << machine()
      << ". Milliseconds a frame: median and minimum; spread is the distance between the quartiles "
         "over the median; CPU is the time of all threads of a side together, which a busy machine "
         "disturbs less. Coverage: pixels per million where one side drew and the other did not; "
         "colour: where both did and differ by more than 3 codes. Ratios below "
      << ratio_target << " are marked.</p>";
  for (const int threads : thread_counts(results)) {
    page << "<p>" << threads << " thread(s): geometric mean of the ratios "
         << format("%.1f", geometric_mean(results, threads)) << ", aim " << mean_target << "</p>";
  }
  page << "<table><tr>";
  for (const Column& column : columns) page << "<th>" << column.title << "</th>";
  page << "</tr>\n";
  for (const Result& r : results) {
    page << (r.ratio() < ratio_target ? "<tr class=\"short\">" : "<tr>");
    for (const std::string& cell : cells(r)) page << "<td>" << cell << "</td>";
    page << "</tr>\n";
  }
  page << "</table>\n";
  for (const std::string& remark : remarks(results)) page << "<p>" << remark << "</p>\n";
  return page.str();
}

void print_header() {
  for (const Column& column : columns) std::printf("%*s ", column.width, column.title);
  std::printf("\n");
}

void print_row(const Result& result) {
  const std::vector<std::string> texts = cells(result);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    std::printf("%*s ", columns[i].width, texts[i].c_str());
  }
  std::printf("\n");
  if (result.coverage_difference > difference_limit) {
    std::printf("  coverage unlike exact arithmetic, pixels per million: ours %.1f, peer %.1f\n",
                result.our_error, result.peer_error);
  }
  std::fflush(stdout);
}

void print_summary(const std::vector<Result>& results) {
  for (const std::string& remark : remarks(results)) std::printf("%s\n", remark.c_str());
  for (const int threads : thread_counts(results)) {
    int below = 0;
    int count = 0;
    for (const Result& r : results) {
      if (r.threads != threads) continue;
      ++count;
      below += r.ratio() < ratio_target ? 1 : 0;
    }
    std::printf(
        "%d thread(s): geometric mean of the ratios %.1f (aim %.0f; of CPU time %.1f), %d of %d "
        "below "
        "%.0f\n",
        threads, geometric_mean(results, threads), mean_target,
        geometric_mean(results, threads, &Result::cpu_ratio), below, count, ratio_target);
  }
}

}  // namespace rasterlab::bench
