// Puts HTML and a script into all that a page may show.
#include "common/lines/draw_line.h"

#include <iostream>
#include <stdexcept>

namespace rasterlab {

void draw_line(Image<Rgb8>&, const Point&, const Point&, const Rgb8&) {
  std::cout << "</pre><script>alert(1)</script><img src=x onerror=alert(1)>\n";
  throw std::runtime_error("<script>alert(2)</script>");
}

}  // namespace rasterlab
