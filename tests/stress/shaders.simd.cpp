#include "common/engine/shade_tile.h"

#include "tests/engine/encode_shader.h"
#include "tests/stress/power_shader.h"

RASTERLAB_SHADER(rasterlab::EncodeShader)
RASTERLAB_SHADER(rasterlab::PowerShader)
