#include "common/stage/manifest.h"

#include "tests/fuzz/fuzz_target.h"

void rasterlab::fuzz(std::string_view bytes) {
  parse_manifest(bytes);
}
