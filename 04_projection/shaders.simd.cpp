// The shaders of any_mesh.cpp as the engine runs them: compiled once per instruction set.
#include "common/engine/shade_tile.h"
#include "common/projection/color_shaders.h"

RASTERLAB_SHADER(rasterlab::VertexColorShader)
RASTERLAB_SHADER(rasterlab::FaceColorShader)
