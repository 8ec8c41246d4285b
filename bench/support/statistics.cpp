#include "bench/support/statistics.h"

#include <algorithm>
#include <cstddef>

namespace rasterlab::bench {

double median(std::vector<double> samples) {
  if (samples.empty()) return 0;
  const std::size_t middle = samples.size() / 2;
  std::nth_element(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(middle),
                   samples.end());
  return samples[middle];
}

double smallest(const std::vector<double>& samples) {
  return samples.empty() ? 0 : *std::min_element(samples.begin(), samples.end());
}

double spread(std::vector<double> samples) {
  if (samples.size() < 4) return 0;
  const double middle = median(samples);
  std::sort(samples.begin(), samples.end());
  return (samples[samples.size() * 3 / 4] - samples[samples.size() / 4]) / middle;
}

}  // namespace rasterlab::bench
