#include "bench/engine/bench_shaders.h"

#include "common/engine/shade_tile.h"

RASTERLAB_SHADER(rasterlab::bench::FlatShader)
RASTERLAB_SHADER(rasterlab::bench::PhongShader)
RASTERLAB_SHADER(rasterlab::bench::TexturedShader)
RASTERLAB_SHADER(rasterlab::bench::NormalMappedShader)
