#include "common/projection/scene.h"

#include "tests/fuzz/fuzz_target.h"

void rasterlab::fuzz(std::string_view bytes) {
  const Scene scene = read_scene(as_file(bytes, ".scene"));
  require(scene.width > 0 && scene.height > 0, "a scene's picture has pixels");
  require(scene.eye.allFinite() && scene.look_at.allFinite() && scene.up.allFinite(),
          "a scene's camera is finite");
}
