#include "bench/support/provenance.h"

#include <array>
#include <cstdio>

namespace rasterlab::bench {
namespace {

std::string first_line_of(const char* command) {
  std::string line;
  if (FILE* pipe = popen(command, "r")) {
    std::array<char, 256> buffer{};
    if (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) line = buffer.data();
    pclose(pipe);
  }
  while (!line.empty() && line.back() == '\n') line.pop_back();
  return line;
}

}  // namespace

const std::string& commit() {
  static const std::string name =
      first_line_of("git -C '" RASTERLAB_SOURCE "' describe --always --dirty 2>/dev/null");
  return name;
}

const std::string& machine() {
  static const std::string name =
      first_line_of("grep -m1 'model name' /proc/cpuinfo | cut -d: -f2");
  return name;
}

}  // namespace rasterlab::bench
