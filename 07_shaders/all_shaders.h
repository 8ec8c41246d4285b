// Exercise 07.7: one light, every shader.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/shaders/inputs.h"
#include "common/stage/run.h"

#include <string>
#include <vector>

namespace rasterlab {

struct ShadedPicture {
  std::string name;  ///< the shader's
  Image<Rgb8> image;
};

/// What every shader of the list (shader_list.h), in its order, makes of the same inputs: which
/// must have all the maps, and a mesh that has normals, texture coordinates and colours. Nothing is
/// kept from one call to the next, so that a light that turns turns for all. Cost: one picture a
/// shader.
///
/// Source: B.all.
std::vector<ShadedPicture> draw_all_shaders(const ShaderInputs& inputs, Size size);

}  // namespace rasterlab
