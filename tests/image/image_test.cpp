#include "common/image/image.h"

#include "common/image/pixel.h"

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

TEST(stage01_image, outside_throws_with_coordinates_and_size) {
  Image<Rgb8> image(90, 10);
  try {
    image(91, 10);
    FAIL() << "im(91, 10) of a 90x10 image must throw";
  } catch (const CheckError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("(91, 10)"));
    EXPECT_THAT(error.what(), testing::HasSubstr("90x10"));
    EXPECT_THAT(error.call_stack(), testing::HasSubstr("stage01_image"));
  }
}

}  // namespace
}  // namespace rasterlab
