#include "grading/probes/probe.h"

#include "common/image/check.h"

#include <cstdio>
#include <cstdlib>
#include <new>

namespace rasterlab::grading {

int run_probe(int argc, char** argv, const std::map<std::string, Probe>& probes) {
  if (argc == 2 && std::string(argv[1]) == "--list") {
    for (const auto& [exercise, probe] : probes) std::printf("%s\n", exercise.c_str());
    return 0;
  }
  if (argc != 4 || !probes.contains(argv[1])) {
    std::fputs("usage: probe EXERCISE SCENE OUT_FILE\n", stderr);
    return 2;
  }
  SceneInputs scene(std::strtoull(argv[2], nullptr, 10));
  Results results;
  try {
    probes.at(argv[1])(scene, results);
  } catch (const std::bad_alloc&) {
    return 3;
  } catch (const std::exception& error) {
    results.text("exception", error.what());
  }
  results.write(argv[3]);
  return 0;
}

}  // namespace rasterlab::grading
