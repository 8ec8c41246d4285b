// What is no picture: cut off, lying about its size, noise, no file at all. Each must end in one
// InputError that names the file, promptly, and with little memory.
#include "common/image/files.h"

#include "tests/image/corners.h"
#include "tests/support/scratch.h"

#include <random>

#include <gmock/gmock.h>
#include <sys/resource.h>

namespace rasterlab {
namespace {

using testing::HasSubstr;

/// While it lives, a large allocation fails: what a lying header would ask for.
class MemoryLimit {
 public:
  explicit MemoryLimit(rlim_t bytes) {
    getrlimit(RLIMIT_AS, &before_);
    const rlimit limit{used() + bytes, before_.rlim_max};
    setrlimit(RLIMIT_AS, &limit);
  }
  ~MemoryLimit() { setrlimit(RLIMIT_AS, &before_); }
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;

 private:
  static rlim_t used() {
    std::ifstream statm("/proc/self/statm");
    rlim_t pages = 0;
    statm >> pages;
    return pages * 4096;
  }
  rlimit before_{};
};

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;  // The sanitizers' own address space has no limit.
#else
constexpr bool sanitized = false;
#endif

class stage01_image_bad_files : public testing::Test {
 protected:
  /// The message of the InputError that reading gives; empty when the file is read after all.
  std::string error_of(const std::string& name, const std::string& content) {
    std::filesystem::remove(folder / name);  // Overwriting makes ext4 wait for the disk.
    std::ofstream(folder / name, std::ios::binary) << content;
    return error_of(folder / name);
  }
  static std::string error_of(const std::filesystem::path& path) {
    try {
      read_any_image(path);
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith(path.string() + ": "));
      EXPECT_THAT(error.what(), testing::Not(HasSubstr("\n")));
      return error.what();
    }
    return {};
  }

  std::string encoded(const std::string& name, const AnyImage& image,
                      const WriteOptions& options = {}) {
    write_image(folder / name, image, options);
    return read_file(folder / name);
  }

  /// Every proper beginning of the file is an error, but that a text's last number may lose digits
  /// and its end white space.
  void expect_cuts_are_errors(const std::string& name, const std::string& whole,
                              bool text = false) {
    std::size_t tolerated = 0;
    for (std::size_t length = 0; length < whole.size(); ++length) {
      const bool is_error = !error_of(name, whole.substr(0, length)).empty();
      const bool at_last_number = text && whole.find_first_of(" \t\n", length) >= whole.size() - 3;
      if (!is_error && at_last_number) ++tolerated;
      EXPECT_TRUE(is_error || at_last_number) << name << " cut after " << length << " bytes";
    }
    EXPECT_LE(tolerated, 6U);
  }

