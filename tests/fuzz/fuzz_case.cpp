// Saved cases of ./lab stress.
#include "tests/fuzz/fuzz_target.h"
#include "tests/stress/family.h"

void rasterlab::fuzz(std::string_view bytes) {
  const stress::SavedCase saved = stress::load_case(as_file(bytes, ".json"));
  require(saved.family != nullptr, "a case belongs to a family");
}
