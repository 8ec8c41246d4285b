#include "tests/support/places.h"

namespace rasterlab {

std::filesystem::path source_folder() {
  return RASTERLAB_SOURCE;
}

std::filesystem::path binary_folder() {
  return RASTERLAB_BINARY;
}

std::filesystem::path programs_folder() {
  return RASTERLAB_PROGRAMS;
}

std::filesystem::path test_models_folder() {
  return RASTERLAB_TESTMODELS;
}

}  // namespace rasterlab
