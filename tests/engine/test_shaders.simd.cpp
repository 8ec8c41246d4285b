#include "tests/engine/test_shaders.h"

#include "common/engine/shade_tile.h"

#include "tests/engine/encode_shader.h"

RASTERLAB_SHADER(rasterlab::BusyShader)
RASTERLAB_SHADER(rasterlab::HolesShader)
RASTERLAB_SHADER(rasterlab::QuietShader)
RASTERLAB_SHADER(rasterlab::UndeclaredShader)
RASTERLAB_SHADER(rasterlab::PlainShader)
RASTERLAB_SHADER(rasterlab::StripesShader)
RASTERLAB_SHADER(rasterlab::PatchworkShader)
RASTERLAB_SHADER(rasterlab::CountingShader)
RASTERLAB_SHADER(rasterlab::NumberedShader)
RASTERLAB_SHADER(rasterlab::TwoSidedShader)
RASTERLAB_SHADER(rasterlab::FailingShader)
RASTERLAB_SHADER(rasterlab::EncodeShader)
RASTERLAB_SHADER(rasterlab::EncodeDerivativeShader)
RASTERLAB_SHADER(rasterlab::UniformPowerShader)
