// A shader of the list, chosen when the program runs.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/projection/draw_mesh.h"
#include "common/projection/frame.h"
#include "common/shaders/inputs.h"
#include "common/stage/run.h"

#include <string>

namespace rasterlab {

/// Draws the inputs' mesh into `frame` by the shader of that name, with the exercises' code. Throws
/// InputError when there is no such shader, or it lacks something.
DrawCounts draw_by_name(const std::string& shader, const ShaderInputs& inputs, Cull cull,
                        Frame& frame);

/// The same as a picture of its own.
Image<Rgb8> picture_by_name(const std::string& shader, const ShaderInputs& inputs, Size size);

}  // namespace rasterlab
