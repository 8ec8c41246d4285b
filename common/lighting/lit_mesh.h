// A mesh in a light: what stage 05 draws.
#pragma once

#include "common/image/pixel.h"
#include "common/mesh/mesh.h"
#include "common/projection/draw_mesh.h"
#include "common/projection/scene.h"

#include <optional>

namespace rasterlab {

enum class ReflectionModel { phong, blinn_phong };

struct LitMesh {
  const Mesh& mesh;
  Transforms transforms;
  Light light;  ///< in the world
  Material material;
  std::optional<Color> color = std::nullopt;  ///< not given: the mesh's, else default_color()
  ReflectionModel model = ReflectionModel::phong;
  Cull cull = Cull::none;
};

}  // namespace rasterlab
