// A part of OpenCV that is loaded when it is first used. Debian's brings some 130 libraries more
// with its codecs (GDAL's) and its windows (Qt's): to load them takes a tenth of a second, at every
// start of every program, though many read no PNG and hardly any opens a window. Not for use
// outside common/image.
#pragma once

#include "common/image/check.h"

#include <string>

#include <dlfcn.h>

namespace rasterlab {

class OpenCvLibrary {
 public:
  /// Loads it, for as long as the process lives. Throws InputError when that cannot be.
  explicit OpenCvLibrary(const char* file) : handle_(dlopen(file, RTLD_LAZY)) {
    if (handle_ == nullptr) fail();
  }

  /// The function cv::NAME. `parameters` are the types of its parameters as the compiler writes
  /// them into the symbol (Itanium C++ ABI, 5.1); that they are those of `Function` isn't checked.
  template <class Function>
  Function* function(const std::string& name, const std::string& parameters) const {
    const std::string symbol = "_ZN2cv" + std::to_string(name.size()) + name + "E" + parameters;
    void* address = dlsym(handle_, symbol.c_str());
    if (address == nullptr) fail();
    return reinterpret_cast<Function*>(address);
  }

  /// A parameter of type const std::string&.
  static constexpr const char* string = "RKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEE";

 private:
  [[noreturn]] static void fail() {
    throw InputError(std::string("OpenCV cannot be used: ") + dlerror());
  }

  void* handle_;
};

}  // namespace rasterlab
