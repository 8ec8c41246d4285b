#include "common/image/files.h"

#include "common/image/convert.h"

#include "tests/image/corners.h"
#include "tests/support/scratch.h"

#include <cstdlib>
#include <limits>
#include <random>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

/// The same picture in another kind of pixel with all the bits that kind has, so that losing some
/// shows.
template <class Pixel>
Image<Pixel> random_image(int width, int height) {
  std::mt19937 random(7);
  const auto bits = [&] { return random() & 0xFFFFU; };
  Image<Pixel> image(width, height);
  for (Pixel& pixel : image.pixels()) {
    if constexpr (std::is_same_v<Pixel, float>) {
      pixel = static_cast<float>(bits()) / 1000.0F - 20;
    } else if constexpr (std::is_same_v<Pixel, Color>) {
      pixel = {static_cast<float>(bits()) * 1e-30F, static_cast<float>(bits()), -1.5F};
    } else if constexpr (std::is_integral_v<Pixel>) {
      pixel = static_cast<Pixel>(bits());
    } else {
      using Sample = decltype(Pixel::r);
      pixel = {static_cast<Sample>(bits()), static_cast<Sample>(bits()),
               static_cast<Sample>(bits())};
      if constexpr (pixel_kind<Pixel>.channels == 4) pixel.a = static_cast<Sample>(bits());
    }
  }
  return image;
}

class stage01_image_files : public testing::Test {
 protected:
  template <class Pixel>
  void expect_kept(const std::string& extension, const WriteOptions& options = {}) {
    for (const auto& [width, height] : {std::pair{1, 1}, {7, 5}, {130, 3}, {2, 300}}) {
      const Image<Pixel> image = random_image<Pixel>(width, height);
      const auto path = folder / ("picture" + extension);
      write_image(path, image, options);
      const AnyImage read = read_any_image(path);
      EXPECT_EQ(to_string(kind_of(read)), to_string(pixel_kind<Pixel>)) << extension;
      EXPECT_TRUE(std::holds_alternative<Image<Pixel>>(read) &&
                  std::get<Image<Pixel>>(read) == image)
          << extension << " " << width << "x" << height;
    }
  }

  ScratchFolder folder;
};

TEST_F(stage01_image_files, png_keeps_every_kind_of_8_and_16_bit) {
  expect_kept<std::uint8_t>(".png");
  expect_kept<std::uint16_t>(".png");
  expect_kept<Rgb8>(".png");
  expect_kept<Rgb16>(".png");
  expect_kept<Rgba8>(".png");
  expect_kept<Rgba16>(".png");
}

TEST_F(stage01_image_files, pgm_and_ppm_keep_8_and_16_bit_as_text_and_binary) {
  for (const bool text : {false, true}) {
    const WriteOptions options{.text = text};
    expect_kept<std::uint8_t>(".pgm", options);
    expect_kept<std::uint16_t>(".pgm", options);
    expect_kept<Rgb8>(".ppm", options);
    expect_kept<Rgb16>(".ppm", options);
    expect_kept<std::uint8_t>(".pnm", options);
    expect_kept<Rgb8>(".pnm", options);
  }
}

TEST_F(stage01_image_files, tga_keeps_grey_rgb_and_rgba_raw_and_packed) {
  for (const bool run_length : {false, true}) {
    const WriteOptions options{.run_length = run_length};
    expect_kept<std::uint8_t>(".tga", options);
    expect_kept<Rgb8>(".tga", options);
    expect_kept<Rgba8>(".tga", options);
  }
}

TEST_F(stage01_image_files, pfm_keeps_floats_and_infinities) {
  expect_kept<float>(".pfm");
  expect_kept<Color>(".pfm");
  Image<float> depth(2, 2, std::numeric_limits<float>::infinity());
  depth(1, 0) = -0.0F;
  depth(0, 1) = std::numeric_limits<float>::quiet_NaN();
  write_image(folder / "depth.pfm", depth);
  const auto read = read_image<float>(folder / "depth.pfm");
  EXPECT_EQ(read(0, 0), depth(0, 0));
  EXPECT_TRUE(std::signbit(read(1, 0)));
  EXPECT_TRUE(std::isnan(read(0, 1)));
}

