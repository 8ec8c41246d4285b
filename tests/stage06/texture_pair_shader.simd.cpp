#include "tests/stage06/texture_pair_shader.h"

#include "common/engine/shade_tile.h"

RASTERLAB_SHADER(rasterlab::TexturePairShader)
