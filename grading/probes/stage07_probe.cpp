// Runs the exercises of stage 07: each in a file of stage07/ that has its answer's name.
#include "grading/probes/probe.h"

namespace rasterlab::grading {

void loop_scene(SceneInputs& scene, Results& results);
void surface_scene(SceneInputs& scene, Results& results);
void quantize_scene(SceneInputs& scene, Results& results);
void tangent_space_scene(SceneInputs& scene, Results& results);
void cull_scene(SceneInputs& scene, Results& results);
void highlights_scene(SceneInputs& scene, Results& results);
void normal_scene(SceneInputs& scene, Results& results);

}  // namespace rasterlab::grading

int main(int argc, char** argv) {
  using namespace rasterlab::grading;
  return run_probe(argc, argv,
                   {{"07.1", loop_scene},
                    {"07.2", surface_scene},
                    {"07.3", quantize_scene},
                    {"07.4", tangent_space_scene},
                    {"07.5", cull_scene},
                    {"07.6", highlights_scene},
                    {"07.8", normal_scene}});
}
