// What the probes share. A probe is linked with a student's file and run in a jail:
//
//   stage01_probe EXERCISE SCENE OUT_FILE
//
// SCENE 0 is the course's own example; any other number seeds the exercise's inputs.
#pragma once

#include "grading/judge/records.h"

#include <cstdint>
#include <functional>
#include <map>
#include <random>
#include <string>

namespace rasterlab::grading {

/// The inputs of a scene, the same on every machine: the standard fixes mt19937_64's numbers but
/// not those of its distributions.
class SceneInputs {
 public:
  explicit SceneInputs(std::uint64_t number) : number_(number), generator_(number) {}

  /// Whether this is the course's own example.
  bool example() const { return number_ == 0; }
  std::uint64_t number() const { return number_; }

  /// A whole number in [low, high].
  int whole(int low, int high) {
    const auto span = static_cast<std::uint64_t>(high - low) + 1;
    return low + static_cast<int>(generator_() % span);
  }
  /// A multiple of 2⁻²⁴ in [0, 1) scaled to [low, high).
  float real(float low, float high) {
    return low + static_cast<float>(generator_() >> 40U) / 16777216.0F * (high - low);
  }
  Eigen::Vector2i pixel(int width, int height) {
    const int x = whole(0, width - 1);
    return {x, whole(0, height - 1)};
  }
  Color color() {
    const float r = real(0, 1);
    const float g = real(0, 1);
    return {r, g, real(0, 1)};
  }
  /// Each component in [low, high).
  Eigen::Vector3f vector(float low, float high) {
    const float x = real(low, high);
    const float y = real(low, high);
    return {x, y, real(low, high)};
  }
  /// A unit vector.
  Eigen::Vector3f direction() {
    return (vector(-1, 1) + Eigen::Vector3f(0, 0, 0.01F)).normalized();
  }

 private:
  std::uint64_t number_;
  std::mt19937_64 generator_;
};

using Probe = std::function<void(SceneInputs&, Results&)>;

/// Runs one exercise on one scene and writes its results. What the exercise throws becomes a
/// result: a text named "exception". Returns the exit status: 0, 3 when memory ran out, 2 for bad
/// usage.
int run_probe(int argc, char** argv, const std::map<std::string, Probe>& probes);

}  // namespace rasterlab::grading
