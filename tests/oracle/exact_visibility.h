// Which triangle is seen at each pixel, in rational arithmetic: the truth the visibility ladder of
// stage 03 is held to.
#pragma once

#include "common/zbuffer/visibility.h"

namespace rasterlab::oracle {

/// What every rung of the ladder should say; coverage from exact_triangle.h.
VisibleTriangles exactly_seen(const VisibilityScene& scene);

}  // namespace rasterlab::oracle
