// Files made byte by byte from the formats' specifications, as others write them.
#include "common/image/files.h"

#include "tests/support/scratch.h"

#include <bit>
#include <cmath>
#include <cstring>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

std::string bytes(std::initializer_list<int> values) {
  std::string result;
  for (const int value : values) result += static_cast<char>(value);
  return result;
}

class stage01_image_formats : public testing::Test {
 protected:
  AnyImage read(const std::string& name, const std::string& content) {
    write_file(folder / name, content);
    return read_any_image(folder / name);
  }

  template <class Pixel>
  void expect_pixels(const std::string& name, const std::string& content, int width,
                     const std::vector<Pixel>& pixels) {
    const AnyImage image = read(name, content);
    ASSERT_TRUE(std::holds_alternative<Image<Pixel>>(image)) << to_string(kind_of(image));
    EXPECT_EQ(width_of(image), width);
    EXPECT_TRUE(std::get<Image<Pixel>>(image).pixels() == pixels);
  }

  ScratchFolder folder;
};

using Grey = std::uint8_t;

// --- PBM, PGM, PPM ---

TEST_F(stage01_image_formats, netpbm_text) {
  expect_pixels<Grey>("a", "P1 2 2 1 0 0 1", 2, {0, 255, 255, 0});
  expect_pixels<Grey>("a", "P1\n#c\n3 1\n101\n", 3, {0, 255, 0});
  expect_pixels<Grey>("a", "P2\n2 1\n255\n7 200", 2, {7, 200});
  expect_pixels<Rgb8>("a", "P3 1 2 255 1 2 3 4 5 6\n", 1, {{1, 2, 3}, {4, 5, 6}});
}

TEST_F(stage01_image_formats, netpbm_comments_tabs_and_crlf) {
  expect_pixels<Grey>("a", "P2#c\n# two\r\n2\t1 # width, height\r\n255\r\n7 # seven\n200\r\n", 2,
                      {7, 200});
  expect_pixels<Rgb8>("a", "P6 1 1 255#c\nabc", 1, {{'a', 'b', 'c'}});
  expect_pixels<Rgb8>("a", "P6\n1 1\n255\n#ab", 1,
                      {{'#', 'a', 'b'}});  // the raster may start with #
}

TEST_F(stage01_image_formats, netpbm_maximum_is_white) {
  expect_pixels<Grey>("a", "P2 3 1 100 0 50 100", 3, {0, 128, 255});
  expect_pixels<Grey>("a", "P5 3 1 1\n" + bytes({0, 1, 0}), 3, {0, 255, 0});
  expect_pixels<std::uint16_t>("a", "P2 3 1 1000 0 500 1000", 3, {0, 32768, 65535});
  expect_pixels<std::uint16_t>("a", "P5 2 1 256\n" + bytes({1, 0, 0, 1}), 2, {65535, 256});
  expect_pixels<std::uint16_t>("a", "P5 2 1 65535\n" + bytes({1, 2, 255, 255}), 2, {258, 65535});
  expect_pixels<Rgb16>("a", "P6 1 1 65535\n" + bytes({0, 1, 1, 0, 255, 255}), 1, {{1, 256, 65535}});
}

TEST_F(stage01_image_formats, netpbm_bitmap_rows_start_at_bytes) {
  expect_pixels<Grey>("a", "P4 9 2\n" + bytes({0x80, 0x80, 0x01, 0x00}), 9,
                      {0, 255, 255, 255, 255, 255, 255, 255, 0,  //
                       255, 255, 255, 255, 255, 255, 255, 0, 255});
}

TEST_F(stage01_image_formats, netpbm_more_after_the_picture_is_ignored) {
  expect_pixels<Grey>("a", "P5 1 1 255\nxP5 1 1 255\ny", 1, {'x'});
}

// --- PFM ---

std::string float_bytes(std::initializer_list<float> values, std::endian order) {
  std::string result;
  for (const float value : values) {
    std::array<char, 4> four{};
    std::memcpy(four.data(), &value, 4);
    if (order != std::endian::native) std::reverse(four.begin(), four.end());
    result.append(four.data(), 4);
  }
  return result;
}

