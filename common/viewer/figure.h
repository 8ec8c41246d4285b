// What the figures of stages 04 to 07 are drawn in.
#pragma once

#include "common/projection/frame.h"
#include "common/stage/run.h"

namespace rasterlab {

/// An empty frame, as large as --size says, else `fallback`.
Frame frame_of(const Run& run, Size fallback = {200, 200});

/// Width / height.
float aspect_of(const Frame& frame);

/// The depths that were drawn as grey, near ones bright; black where nothing was.
Image<std::uint8_t> depth_picture(const Frame& frame);

}  // namespace rasterlab
