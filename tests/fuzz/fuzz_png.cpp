#include "tests/fuzz/fuzz_picture.h"

void rasterlab::fuzz(std::string_view bytes) {
  fuzz_picture(bytes, ".png");
}