TEST_F(stage01_image_formats, pfm_of_both_byte_orders_bottom_row_first) {
  const float infinity = std::numeric_limits<float>::infinity();
  expect_pixels<float>("a", "Pf\n1 2\n-1.0\n" + float_bytes({1.5F, infinity}, std::endian::little),
                       1, {infinity, 1.5F});
  expect_pixels<float>("a", "Pf 1 2 1e0\n" + float_bytes({1.5F, -infinity}, std::endian::big), 1,
                       {-infinity, 1.5F});
  expect_pixels<Color>("a", "PF\n1 1\n-1\n" + float_bytes({1, 2, 3}, std::endian::little), 1,
                       {Color(1, 2, 3)});
}

TEST_F(stage01_image_formats, pfm_scale_is_a_unit_and_leaves_values_alone) {
  expect_pixels<float>("a", "Pf\n1 1\n-2.5\n" + float_bytes({1.5F}, std::endian::little), 1,
                       {1.5F});
}

// --- TGA ---

struct Tga {
  int type = 2;
  int bits = 24;
  int descriptor = 0x20;
  int width = 2;
  int height = 2;
  std::string id = {};
  int map_first = 0;
  int map_length = 0;
  int map_bits = 0;
  std::string map = {};
  std::string pixels = {};

  std::string content() const {
    const auto low = [](int value) { return value & 255; };
    const auto high = [](int value) { return value >> 8; };
    return bytes({static_cast<int>(id.size()), map_bits > 0 ? 1 : 0, type, low(map_first),
                  high(map_first), low(map_length), high(map_length), map_bits, 7, 0, 9, 0,
                  low(width), high(width), low(height), high(height), bits, descriptor}) +
           id + map + pixels;
  }
};

const Rgb8 red{255, 0, 0};
const Rgb8 green{0, 255, 0};
const Rgb8 blue{0, 0, 255};
const Rgb8 white{255, 255, 255};
const std::string bgr_red = bytes({0, 0, 255});
const std::string bgr_green = bytes({0, 255, 0});
const std::string bgr_blue = bytes({255, 0, 0});
const std::string bgr_white = bytes({255, 255, 255});
const std::string bgr_corners = bgr_red + bgr_green + bgr_blue + bgr_white;

TEST_F(stage01_image_formats, tga_true_color_of_every_origin) {
  const auto expect = [&](int descriptor, const std::vector<Rgb8>& pixels) {
    expect_pixels<Rgb8>("a.tga", Tga{.descriptor = descriptor, .pixels = bgr_corners}.content(), 2,
                        pixels);
  };
  expect(0x20, {red, green, blue, white});
  expect(0x00, {blue, white, red, green});
  expect(0x30, {green, red, white, blue});
  expect(0x10, {white, blue, green, red});
}

TEST_F(stage01_image_formats, tga_packed_runs_may_cross_rows) {
  // A run of 3 red, then 3 pixels as they are; 3 × 2 from the top.
  const std::string packets =
      bytes({0x82}) + bgr_red + bytes({0x02}) + bgr_green + bgr_blue + bgr_white;
  expect_pixels<Rgb8>("a.tga", Tga{.type = 10, .width = 3, .pixels = packets}.content(), 3,
                      {red, red, red, green, blue, white});
  const std::string crossing = bytes({0x84}) + bgr_red + bytes({0x80}) + bgr_white;
  expect_pixels<Rgb8>("a.tga", Tga{.type = 10, .width = 3, .pixels = crossing}.content(), 3,
                      {red, red, red, red, red, white});
}

TEST_F(stage01_image_formats, tga_last_run_may_be_too_long) {
  const std::string packets = bytes({0xFF}) + bgr_blue;
  expect_pixels<Rgb8>("a.tga", Tga{.type = 10, .pixels = packets}.content(), 2,
                      {blue, blue, blue, blue});
}

