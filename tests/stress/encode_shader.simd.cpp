#include "tests/engine/encode_shader.h"

#include "common/engine/shade_tile.h"

RASTERLAB_SHADER(rasterlab::EncodeShader)
