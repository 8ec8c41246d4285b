#include "tests/stage07/toon_test.h"

#include "common/engine/shade_tile.h"

RASTERLAB_SHADER(rasterlab::Toon)
