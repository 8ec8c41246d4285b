// Bytes are triangles in clip space: the engine must keep its promises for any of them.
#include "tests/fuzz/fuzz_target.h"
#include "tests/stress/family.h"

#include <cstring>

void rasterlab::fuzz(std::string_view bytes) {
  static const stress::Family& family = stress::family_named("special_floats");
  constexpr std::size_t most = 48;
  stress::Numbers numbers;
  for (; bytes.size() >= sizeof(float) && numbers.size() < most;
       bytes.remove_prefix(sizeof(float))) {
    float number = 0;
    std::memcpy(&number, bytes.data(), sizeof number);
    numbers.push_back(number);
  }
  const stress::Verdict verdict = stress::check(family, numbers);
  if (verdict.violations > 0) std::cerr << verdict.first << "\n";
  require(verdict.violations == 0, "the engine's, for any float in any component");
}
