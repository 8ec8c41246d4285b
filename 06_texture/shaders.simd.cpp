// The shaders of any_mesh.cpp as the engine runs them: compiled once per instruction set.
#include "06_texture/shaders.h"

#include "common/engine/shade_tile.h"

RASTERLAB_SHADER(rasterlab::LitColors)
RASTERLAB_SHADER(rasterlab::LitTexture)
