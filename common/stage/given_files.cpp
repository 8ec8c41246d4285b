#include "common/stage/given_files.h"

#include "common/image/check.h"

namespace rasterlab {

std::filesystem::path data_path(const std::string& file_name) {
  return std::filesystem::path(RASTERLAB_DATA) / file_name;
}

std::filesystem::path bunny_path() {
  std::filesystem::path path = RASTERLAB_BUNNY;
  if (!std::filesystem::exists(path)) {
    throw InputError(
        path.string() +
        ": the Stanford bunny is not there; Debian's package glmark2-data installs it");
  }
  return path;
}

}  // namespace rasterlab
