#include "common/texture/perspective_ladder.h"

namespace rasterlab {

const std::array<NamedPerspectiveRung, 4>& perspective_ladder() {
  static const std::array<NamedPerspectiveRung, 4> ladder = {
      {{"affine", affine_weights, "textures bend, and along a square's diagonal they break"},
       {"runs_of_16", weights_in_runs_of_16, "textures ripple where w changes fast in a row"},
       {"runs_of_8", weights_in_runs_of_8, "the ripple is about a quarter as high"},
       {"exact", perspective_weights, "none"}}};
  return ladder;
}

}  // namespace rasterlab
