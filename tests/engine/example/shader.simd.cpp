#include "shader.h"

#include "common/engine/shade_tile.h"

RASTERLAB_SHADER(NormalShader)
