// The manifest of a program that is no stage: a test or a tool, into which the linker may bring
// run_stage() along. A stage's own, compiled into it, comes before this one.
#include "common/stage/stage.h"

namespace rasterlab {

const char* const stage_manifest = R"({"exercises": []})";

}  // namespace rasterlab
