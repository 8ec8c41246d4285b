#include "data/textures.h"

#include "common/image/convert.h"
#include "common/image/files.h"

#include "data/planet.h"
#include "tests/support/places.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterlab {
namespace {

TEST(stage06_data, textures_are_what_the_program_makes) {
  for (const auto& [file, made] : make_textures()) {
    const std::filesystem::path path = source_folder() / "data" / file;
    EXPECT_EQ(read_any_image(path), made)
        << path << " differs; build/release/bin/make_textures data writes it again";
  }
}

TEST(stage06_data, brick_repeats_without_a_seam) {
  const Image<Rgb8> brick = read_image<Rgb8>(source_folder() / "data/brick.png");
  // The column left of the border and the one right of it belong to one brick or its mortar in
  // every row.
  const auto is_mortar = [](const Rgb8& pixel) { return pixel.b > 120; };
  for (int y = 0; y < brick.height(); ++y) {
    EXPECT_EQ(is_mortar(brick(2, y)), is_mortar(brick(brick.width() - 1, y))) << "row " << y;
  }
}

TEST(stage06_data, normals_point_outward_and_have_unit_length) {
  for (const char* file : {"planet_normal_object.png", "planet_normal_tangent.png"}) {
    const Image<Rgb8> map = read_image<Rgb8>(source_folder() / "data" / file);
    for (const Rgb8& pixel : map.pixels()) {
      const Eigen::Vector3f normal = 2 * to_color(pixel) - Color(1, 1, 1);
      ASSERT_NEAR(normal.norm(), 1, 0.01) << file;
    }
  }
}

TEST(stage06_data, sea_is_level_and_land_is_not) {
  int tilted = 0;
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d place = Eigen::Vector3d::Random().normalized();
    const double along = ground_normal(place).dot(place);
    EXPECT_GT(along, 0) << "the ground never faces inward";
    if (!is_sea(place)) tilted += along < 0.999 ? 1 : 0;
  }
  EXPECT_GT(tilted, 50);
}

}  // namespace
}  // namespace rasterlab
