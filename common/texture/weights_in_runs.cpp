#include "common/image/check.h"
#include "common/texture/perspective_weights.h"

#include <algorithm>

namespace rasterlab {
namespace {

void weights_in_runs(const PerspectiveRow& row, std::size_t run_length,
                     std::span<Eigen::Vector3d> on_triangle) {
  // <solution>
  if (row.weights.empty()) return;
  const std::size_t last = row.weights.size() - 1;
  on_triangle[0] = exact_weights(row.weights[0], row.inverse_w);
  for (std::size_t begin = 0; begin < last; begin += run_length) {
    const std::size_t end = std::min(begin + run_length, last);
    on_triangle[end] = exact_weights(row.weights[end], row.inverse_w);
    const Eigen::Vector3d step =
        (on_triangle[end] - on_triangle[begin]) / static_cast<double>(end - begin);
    for (std::size_t x = begin + 1; x < end; ++x) on_triangle[x] = on_triangle[x - 1] + step;
  }
  // <starter> throw NotWritten("06.3", row, run_length, on_triangle);
  // </solution>
}

}  // namespace

void weights_in_runs_of_16(const PerspectiveRow& row, std::span<Eigen::Vector3d> on_triangle) {
  weights_in_runs(row, 16, on_triangle);
}

void weights_in_runs_of_8(const PerspectiveRow& row, std::span<Eigen::Vector3d> on_triangle) {
  weights_in_runs(row, 8, on_triangle);
}

}  // namespace rasterlab
