// bench_03_zbuffer: the ladder of exercise 03.5, and forms of depth.
#include "common/zbuffer/visibility_faults.h"

#include "bench/support/program.h"
#include "bench/zbuffer/depth_formats.h"

#include <numeric>

namespace rasterlab::bench {
namespace {

/// A rung's work is to see all of these.
TimedLadder visibility_ladder_on(const std::string& input,
                                 const std::vector<VisibilityScene>& scenes, double pixels,
                                 const std::function<Errors(VisibilityFunction)>& errors) {
  TimedLadder ladder{.name = "03.5 visibility, " + input,
                     .stage = "03",
                     .unit = "covered sample",
                     .units = pixels,
                     .error = "wrong per million",
                     .rungs = {}};
  for (const VisibilityRung& rung : visibility_ladder) {
    ladder.rungs.push_back({.name = rung.name,
                            .fault = rung.known_fault,
                            .work =
                                [scenes, seen = rung.seen] {
                                  for (const VisibilityScene& scene : scenes) seen(scene);
                                },
                            .errors = errors(rung.seen)});
  }
  return ladder;
}

/// In how many pixels the triangles of a scene cover their samples, one upon the other.
double covered_samples(const VisibilityScene& scene) {
  double samples = 0;
  for (const VisibilityTriangle& triangle : scene.triangles) {
    VisibilityScene alone = scene;
    alone.triangles = {triangle};
    const VisibleTriangles seen = seen_by_draw_order(alone);
    for (const std::int32_t shown : seen.pixels()) samples += shown < 0 ? 0 : 1;
  }
  return samples;
}

TimedLadder piercing() {
  const VisibilityScene scene = piercing_triangles();
  return visibility_ladder_on(
      "30 triangles that pierce each other", {scene}, covered_samples(scene),
      [&scene](VisibilityFunction seen) -> Errors {
        const VisibilityFaults faults = visibility_faults(seen(scene), scene);
        return {{"wrong per million",
                 1e6 * static_cast<double>(faults.wrong) / static_cast<double>(faults.covered)}};
      });
}

/// Pairs one of which is nearer everywhere, by a part of its distance; over five decades of it.
TimedLadder pairs(double delta, const std::string& name) {
  const std::vector<double> distances = {1, 10, 100, 1000, 10000};
  std::vector<VisibilityScene> scenes;
  double samples = 0;
  for (const double distance : distances) {
    for (const bool nearer_last : {false, true}) {
      scenes.push_back(nearly_coplanar_pair(distance, delta, nearer_last));
      samples += covered_samples(scenes.back());
    }
  }
  return visibility_ladder_on(
      "pairs " + name + " of their distance apart", scenes, samples,
      [&](VisibilityFunction seen) -> Errors {
        Errors errors = {{"wrong per million", 0}};
        for (const double distance : distances) {
          const double wrong = 1e6 * wrong_share_of_pair(seen, distance, delta);
          errors.front().second += wrong / static_cast<double>(distances.size());
          errors.emplace_back("at " + std::to_string(static_cast<int>(distance)), wrong);
        }
        return errors;
      });
}

std::vector<MakeLadder> ladders() {
  std::vector<MakeLadder> all = {&piercing};
  for (const auto& [delta, name] : {std::pair{1e-2, "1e-2"},
                                    {1e-3, "1e-3"},
                                    {1e-4, "1e-4"},
                                    {1e-5, "1e-5"},
                                    {1e-6, "1e-6"},
                                    {1e-7, "1e-7"}}) {
    all.emplace_back([delta = delta, name = std::string(name)] { return pairs(delta, name); });
  }
  for (const double apart : {1e-2, 1e-4, 1e-6, 1e-7})
    all.emplace_back([apart] { return depth_format_ladder(apart); });
  return all;
}

}  // namespace
}  // namespace rasterlab::bench

int main(int argc, char** argv) {
  using namespace rasterlab::bench;
  return run_program(
      argc, argv,
      {.name = "bench_03_zbuffer",
       .description = "Stage 03: time and error of every way to see what is in front",
       .ladders = ladders()});
}