TEST_F(stage01_image_formats, tga_grey) {
  expect_pixels<Grey>("a.tga", Tga{.type = 3, .bits = 8, .pixels = "abcd"}.content(), 2,
                      {'a', 'b', 'c', 'd'});
  expect_pixels<Grey>("a.tga", Tga{.type = 11, .bits = 8, .pixels = bytes({0x83, 'x'})}.content(),
                      2, {'x', 'x', 'x', 'x'});
  expect_pixels<Rgba8>(
      "a.tga", Tga{.type = 3, .bits = 16, .width = 1, .height = 1, .pixels = "ab"}.content(), 1,
      {{'a', 'a', 'a', 'b'}});
}

TEST_F(stage01_image_formats, tga_16_and_15_bit_colors) {
  const std::string pixels = bytes({0x00, 0x7C, 0xE0, 0x03, 0x1F, 0x00, 0xFF, 0xFF});
  expect_pixels<Rgb8>("a.tga", Tga{.bits = 16, .pixels = pixels}.content(), 2,
                      {red, green, blue, white});
  expect_pixels<Rgb8>("a.tga", Tga{.bits = 15, .pixels = pixels}.content(), 2,
                      {red, green, blue, white});
  const std::string packets = bytes({0x83, 0x10, 0x42});  // 16, 16, 16 of 31
  expect_pixels<Rgb8>(
      "a.tga", Tga{.type = 10, .bits = 16, .width = 1, .height = 4, .pixels = packets}.content(), 1,
      std::vector<Rgb8>(4, {132, 132, 132}));
}

TEST_F(stage01_image_formats, tga_alpha) {
  const std::string pixel = bytes({3, 2, 1, 77});
  const auto one = [&](int descriptor, const std::string& pixels) {
    return Tga{.bits = 32, .descriptor = descriptor, .width = 1, .height = 1, .pixels = pixels}
        .content();
  };
  expect_pixels<Rgba8>("a.tga", one(0x28, pixel), 1, {{1, 2, 3, 77}});
  expect_pixels<Rgba8>("a.tga", one(0x20, pixel), 1, {{1, 2, 3, 77}});
  expect_pixels<Rgba8>("a.tga", one(0x28, bytes({3, 2, 1, 0})), 1, {{1, 2, 3, 0}});
  expect_pixels<Rgb8>("a.tga", one(0x20, bytes({3, 2, 1, 0})), 1,
                      {{1, 2, 3}});  // no alpha bits, all 0
}

TEST_F(stage01_image_formats, tga_color_mapped) {
  Tga tga{.type = 1,
          .bits = 8,
          .map_length = 4,
          .map_bits = 24,
          .map = bgr_corners,
          .pixels = bytes({3, 2, 1, 0})};
  expect_pixels<Rgb8>("a.tga", tga.content(), 2, {white, blue, green, red});
  tga.map_first = 10;
  tga.pixels = bytes({10, 11, 12, 13});
  expect_pixels<Rgb8>("a.tga", tga.content(), 2, {red, green, blue, white});
  tga.type = 9;
  tga.pixels = bytes({0x82, 12, 0x00, 10});
  expect_pixels<Rgb8>("a.tga", tga.content(), 2, {blue, blue, blue, red});
  tga.bits = 16;
  tga.map_first = 300;
  tga.pixels = bytes({0x83, 301 - 256, 1});
  expect_pixels<Rgb8>("a.tga", tga.content(), 2, {green, green, green, green});
}

TEST_F(stage01_image_formats, tga_with_id_and_a_map_it_does_not_use) {
  expect_pixels<Rgb8>("a.tga",
                      Tga{.id = "made by hand",
                          .map_length = 2,
                          .map_bits = 16,
                          .map = "abcd",
                          .pixels = bgr_corners}
                          .content(),
                      2, {red, green, blue, white});
}

TEST_F(stage01_image_formats, tga_footer_tells_the_format_without_extension) {
  const std::string footer = std::string(8, '\0') + std::string("TRUEVISION-XFILE.\0", 18);
  expect_pixels<Rgb8>("a.dat", Tga{.pixels = bgr_corners}.content() + footer, 2,
                      {red, green, blue, white});
}

}  // namespace
}  // namespace rasterlab
