// Exercise 07.5.
#include "common/shaders/culled.h"

#include "grading/probes/made_up_point.h"

namespace rasterlab::grading {

void cull_scene(SceneInputs& scene, Results& results) {
  const std::string names[] = {"none", "back", "front"};
  for (const Cull cull : {Cull::none, Cull::back, Cull::front}) {
    std::vector<double> seen;
    for (const bool front : {false, true}) {
      for (const bool discarded : {false, true}) {
        const Fragment<float> fragment =
            cull_fragment(Fragment<float>{scene.color(), discarded}, front, cull);
        seen.push_back(fragment.discarded ? 0 : 1);
        add(seen, fragment.color);
      }
    }
    results.numbers("1 for drawn, and the colour, where " + names[static_cast<std::size_t>(cull)] +
                        " is culled",
                    seen);
  }
}

}  // namespace rasterlab::grading
