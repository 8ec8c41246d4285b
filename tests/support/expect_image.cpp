#include "tests/support/expect_image.h"

#include "common/image/files.h"

#include "tests/support/places.h"

#include <gtest/gtest.h>

namespace rasterlab {
namespace {

/// A failure's pictures from an earlier run, gone so that what is there is of this one.
void remove_pictures(const std::string& name) {
  for (const char* role : {"_actual", "_expected", "_difference"}) {
    for (const char* extension : {".png", ".pfm"}) {
      std::error_code ignored;
      std::filesystem::remove(failure_folder() / (name + role + extension), ignored);
    }
  }
}

std::string save(const std::string& name, const AnyImage& image) {
  const bool floats = kind_of(image).depth == Depth::floating;
  const std::filesystem::path path = failure_folder() / (name + (floats ? ".pfm" : ".png"));
  try {
    std::filesystem::create_directories(failure_folder());
    write_image(path, image);
  } catch (const std::exception& error) {
    return std::string("  (not left behind: ") + error.what() + ")\n";
  }
  return "  " + path.string() + "\n";
}

}  // namespace

std::filesystem::path failure_folder() {
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::string name =
      test == nullptr ? "no_test" : std::string(test->test_suite_name()) + "." + test->name();
  std::string flat = name;
  std::replace(flat.begin(), flat.end(), '/', '.');  // parameterised tests
  return binary_folder() / "failures" / flat;
}

void expect_image_matches(const AnyImage& actual, const AnyImage& expected,
                          const Tolerance& tolerance, const std::string& name, const char* file,
                          int line) {
  remove_pictures(name);
  const Difference difference = compare_images(actual, expected, tolerance);
  if (difference.matches) return;
  const std::string files = save(name + "_actual", actual) + save(name + "_expected", expected) +
                            save(name + "_difference", difference_picture(actual, expected));
  ADD_FAILURE_AT(file, line) << name << ": " << describe(difference) << files;
}

void expect_image_matches(const AnyImage& actual, const std::filesystem::path& reference,
                          const Tolerance& tolerance, const char* file, int line) {
  const std::string name = reference.stem().string();
  AnyImage expected;
  try {
    expected = read_any_image(reference);
  } catch (const InputError& error) {
    ADD_FAILURE_AT(file, line) << "the reference: " << error.what() << "\n"
                               << save(name + "_actual", actual);
    return;
  }
  expect_image_matches(actual, expected, tolerance, name, file, line);
}

}  // namespace rasterlab
