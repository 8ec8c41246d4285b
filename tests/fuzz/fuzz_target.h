// What every libFuzzer target shares. A target defines
//
//   void rasterlab::fuzz(std::string_view bytes) { … }
//
// which must return, or throw InputError: bad input's one clear error. Anything else, a sanitizer's
// finding, another exception, 2 GB of memory or 10 seconds of time, is a failure.
#pragma once

#include "common/image/bytes.h"
#include "common/image/check.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <string_view>

#include <unistd.h>

namespace rasterlab {

void fuzz(std::string_view bytes);

/// Writes the bytes to a file in memory, always the same one; `name` gives it its extension.
inline std::filesystem::path as_file(std::string_view bytes, const std::string& name) {
  const std::filesystem::path path =
      std::filesystem::path("/dev/shm") / ("rasterlab-fuzz-" + std::to_string(getpid()) + name);
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

/// Fails unless a promise about what was read holds.
inline void require(bool holds, const char* promise) {
  if (holds) return;
  std::cerr << "broken promise: " << promise << "\n";
  std::abort();
}

}  // namespace rasterlab

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  try {
    rasterlab::fuzz({reinterpret_cast<const char*>(data), size});
  } catch (const rasterlab::InputError& error) {
    rasterlab::require(std::string_view(error.what()).find('\n') == std::string_view::npos,
                       "an error is one line");
  }
  return 0;
}
