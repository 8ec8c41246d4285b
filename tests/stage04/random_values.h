// Random input that is the same in every run.
#pragma once

#include <random>

#include <Eigen/Dense>

namespace rasterlab {

class RandomValues {
 public:
  explicit RandomValues(unsigned seed) : engine_(seed) {}

  float number(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(engine_);
  }
  int index(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }
  Eigen::Vector3f vector(float extent) {
    const float x = number(-extent, extent);
    const float y = number(-extent, extent);
    return {x, y, number(-extent, extent)};
  }
  Eigen::Vector3f direction() {
    Eigen::Vector3f result = vector(1);
    while (result.norm() < 0.1F || result.norm() > 1) result = vector(1);
    return result.normalized();
  }
  Eigen::Matrix3f matrix(float extent) {
    Eigen::Matrix3f result;
    for (int i = 0; i < 9; ++i) result(i) = number(-extent, extent);
    return result;
  }

 private:
  std::mt19937 engine_;
};

}  // namespace rasterlab
