// What a shader of stage 07 may be made from.
#pragma once

#include "common/image/check.h"
#include "common/image/pixel.h"
#include "common/mesh/mesh.h"
#include "common/projection/draw_mesh.h"
#include "common/projection/scene.h"
#include "common/texture/sample.h"

#include <optional>

#include <Eigen/Dense>

namespace rasterlab {

/// The scene a mesh is drawn in. A shader's constructor takes what it needs of it; what is pointed
/// to must outlive the shader.
struct ShaderInputs {
  const Mesh& mesh;
  Transforms transforms = {};
  Light light = {};  ///< in the world
  Material material = {};
  std::optional<Color> color = {};  ///< of a surface that has no texture; not given: the mesh's own
  std::optional<Sampler> texture = {};
  std::optional<Sampler> normal_map = {};         ///< in tangent space
  std::optional<Sampler> object_normal_map = {};  ///< in object space
  std::optional<Sampler> specular_map = {};
};

/// The sampler, which the shader cannot do without. Throws InputError, which says the flag that
/// gives it.
const Sampler& required(const std::optional<Sampler>& sampler, const char* flag);

}  // namespace rasterlab
