#include "common/stage/stage.h"

namespace rasterlab {
int run_stage(int, char**, const Stage&) { return 0; }
}  // namespace rasterlab
