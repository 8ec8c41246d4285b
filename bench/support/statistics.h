// What many samples of one time say.
#pragma once

#include <vector>

namespace rasterlab::bench {

/// 0 for none.
double median(std::vector<double> samples);
double smallest(const std::vector<double>& samples);

/// The distance between the quartiles as a part of the median; 0 for fewer than four samples.
double spread(std::vector<double> samples);

}  // namespace rasterlab::bench
