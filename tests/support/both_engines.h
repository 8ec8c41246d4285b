// A stage's executable, drawing by the exercises' code and by the engine.
#pragma once

#include <string>
#include <vector>

namespace rasterlab {

/// A failure of the running test unless `stage --mesh …` (the rest of its command line) draws the
/// same with either --engine: the same pixels covered, and colours at most one code value apart
/// wherever both show the same triangle, which must be all but one pixel in a thousand: where two
/// triangles meet in depth, the two kinds of depth may round to either. Something must be drawn.
void expect_both_engines_draw_the_same(const std::string& stage,
                                       const std::vector<std::string>& arguments);

}  // namespace rasterlab