TEST_F(stage01_image_files, pbm_keeps_black_and_white) {
  Image<std::uint8_t> image(11, 3, 255);
  image(0, 0) = 0;
  image(10, 2) = 127;
  image(9, 2) = 128;
  for (const bool text : {false, true}) {
    write_image(folder / "bits.pbm", image, {.text = text});
    const auto read = read_image<std::uint8_t>(folder / "bits.pbm");
    EXPECT_EQ(std::count(read.pixels().begin(), read.pixels().end(), 0), 2);
    EXPECT_EQ(read(0, 0), 0);
    EXPECT_EQ(read(10, 2), 0);
    EXPECT_EQ(read(9, 2), 255);
  }
}

TEST_F(stage01_image_files, jpeg_stays_near) {
  Image<Rgb8> image(64, 32);  // Smooth: at a sharp edge JPEG mixes the colours of both sides.
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 64; ++x) {
      image(x, y) = {static_cast<std::uint8_t>(4 * x), static_cast<std::uint8_t>(8 * y), 100};
    }
  }
  write_image(folder / "smooth.jpg", image, {.jpeg_quality = 100});
  const auto read = read_image<Rgb8>(folder / "smooth.jpg");
  ASSERT_EQ(read.pixels().size(), image.pixels().size());
  int largest = 0;
  for (std::size_t i = 0; i < image.pixels().size(); ++i) {
    largest = std::max({largest, std::abs(read.pixels()[i].r - image.pixels()[i].r),
                        std::abs(read.pixels()[i].g - image.pixels()[i].g),
                        std::abs(read.pixels()[i].b - image.pixels()[i].b)});
  }
  EXPECT_LE(largest, 8);
  write_image(folder / "grey.jpeg", Image<std::uint8_t>(16, 16, 100));
  EXPECT_EQ(to_string(kind_of(read_any_image(folder / "grey.jpeg"))), "8-bit grey");
}

/// Every way a colour picture can be written.
struct Variant {
  const char* extension;
  WriteOptions options;
};
const std::vector<Variant> color_variants = {{".png", {}},
                                             {".jpg", {}},
                                             {".ppm", {}},
                                             {".ppm", {.text = true}},
                                             {".pnm", {}},
                                             {".tga", {.run_length = false}},
                                             {".tga", {.run_length = true}},
                                             {".pfm", {}}};

void expect_four_corners(const Image<Rgb8>& image, const std::string& what) {
  ASSERT_EQ(image.width(), 64) << what;
  ASSERT_EQ(image.height(), 32) << what;
  const auto expect = [&](int x, int y, Rgb8 color) {
    const Rgb8 pixel = image(x, y);
    EXPECT_NEAR(pixel.r, color.r, 2) << what << " at " << x << ", " << y;
    EXPECT_NEAR(pixel.g, color.g, 2) << what << " at " << x << ", " << y;
    EXPECT_NEAR(pixel.b, color.b, 2) << what << " at " << x << ", " << y;
  };
  expect(0, 0, {255, 0, 0});
  expect(63, 0, {0, 255, 0});
  expect(0, 31, {0, 0, 255});
  expect(63, 31, {255, 255, 255});
}

TEST_F(stage01_image_files, four_corners_come_back_from_every_format) {
  for (const Variant& variant : color_variants) {
    const auto path = folder / (std::string("corners") + variant.extension);
    write_image(path, four_corners(), variant.options);
    expect_four_corners(read_image<Rgb8>(path), variant.extension);
  }
}

bool have_imagemagick() {
  return std::system("convert -version >/dev/null 2>&1") == 0;
}

int run_imagemagick(const std::filesystem::path& from, const std::string& options,
                    const std::filesystem::path& to) {
  const std::string command =
      "convert '" + from.string() + "' " + options + " '" + to.string() + "' 2>/dev/null";
  return std::system(command.c_str());
}

TEST_F(stage01_image_files, four_corners_as_imagemagick_reads_them) {
  if (!have_imagemagick()) GTEST_SKIP() << "ImageMagick's convert is not installed";
  for (const Variant& variant : color_variants) {
    const auto path = folder / (std::string("corners") + variant.extension);
    write_image(path, four_corners(), variant.options);
    // ImageMagick 6 leaves a TGA's rows as they come and notes their order as an orientation.
    ASSERT_EQ(run_imagemagick(path, "-auto-orient -depth 8", folder / "read.ppm"), 0)
        << variant.extension;
    expect_four_corners(read_image<Rgb8>(folder / "read.ppm"), variant.extension);
  }
}