  ScratchFolder folder;
};

TEST_F(stage01_image_bad_files, cut_anywhere) {
  const Image<Rgb8> colors = many_colors(5, 4);
  const Image<std::uint16_t> deep(3, 2, 40000);
  const Image<std::uint8_t> bits(9, 3, 255);
  for (const bool text : {false, true}) {
    expect_cuts_are_errors("a.ppm", encoded("a.ppm", colors, {.text = text}), text);
    expect_cuts_are_errors("a.pgm", encoded("a.pgm", deep, {.text = text}), text);
    expect_cuts_are_errors("a.pbm", encoded("a.pbm", bits, {.text = text}), text);
  }
  for (const bool run_length : {false, true}) {
    expect_cuts_are_errors("a.tga", encoded("a.tga", colors, {.run_length = run_length}));
    expect_cuts_are_errors("a.tga", encoded("a.tga", four_corners(), {.run_length = run_length}));
  }
  expect_cuts_are_errors("a.pfm", encoded("a.pfm", Image<float>(3, 2)));
  expect_cuts_are_errors("a.pfm", encoded("a.pfm", Image<Color>(3, 2)));
  expect_cuts_are_errors("a.png", encoded("a.png", colors));
  expect_cuts_are_errors("a.png", encoded("a.png", Image<Rgba16>(3, 2)));
  expect_cuts_are_errors("a.jpg", encoded("a.jpg", colors));
}

TEST_F(stage01_image_bad_files, one_byte_changed_never_crashes) {
  std::mt19937 random(3);
  for (const char* name : {"a.png", "a.jpg", "a.tga", "a.ppm", "a.pfm"}) {
    const std::string whole = encoded(name, many_colors(9, 7));
    for (std::size_t i = 0; i < whole.size(); ++i) {
      std::string changed = whole;
      changed[i] = static_cast<char>(random());
      error_of(name, changed);  // An error or a picture.
    }
  }
}

TEST_F(stage01_image_bad_files, noise_never_crashes) {
  std::mt19937 random(5);
  const std::vector<std::string> beginnings = {
      "",    "P1 ",          "P2\n",         "P3 9 9 255 ",      "P4 3 3\n", "P5 ", "P6 2 2 255\n",
      "Pf ", "PF\n3 3 -1\n", "\xff\xd8\xff", "\x89PNG\r\n\x1a\n"};
  for (int i = 0; i < 3000; ++i) {
    std::string noise = beginnings[random() % beginnings.size()];
    for (std::size_t size = random() % 200; size > 0; --size) noise += static_cast<char>(random());
    error_of(i % 2 == 0 ? "noise.tga" : "noise", noise);
  }
}

TEST_F(stage01_image_bad_files, no_picture_at_all) {
  EXPECT_THAT(error_of(folder / "missing.png"), HasSubstr("No such file"));
  EXPECT_THAT(error_of(folder.path()), HasSubstr("folder"));
  EXPECT_THAT(error_of("empty.png", ""), HasSubstr("empty"));
  EXPECT_THAT(error_of("text.png", "hello"), HasSubstr("expected PNG, JPEG"));
  EXPECT_THAT(error_of("text.tga", "hello, this is no TGA file, just text"),
              HasSubstr("not a TGA"));
  EXPECT_THAT(error_of("gif.png", "GIF89a................"), HasSubstr("expected PNG, JPEG"));
  EXPECT_THAT(error_of("/dev/null"), HasSubstr("empty"));
}

TEST_F(stage01_image_bad_files, text_formats_name_the_line) {
  EXPECT_THAT(error_of("a.pgm", "P2\n# size\n2 x\n255\n1 2\n"),
              HasSubstr("line 3: found 'x', expected the height"));
  EXPECT_THAT(error_of("a.pgm", "P2\n2 2\n255\n1 2\n3 four\n"), HasSubstr("line 5: found 'four'"));
  EXPECT_THAT(error_of("a.pgm", "P2\n2 2\n255\n1 2\n3 -4\n"), HasSubstr("line 5: found '-4'"));
  EXPECT_THAT(error_of("a.pbm", "P1\n2 2\n10\n12\n"),
              HasSubstr("line 4: expected a pixel, 0 or 1"));
  EXPECT_THAT(error_of("a.pgm", "P2\n2 2\n0\n0 0 0 0\n"), HasSubstr("the maximum is 0"));
  EXPECT_THAT(error_of("a.pgm", "P2\n2 2\n65536\n0 0 0 0\n"), HasSubstr("expected 1 to 65535"));
  EXPECT_THAT(error_of("a.pgm", "P2\n1 1\n100\n101\n"), HasSubstr("101"));
  EXPECT_THAT(error_of("a.pgm", "P5\n1 1\n100\nz"), HasSubstr("122"));
  EXPECT_THAT(error_of("a.pfm", "Pf\n1 1\n0\nabcd"), HasSubstr("scale is 0"));
}

TEST_F(stage01_image_bad_files, sizes_that_cannot_be) {
  for (const char* size : {"0 5", "5 0", "-3 5", "16385 16384", "268435457 1", "4294967296 1",
                           "4294967297 4294967297", "99999999999999999999 1"}) {
    for (const char* magic : {"P1", "P2", "P3", "P4", "P5", "P6", "Pf", "PF"}) {
      EXPECT_NE(error_of("a.ppm", std::string(magic) + "\n" + size + "\n255\nabcdefgh"), "")
          << magic << " " << size;
    }
  }
  EXPECT_THAT(error_of("a.ppm", "P6 16385 16384 255\nx"), HasSubstr("claims 16385x16384 pixels"));
}

void put_big_endian(std::string& content, std::size_t position, std::uint32_t value, int count) {
  for (int i = 0; i < count; ++i) {
    content[position + static_cast<std::size_t>(i)] =
        static_cast<char>(value >> 8 * (count - 1 - i) & 255U);
  }
}

/// A PNG's chunk checksum: CRC-32 of type and data.
std::uint32_t checksum(std::string_view data) {
  std::uint32_t crc = 0xFFFFFFFF;
  for (const char c : data) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

TEST_F(stage01_image_bad_files, header_lies_allocate_nothing) {
  std::vector<std::pair<std::string, std::string>> files;
  for (const char* magic : {"P2", "P3", "P5", "P6"}) {
    files.emplace_back("a.ppm", std::string(magic) + " 16384 16384 255\n1 2 3 4 5 6 7 8 9");
  }
  files.emplace_back("a.pbm", "P1 16384 16384\n1 0 1");
  files.emplace_back("a.pbm", "P4 16384 16384\n1234");
  files.emplace_back("a.pfm", "PF 16384 16384 -1\n123456789abc");
  std::string png = encoded("a.png", many_colors(8, 8));
  put_big_endian(png, 16, 16384, 4);
  put_big_endian(png, 20, 16384, 4);
  put_big_endian(png, 29, checksum(std::string_view(png).substr(12, 17)), 4);
  files.emplace_back("a.png", png);
  std::string jpeg = encoded("a.jpg", many_colors(8, 8));
  const std::size_t frame = jpeg.find("\xff\xc0");
  ASSERT_NE(frame, std::string::npos);
  put_big_endian(jpeg, frame + 5, 16384, 2);
  put_big_endian(jpeg, frame + 7, 16384, 2);
  files.emplace_back("a.jpg", jpeg);
  for (const bool run_length : {false, true}) {
    std::string tga = encoded("a.tga", many_colors(8, 8), {.run_length = run_length});
    tga[13] = 0x40;  // width 16392
    tga[15] = 0x3F;  // height 16136
    files.emplace_back("a.tga", tga);
  }
  for (const auto& [name, content] : files) {
    write_file(folder / name, content);
    const MemoryLimit limit(sanitized ? RLIM_INFINITY / 2 : 64 << 20);
    EXPECT_THAT(error_of(folder / name), HasSubstr("cut off")) << name;
  }
}

TEST_F(stage01_image_bad_files, damaged_data_with_whole_structure) {
  std::string png = encoded("a.png", many_colors(40, 40));
  png[png.size() / 2] ^= 0x55;
  EXPECT_THAT(error_of("a.png", png), HasSubstr("damaged"));
  std::string jpeg = encoded("a.jpg", many_colors(64, 64));
  const std::size_t scan = jpeg.find("\xff\xda") + 14;
  jpeg.erase(scan + 40, jpeg.size() - scan - 42);  // keeps the end-of-image marker
  EXPECT_THAT(error_of("a.jpg", jpeg), HasSubstr("damaged"));
}

TEST_F(stage01_image_bad_files, jpeg_scans_that_never_end) {
  std::string jpeg = encoded("a.jpg", many_colors(64, 64));
  const std::size_t frame = jpeg.find("\xff\xc0");
  put_big_endian(jpeg, frame + 5, 2048, 2);
  put_big_endian(jpeg, frame + 7, 2048, 2);
  const std::string scan_header = jpeg.substr(jpeg.find("\xff\xda"), 14);
  const auto with_scans = [&](int count) {
    std::string many = jpeg.substr(0, jpeg.size() - 2);
    for (int i = 1; i < count; ++i) many += scan_header;
    return error_of("a.jpg", many + "\xff\xd9");
  };
  EXPECT_THAT(with_scans(4096), HasSubstr("damaged"));
  EXPECT_THAT(with_scans(4097), HasSubstr("has 4097 scans of 2048x2048 pixels"));
}

TEST_F(stage01_image_bad_files, tga_headers_that_cannot_be) {
  const std::string whole = encoded("a.tga", many_colors(4, 4), {.run_length = false});
  const auto with = [&](std::size_t position, int value) {
    std::string changed = whole;
    changed[position] = static_cast<char>(value);
    return error_of("a.tga", changed);
  };
  EXPECT_THAT(with(2, 0), HasSubstr("type is 0"));
  EXPECT_THAT(with(2, 32), HasSubstr("type is 32"));
  EXPECT_THAT(with(1, 2), HasSubstr("not a TGA"));
  EXPECT_THAT(with(16, 8), HasSubstr("8 bits a pixel, expected 15, 16, 24 or 32"));
  EXPECT_THAT(with(2, 3), HasSubstr("24 bits a pixel, expected 8 or 16"));
  EXPECT_THAT(with(12, 0), HasSubstr("claims 0x4"));
}

TEST_F(stage01_image_bad_files, nothing_is_printed) {
  const std::string png = encoded("a.png", many_colors(30, 30));
  const std::string jpeg = encoded("a.jpg", many_colors(30, 30));
  testing::internal::CaptureStderr();
  for (std::size_t i = 0; i < png.size(); i += 7) {
    std::string changed = png;
    changed[i] ^= 0x11;
    error_of("a.png", changed);
  }
  for (std::size_t i = 0; i < jpeg.size(); i += 3) {
    std::string changed = jpeg;
    changed[i] ^= 0x11;
    error_of("a.jpg", changed);
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace rasterlab
