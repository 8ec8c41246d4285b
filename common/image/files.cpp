#include "common/image/files.h"

#include "common/image/convert.h"
#include "common/image/formats.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <utility>

namespace rasterlab {
namespace formats {

void fail(const Source& source, const std::string& what) {
  throw InputError(source.name + ": " + what);
}

void check_size(const Source& source, std::int64_t width, std::int64_t height) {
  const auto limit = static_cast<std::int64_t>(max_pixel_count);
  if (width < 1 || height < 1 || width > limit || height > limit || width * height > limit) {
    fail(source, "claims " + std::to_string(width) + "x" + std::to_string(height) +
                     " pixels, expected 1 to 2^28 in all");
  }
}

void check_not_cut_off(const Source& source, std::uint64_t available, std::uint64_t needed) {
  if (available < needed) {
    fail(source, "cut off: " + std::to_string(available) + " bytes where at least " +
                     std::to_string(needed) + " are expected");
  }
}

}  // namespace formats

namespace {

using formats::Source;

constexpr const char* known_extensions = ".png .jpg .jpeg .tga .pbm .pgm .ppm .pnm .pfm";

std::string lower_case_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".jpeg" ? ".jpg" : extension;
}

// --- Reading: which format it is ---

using Decoder = AnyImage (*)(const Source&);

bool is_netpbm(std::string_view bytes, std::string_view kinds) {
  return bytes.size() > 2 && bytes[0] == 'P' && kinds.find(bytes[1]) != std::string_view::npos &&
         (std::isspace(static_cast<unsigned char>(bytes[2])) != 0 || bytes[2] == '#');
}

bool is_tga(std::string_view bytes, const std::string& extension) {
  return extension == ".tga" || bytes.ends_with(std::string_view("TRUEVISION-XFILE.\0", 18));
}

Decoder decoder_for(std::string_view bytes, const std::string& extension) {
  if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return formats::decode_png;
  if (bytes.starts_with("\xff\xd8\xff")) return formats::decode_jpeg;
  if (is_netpbm(bytes, "123456")) return formats::decode_netpbm;
  if (is_netpbm(bytes, "Ff")) return formats::decode_pfm;
  return is_tga(bytes, extension) ? formats::decode_tga : nullptr;
}

// --- Writing: what each format can hold ---

struct Capacity {
  bool grey = true;
  bool color = true;
  bool alpha = false;
  Depth deepest = Depth::bits8;
  int longest_side = 1 << 20;
};

const std::map<std::string, Capacity> capacities = {
    {".png", {.alpha = true, .deepest = Depth::bits16}},
    {".jpg", {.longest_side = 65500}},
    {".tga", {.alpha = true, .longest_side = 65535}},
    {".pbm", {.color = false}},
    {".pgm", {.color = false, .deepest = Depth::bits16}},
    {".ppm", {.grey = false, .deepest = Depth::bits16}},
    {".pnm", {.deepest = Depth::bits16}},
    {".pfm", {.deepest = Depth::floating}},
};

/// The kind nearest to `kind` that the format can hold.
PixelKind storable(const std::string& extension, const Capacity& capacity, PixelKind kind) {
  if (extension == ".pfm") return {kind.channels == 1 ? 1 : 3, Depth::floating};
  if (kind.depth == Depth::floating || capacity.deepest == Depth::bits8) kind.depth = Depth::bits8;
  if (!capacity.alpha) kind.channels = std::min(kind.channels, 3);
  if (!capacity.color) kind.channels = 1;
  if (!capacity.grey) kind.channels = 3;
  return kind;
}

void check_writable(const std::filesystem::path& path, const Capacity& capacity, int width,
                    int height) {
  if (width == 0 || height == 0) {
    throw InputError(path.string() + ": cannot be written: the image is empty");
  }
  if (std::max(width, height) > capacity.longest_side) {
    throw InputError(path.string() + ": cannot be written: a side of " + std::to_string(width) +
                     "x" + std::to_string(height) + " is longer than the format's " +
                     std::to_string(capacity.longest_side) + " pixels");
  }
}

/// `image` is of a kind the format can hold.
std::string encode(const std::string& extension, const AnyImage& image,
                   const WriteOptions& options) {
  if (extension == ".png") return formats::encode_png(image);
  if (extension == ".jpg") return formats::encode_jpeg(image, options.jpeg_quality);
  if (extension == ".tga") return formats::encode_tga(image, options.run_length);
  if (extension == ".pfm") return formats::encode_pfm(image);
  if (extension == ".pbm") {
    return formats::encode_pbm(std::get<Image<std::uint8_t>>(image), options.text);
  }
  return formats::encode_netpbm(image, options.text);
}

}  // namespace

AnyImage read_any_image(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  const Source source{path.string(), bytes};
  if (bytes.empty()) formats::fail(source, "the file is empty, expected a picture");
  const Decoder decode = decoder_for(bytes, lower_case_extension(path));
  if (decode == nullptr) {
    formats::fail(source,
                  "is no picture of a known format, expected PNG, JPEG, PBM, PGM, PPM, PFM, "
                  "or TGA with the extension .tga");
  }
  return decode(source);
}

template <class Pixel>
Image<Pixel> read_image(const std::filesystem::path& path) {
  AnyImage image = read_any_image(path);
  if (auto* same = std::get_if<Image<Pixel>>(&image)) return std::move(*same);
  return std::visit([](const auto& pixels) { return convert<Pixel>(pixels); }, image);
}

void write_image(const std::filesystem::path& path, const AnyImage& image,
                 const WriteOptions& options) {
  const std::string extension = lower_case_extension(path);
  const auto capacity = capacities.find(extension);
  if (capacity == capacities.end()) {
    throw InputError(path.string() +
                     ": cannot be written: the extension tells the format, expected " +
                     known_extensions);
  }
  check_writable(path, capacity->second, width_of(image), height_of(image));
  const PixelKind kind = storable(extension, capacity->second, kind_of(image));
  const std::string bytes = encode(extension, convert(image, kind), options);
  if (bytes.empty()) throw InputError(path.string() + ": cannot be written in this format");
  write_file(path, bytes);
}

template <class Pixel>
void write_image(const std::filesystem::path& path, const Image<Pixel>& image,
                 const WriteOptions& options) {
  write_image(path, AnyImage(image), options);
}

#define RASTERLAB_FILES(Pixel)                                    \
  template Image<Pixel> read_image(const std::filesystem::path&); \
  template void write_image(const std::filesystem::path&, const Image<Pixel>&, const WriteOptions&);
RASTERLAB_FILES(std::uint8_t)
RASTERLAB_FILES(std::uint16_t)
RASTERLAB_FILES(Rgb8)
RASTERLAB_FILES(Rgb16)
RASTERLAB_FILES(Rgba8)
RASTERLAB_FILES(Rgba16)
RASTERLAB_FILES(float)
RASTERLAB_FILES(Color)

}  // namespace rasterlab