TEST_F(stage01_image_files, four_corners_as_imagemagick_writes_them) {
  if (!have_imagemagick()) GTEST_SKIP() << "ImageMagick's convert is not installed";
  write_image(folder / "corners.png", four_corners());
  const std::vector<std::pair<std::string, std::string>> files = {
      {"plain.png", ""},
      {"palette.png", "-type Palette -define png:color-type=3"},
      {"interlaced.png", "-interlace PNG"},
      {"sixteen.png", "-depth 16 -define png:bit-depth=16 -define png:color-type=2"},
      {"alpha.png", "-alpha set -define png:color-type=6"},
      {"baseline.jpg", "-quality 100"},
      {"progressive.jpg", "-quality 100 -interlace JPEG"},
      {"subsampled.jpg", "-quality 100 -sampling-factor 4:2:0"},
      {"arithmetic.jpg", "-quality 100 -define jpeg:arithmetic-coding=true"},
      {"cmyk.jpg", "-quality 100 -colorspace CMYK"},
      {"binary.ppm", ""},
      {"text.ppm", "-compress none"},
      {"sixteen.ppm", "-depth 16"},
      {"raw.tga", "-orient TopLeft -compress none"},
      {"packed.tga", "-orient TopLeft -compress RLE"},
      {"palette.tga", "-orient TopLeft -type Palette"},
      {"alpha.tga", "-orient TopLeft -alpha set -type TrueColorAlpha"},
      {"leftward.tga", "-flop -orient TopRight"},
      {"upward.tga", "-flip -orient BottomLeft"},
      {"little.pfm", "-endian LSB"},
      {"big.pfm", "-endian MSB"}};
  for (const auto& [name, options] : files) {
    ASSERT_EQ(run_imagemagick(folder / "corners.png", options, folder / name), 0) << name;
    expect_four_corners(read_image<Rgb8>(folder / name), name);
  }
}

TEST_F(stage01_image_files, content_tells_the_format_not_the_extension) {
  write_image(folder / "corners.png", four_corners());
  std::filesystem::rename(folder / "corners.png", folder / "corners.jpg");
  expect_four_corners(read_image<Rgb8>(folder / "corners.jpg"), "a PNG called .jpg");
  std::filesystem::rename(folder / "corners.jpg", folder / "corners");
  expect_four_corners(read_image<Rgb8>(folder / "corners"), "a PNG without extension");
}

TEST_F(stage01_image_files, extensions_in_capitals_count) {
  write_image(folder / "CORNERS.TGA", four_corners());
  expect_four_corners(read_image<Rgb8>(folder / "CORNERS.TGA"), "capitals");
}

TEST_F(stage01_image_files, what_a_format_cannot_hold_is_converted) {
  const Image<Rgba8> image(1, 1, {255, 0, 0, 7});
  const auto kind_in = [&](const std::string& name, const AnyImage& written) {
    write_image(folder / name, written);
    return to_string(kind_of(read_any_image(folder / name)));
  };
  EXPECT_EQ(kind_in("a.pgm", image), "8-bit grey");
  EXPECT_EQ(kind_in("a.ppm", image), "8-bit RGB");
  EXPECT_EQ(kind_in("a.pnm", image), "8-bit RGB");
  EXPECT_EQ(kind_in("a.jpg", image), "8-bit RGB");
  EXPECT_EQ(kind_in("a.pfm", image), "float RGB");
  EXPECT_EQ(kind_in("a.png", Image<float>(1, 1, 0.5F)), "8-bit grey");
  EXPECT_EQ(kind_in("b.tga", Image<std::uint16_t>(1, 1)), "8-bit grey");
  EXPECT_EQ(kind_in("b.ppm", Image<std::uint16_t>(1, 1)), "16-bit RGB");
  EXPECT_EQ(read_image<std::uint8_t>(folder / "a.pgm")(0, 0), 76);  // round(0.299 · 255)
}

TEST_F(stage01_image_files, unknown_extension_is_refused) {
  for (const char* name : {"picture", "picture.gif", "picture.", ".png/x"}) {
    try {
      write_image(folder / name, four_corners());
      ADD_FAILURE() << name;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr((folder / name).string()));
    }
  }
}

TEST_F(stage01_image_files, nothing_to_write_is_refused) {
  EXPECT_THROW(write_image(folder / "empty.png", Image<Rgb8>()), InputError);
  EXPECT_THROW(write_image(folder / "wide.jpg", Image<std::uint8_t>(65501, 1)), InputError);
  EXPECT_THROW(write_image(folder / "wide.tga", Image<std::uint8_t>(65536, 1)), InputError);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace rasterlab
