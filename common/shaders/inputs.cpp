#include "common/shaders/inputs.h"

#include <string>

namespace rasterlab {

Sampler required(const SamplerInput& input, const char* flag) {
  if (!input.get_) throw InputError(std::string("this shader needs ") + flag);
  return input.get_();
}

}  // namespace rasterlab
