#include "tests/support/expect_image.h"

#include "common/image/files.h"
#include "common/image/operations.h"

#include "tests/image/corners.h"
#include "tests/support/scratch.h"

#include <gtest/gtest-spi.h>

namespace rasterlab {
namespace {

TEST(stage01_expect_image, same_picture_passes_and_leaves_nothing) {
  const ScratchFolder folder;
  write_image(folder / "corners.png", four_corners());
  expect_image_matches(four_corners(), four_corners());
  expect_image_matches(four_corners(), folder / "corners.png");
  EXPECT_FALSE(std::filesystem::exists(failure_folder()));
}

TEST(stage01_expect_image, failure_leaves_three_pictures_and_names_the_kind) {
  const Image<Rgb8> wrong = flipped_vertically(four_corners());
  EXPECT_NONFATAL_FAILURE(expect_image_matches(wrong, four_corners(), {}, "corners"),
                          "kind of wrong: flipped in y");
  EXPECT_EQ(read_image<Rgb8>(failure_folder() / "corners_actual.png"), wrong);
  EXPECT_EQ(read_image<Rgb8>(failure_folder() / "corners_expected.png"), four_corners());
  EXPECT_EQ(read_image<Rgb8>(failure_folder() / "corners_difference.png")(0, 0),
            (Rgb8{255, 0, 255}));  // blue where red is expected
  expect_image_matches(four_corners(), four_corners(), {}, "corners");
  EXPECT_TRUE(std::filesystem::is_empty(failure_folder()));
  std::filesystem::remove(failure_folder());
}

TEST(stage01_expect_image, missing_reference_fails) {
  const ScratchFolder folder;
  EXPECT_NONFATAL_FAILURE(expect_image_matches(four_corners(), folder / "nowhere.png"),
                          "nowhere.png: cannot be read");
  EXPECT_TRUE(std::filesystem::exists(failure_folder() / "nowhere_actual.png"));
  std::filesystem::remove_all(failure_folder());
}

TEST(stage01_expect_image, floats_stay_floats) {
  EXPECT_NONFATAL_FAILURE(expect_image_matches(Image<float>(2, 2, 1.5F), Image<float>(2, 2, 1.25F),
                                               {.max_difference = 0.2}),
                          "4 of 4 pixels differ, the largest difference is 0.25");
  EXPECT_EQ(read_image<float>(failure_folder() / "image_actual.pfm")(1, 1), 1.5F);
  std::filesystem::remove_all(failure_folder());
}

}  // namespace
}  // namespace rasterlab
