// Exercise 05.8: what the exponent of the highlight does.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/lighting/lit_mesh.h"

namespace rasterlab {

/// A mesh lit with one exponent.
struct PowerPictures {
  Image<Rgb8> highlight;  ///< the specular part alone
  Image<Rgb8> sum;        ///< all three parts
};

/// Draws the mesh with `power` for its material's shininess, lit at every pixel (exercise 05.5), on
/// black pictures of width × height: once with the material's specular part alone, once as it is.
/// With power 0 the highlight is everywhere the mesh is lit and mirrors at all, and has a hard
/// edge; the higher the power, the smaller it is. Cost: the mesh drawn twice.
///
/// Source: B.power, with powers 0 to 10.
PowerPictures draw_power(const LitMesh& lit_mesh, float power, int width, int height);

}  // namespace rasterlab
