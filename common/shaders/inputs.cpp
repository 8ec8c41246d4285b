#include "common/shaders/inputs.h"

#include <string>

namespace rasterlab {

const Sampler& required(const std::optional<Sampler>& sampler, const char* flag) {
  if (!sampler) throw InputError(std::string("this shader needs ") + flag);
  return *sampler;
}

void require_texture_coordinates(const Mesh& mesh) {
  if (mesh.texture_coordinates.empty()) {
    throw InputError("this shader needs a mesh with texture coordinates");
  }
}

}  // namespace rasterlab
