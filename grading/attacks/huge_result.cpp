// Writes a result of many gigabytes.
#include "common/lines/draw_line.h"

#include <csignal>
#include <cstdlib>

#include <fcntl.h>
#include <unistd.h>

namespace rasterlab {

void draw_line(Image<Rgb8>&, const Point&, const Point&, const Rgb8&) {
  std::signal(SIGXFSZ, SIG_IGN);
  const int file = open("/out", O_WRONLY);
  static char zeros[1 << 20];
  while (write(file, zeros, sizeof zeros) > 0) {
  }
  std::_Exit(0);
}

}  // namespace rasterlab
