// Expects a picture to be another, and leaves behind what one needs to see when it is not.
#pragma once

#include "common/image/difference.h"

#include <filesystem>
#include <string>

namespace rasterlab {

/// A non-fatal failure of the running test unless `actual` is `expected` within `tolerance`. The
/// failure says how many pixels differ, the first of them and the kind of wrong; `actual`,
/// `expected` and the amplified difference stay in
/// the build folder's failures/SUITE.TEST/NAME_actual.png, … `name` tells several pictures of one
/// test apart.
void expect_image_matches(const AnyImage& actual, const AnyImage& expected,
                          const Tolerance& tolerance = {}, const std::string& name = "image",
                          const char* file = __builtin_FILE(), int line = __builtin_LINE());

/// The same with the expected picture in a file, whose name is the picture's name. A file that is
/// missing or cannot be read fails the test, and the actual picture is left for a look.
void expect_image_matches(const AnyImage& actual, const std::filesystem::path& reference,
                          const Tolerance& tolerance = {}, const char* file = __builtin_FILE(),
                          int line = __builtin_LINE());

/// Where the pictures of the running test's failures go.
std::filesystem::path failure_folder();

}  // namespace rasterlab
