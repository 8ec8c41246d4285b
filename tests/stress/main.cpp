// Draws adversarial cases without end, and says what breaks a contract.
#include "common/image/bytes.h"
#include "common/image/check.h"
#include "common/stage/guard.h"

#include "tests/stress/family.h"

#include <chrono>
#include <cinttypes>
#include <cstdio>
#include <iostream>
#include <optional>
#include <random>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace rasterlab::stress {
namespace {

using Clock = std::chrono::steady_clock;

struct Settings {
  double seconds = 60;
  std::optional<std::uint64_t> seed;
  std::vector<std::string> only;
  std::filesystem::path replay;
  std::filesystem::path out = "out/stress";
  std::filesystem::path json;
  bool list = false;
};

/// What a family has come to so far.
struct Total {
  const Family* family;
  std::uint64_t cases = 0;
  std::uint64_t failed_cases = 0;
  Verdict verdict;

  void add(const Verdict& one) {
    ++cases;
    failed_cases += one.violations > 0 ? 1 : 0;
    verdict.add(one);
  }
};

std::vector<Total> chosen_families(const Settings& settings) {
  std::vector<Total> chosen;
  if (settings.only.empty()) {
    for (const Family& family : families()) chosen.push_back({&family, 0, 0, {}});
  }
  for (const std::string& name : settings.only) chosen.push_back({&family_named(name), 0, 0, {}});
  return chosen;
}

/// A family's first failing case is made simpler and saved; of further ones only the number is
/// told.
void report_failure(const Settings& settings, const Family& family, const Numbers& numbers,
                    std::uint64_t index) {
  const Numbers simplest = shrink(family, numbers);
  const Verdict verdict = check(family, simplest);
  std::filesystem::create_directories(settings.out);
  const std::filesystem::path path = settings.out / (family.name + ".json");
  save_case(path, family, simplest, verdict);
  std::cerr << "stress: " << family.name << ", case " << index << ": " << verdict.first << " ("
            << simplest.size() << " numbers; repeat with --replay " << path.string() << ")\n";
}

void show_progress(const std::vector<Total>& totals, double seconds) {
  if (isatty(STDERR_FILENO) == 0) return;
  std::int64_t samples = 0;
  for (const Total& total : totals) samples += total.verdict.samples;
  std::fprintf(stderr, "\r%4.0f s, %.3g samples ", seconds, static_cast<double>(samples));
}

/// Families take turns of a tenth of a second.
void run(const Settings& settings, std::uint64_t seed, std::vector<Total>& totals) {
  const Clock::time_point start = Clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  while (elapsed() < settings.seconds) {
    for (Total& total : totals) {
      const double turn_ends = std::min(elapsed() + 0.1, settings.seconds);
      do {
        const Numbers numbers = draw(*total.family, seed, total.cases);
        const Verdict verdict = check(*total.family, numbers);
        if (verdict.violations > 0 && total.failed_cases == 0) {
          report_failure(settings, *total.family, numbers, total.cases);
        }
        total.add(verdict);
      } while (elapsed() < turn_ends);
    }
    show_progress(totals, elapsed());
  }
  if (isatty(STDERR_FILENO) != 0) std::fputc('\n', stderr);
}

/// Approximate rungs promise nothing; what they do in the same cases is told all the same.
void print_rungs(const std::vector<Total>& totals) {
  const char* heading = "\napproximate rungs  rung                 wrong per million samples\n";
  for (const Total& total : totals) {
    for (const auto& [rung, error] : total.verdict.rungs) {
      std::printf("%s%-17s  %-20s %25.1f\n", heading, total.family->name.c_str(), rung.c_str(),
                  error.per_million());
      heading = "";
    }
  }
}

void print(const std::vector<Total>& totals) {
  std::printf("%-17s %10s %14s %11s %12s\n", "family", "cases", "samples", "violations",
              "worst/limit");
  Total sum{nullptr, 0, 0, {}};
  for (const Total& total : totals) {
    std::printf("%-17s %10" PRIu64 " %14" PRId64 " %11" PRId64, total.family->name.c_str(),
                total.cases, total.verdict.samples, total.verdict.violations);
    if (total.verdict.worst_error > 0) std::printf(" %12.3f", total.verdict.worst_error);
    std::printf("\n");
    sum.cases += total.cases;
    sum.verdict.samples += total.verdict.samples;
    sum.verdict.violations += total.verdict.violations;
  }
  std::printf("%-17s %10" PRIu64 " %14" PRId64 " %11" PRId64 "\n", "all", sum.cases,
              sum.verdict.samples, sum.verdict.violations);
  print_rungs(totals);
}

void write_json(const std::filesystem::path& path, std::uint64_t seed,
                const std::vector<Total>& totals) {
  nlohmann::json list = nlohmann::json::array();
  for (const Total& total : totals) {
    nlohmann::json rungs = nlohmann::json::object();
    for (const auto& [rung, error] : total.verdict.rungs) rungs[rung] = error.per_million();
    list.push_back({{"family", total.family->name},
                    {"contract", total.family->contract},
                    {"seed", seed},
                    {"cases", total.cases},
                    {"samples", total.verdict.samples},
                    {"violations", total.verdict.violations},
                    {"first_violation", total.verdict.first},
                    {"worst_over_limit", total.verdict.worst_error},
                    {"wrong_per_million_of_approximate_rungs", rungs}});
  }
  write_file(path, list.dump(1) + "\n");
}

int replay(const std::filesystem::path& path) {
  const SavedCase saved = load_case(path);
  const Verdict verdict = check(*saved.family, saved.numbers);
  std::printf("%s: %s\n%" PRId64 " samples, %" PRId64 " violations%s%s\n",
              saved.family->name.c_str(), saved.family->contract.c_str(), verdict.samples,
              verdict.violations, verdict.first.empty() ? "" : ": ", verdict.first.c_str());
  return verdict.violations == 0 ? 0 : 1;
}

int run_all(const Settings& settings) {
  if (settings.list) {
    for (const Family& family : families()) {
      std::printf("%-17s %s\n", family.name.c_str(), family.contract.c_str());
    }
    return 0;
  }
  if (!settings.replay.empty()) return replay(settings.replay);
  const std::uint64_t seed = settings.seed ? *settings.seed : std::random_device()();
  std::printf("seed %" PRIu64 "\n", seed);
  std::fflush(stdout);
  std::vector<Total> totals = chosen_families(settings);
  run(settings, seed, totals);
  print(totals);
  if (!settings.json.empty()) write_json(settings.json, seed, totals);
  const bool broken = std::any_of(totals.begin(), totals.end(),
                                  [](const Total& total) { return total.verdict.violations > 0; });
  return broken ? 1 : 0;
}

void add_flags(CLI::App& app, Settings& settings) {
  app.add_option("--seconds", settings.seconds, "how long to go on (default: 60)")
      ->type_name("S")
      ->check(CLI::PositiveNumber);
  app.add_option("--seed", settings.seed, "draw the cases of that seed (default: a random one)")
      ->type_name("N");
  app.add_option("--family", settings.only, "only these families")->type_name("NAME");
  app.add_option("--replay", settings.replay, "check one saved case")->type_name("FILE");
  app.add_option("--out", settings.out, "where failing cases are saved (default: out/stress)")
      ->type_name("DIR");
  app.add_option("--json", settings.json, "write what came out as JSON")->type_name("FILE");
  app.add_flag("--list", settings.list, "list the families, each with its contract");
}

int run_command(int argc, char** argv) {
  Settings settings;
  CLI::App app(
      "Draws adversarial cases until the time is up, and holds each against its family's oracle. A "
      "case that breaks its contract is made simpler and saved.",
      "stress");
  add_flags(app, settings);
  if (!parse_command_line(app, argc, argv)) return 0;
  return run_all(settings);
}

}  // namespace
}  // namespace rasterlab::stress

int main(int argc, char** argv) {
  return rasterlab::run_guarded("stress",
                                [&] { return rasterlab::stress::run_command(argc, argv); });
}
