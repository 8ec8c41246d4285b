#include "common/shaders/inputs.h"

#include <string>

namespace rasterlab {

const Sampler& required(const std::optional<Sampler>& sampler, const char* flag) {
  if (!sampler) throw InputError(std::string("this shader needs ") + flag);
  return *sampler;
}

}  // namespace rasterlab
