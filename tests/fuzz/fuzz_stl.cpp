#include "tests/fuzz/fuzz_mesh.h"

void rasterlab::fuzz(std::string_view bytes) {
  fuzz_mesh(bytes, "fuzz.stl");
}
