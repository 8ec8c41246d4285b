// What a shader of stage 07 may be made from.
#pragma once

#include "common/image/check.h"
#include "common/image/pixel.h"
#include "common/mesh/mesh.h"
#include "common/projection/draw_mesh.h"
#include "common/projection/scene.h"
#include "common/texture/sample.h"

#include <functional>
#include <optional>
#include <utility>

#include <Eigen/Dense>

namespace rasterlab {

/// A sampler that a shader may ask for: given, made by a function when a shader asks, or none. The
/// function is called each time one asks.
class SamplerInput {
 public:
  SamplerInput() = default;
  SamplerInput(const Sampler& sampler) : get_([sampler] { return sampler; }) {}
  explicit SamplerInput(std::function<Sampler()> get) : get_(std::move(get)) {}

  friend Sampler required(const SamplerInput& input, const char* flag);

 private:
  std::function<Sampler()> get_;
};

/// The scene a mesh is drawn in. A shader's constructor takes what it needs of it; what is pointed
/// to must outlive the shader.
struct ShaderInputs {
  const Mesh& mesh;
  Transforms transforms = {};
  Light light = {};  ///< in the world
  Material material = {};
  std::optional<Color> color = {};  ///< of a surface that has no texture; not given: the mesh's own
  SamplerInput texture = {};
  SamplerInput normal_map = {};         ///< in tangent space
  SamplerInput object_normal_map = {};  ///< in object space
  SamplerInput specular_map = {};
};

/// The sampler, which the shader cannot do without. Throws InputError, which says the flag that
/// gives it.
Sampler required(const SamplerInput& input, const char* flag);

}  // namespace rasterlab
