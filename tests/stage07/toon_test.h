// The list of shaders as it is after the lab sheet's last section: its line is the sheet's own.
#pragma once

#include "common/shaders/shader_table.h"
#include "common/shaders/shaders.h"

#include "toon.h"  // taken from the sheet, as the line is

#include <tuple>

namespace rasterlab {

inline constexpr std::tuple list_of_the_sheet = {
    shader<Plain>("color", "the surface's colour, without light"),
#include "toon_line.inc"
};

}  // namespace rasterlab
