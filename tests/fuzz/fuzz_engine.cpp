// Bytes are floats: triangles in clip space, or a triangle and a matrix that takes it there. The
// engine must keep its promises for any of them.
#include "tests/fuzz/fuzz_target.h"
#include "tests/stress/family.h"

#include <cstring>

void rasterlab::fuzz(std::string_view bytes) {
  static const stress::Family& triangles = stress::family_named("special_floats");
  static const stress::Family& mesh_and_matrix = stress::family_named("special_meshes");
  constexpr std::size_t of_mesh_and_matrix = 25;
  stress::Numbers numbers;
  for (; bytes.size() >= sizeof(float) && numbers.size() < of_mesh_and_matrix;
       bytes.remove_prefix(sizeof(float))) {
    float number = 0;
    std::memcpy(&number, bytes.data(), sizeof number);
    numbers.push_back(number);
  }
  const bool with_matrix = numbers.size() == of_mesh_and_matrix;
  const stress::Verdict verdict = stress::check(with_matrix ? mesh_and_matrix : triangles, numbers);
  if (verdict.violations > 0) std::cerr << verdict.first << "\n";
  require(verdict.violations == 0, "the engine's, for any float in any component");
}
