#include "bench/support/measure.h"

#include <map>
#include <string>

#include <benchmark/benchmark.h>

namespace rasterlab::bench {
namespace {

/// Keeps the samples instead of printing them.
class Samples : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }

  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      of_[run.run_name.function_name].push_back(run.GetAdjustedCPUTime());
    }
  }

  const std::vector<double>& of(const std::string& name) { return of_[name]; }

 private:
  std::map<std::string, std::vector<double>> of_;
};

void set_flags(const Effort& effort) {
  std::vector<std::string> flags = {"bench",
                                    "--benchmark_repetitions=" + std::to_string(effort.repetitions),
                                    "--benchmark_min_time=" + std::to_string(effort.seconds),
                                    "--benchmark_enable_random_interleaving=true"};
  std::vector<char*> arguments;
  for (std::string& flag : flags) arguments.push_back(flag.data());
  auto count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
}

}  // namespace

std::vector<std::vector<double>> measure(const TimedLadder& ladder, const Effort& effort) {
  set_flags(effort);
  benchmark::ClearRegisteredBenchmarks();
  for (const TimedRung& rung : ladder.rungs) {
    benchmark::RegisterBenchmark(rung.name.c_str(), [&rung](benchmark::State& state) {
      for ([[maybe_unused]] const auto& iteration : state) rung.work();
    });
  }
  Samples samples;
  benchmark::RunSpecifiedBenchmarks(&samples);
  std::vector<std::vector<double>> result;
  for (const TimedRung& rung : ladder.rungs) {
    result.push_back(samples.of(rung.name));
    for (double& nanoseconds : result.back()) nanoseconds /= ladder.units;
  }
  return result;
}

}  // namespace rasterlab::bench
