// What the shaders of stage 07 should show, in double precision, from the published formulas.
// Shares nothing with the stages.
#pragma once

#include "tests/oracle/ray_caster.h"
#include "tests/oracle/shading.h"
#include "tests/oracle/texturing.h"

#include <string>
#include <vector>

namespace rasterlab::oracle {

/// Where a shader's parts come from.
struct ShaderLook {
  enum class Normal { face, vertices, object_map, tangent_map };
  enum class Light { none, diffuse, at_corners, five_levels, phong, blinn_phong };

  std::string name;  ///< as --shader takes it
  bool textured;
  Normal normal;
  Light light;
  bool specular_mapped = false;

  bool normal_mapped() const {
    return normal == Normal::object_map || normal == Normal::tangent_map;
  }
  bool reads_texture_coordinates() const { return textured || specular_mapped || normal_mapped(); }
};

/// All that put a colour, a normal and a light together. The lattice is see_through_lattice().
const std::vector<ShaderLook>& shader_looks();

struct Maps {
  DeepTexture color;
  DeepTexture normal;
  DeepTexture specular;
};

/// A scene in which a look can be asked for pixel by pixel.
struct ShadedScene {
  const RayCaster& witness;
  const Surface& surface;
  Lighting lighting;  ///< with the eye of the viewpoint
  const Maps& maps;
  std::string filter;  ///< of all maps, as --filter takes it; they repeat
};

/// What one sees of a face at window point (x, y). A tangent that the mesh leaves undefined is a
/// jump: such pixels are not compared.
Shade shade_look(const ShaderLook& look, const ShadedScene& scene, double x, double y,
                 const Hit& hit);

/// The lattice: 32 × 16 cells of the texture with square holes, fronts in one colour and backs in
/// red, each side lit as if it faced the eye. What is seen at (x, y) may lie behind several holes.
Shade see_through_lattice(const ShadedScene& scene, double x, double y,
                          const Eigen::Vector3d& front = {0.75, 0.75, 0.75});

}  // namespace rasterlab::oracle
