// PNG and JPEG through OpenCV. Its readers take much on trust, so a file's structure is checked
// first: that it is whole, and that its bytes can be as many pixels as it claims.
#include "common/image/formats.h"
#include "common/image/opencv_library.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <mutex>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <sys/mman.h>
#include <unistd.h>

namespace rasterlab::formats {
namespace {

/// Keeps what libraries print to standard error, as libpng and libjpeg do, from the user; one at a
/// time in the process.
class CapturedStandardError {
 public:
  CapturedStandardError() : lock_(mutex()), file_(memfd_create("stderr", MFD_CLOEXEC)) {
    std::fflush(stderr);
    before_ = dup(STDERR_FILENO);
    if (file_ >= 0 && before_ >= 0) dup2(file_, STDERR_FILENO);
  }
  ~CapturedStandardError() {
    std::fflush(stderr);
    if (before_ >= 0) {
      dup2(before_, STDERR_FILENO);
      close(before_);
    }
    if (file_ >= 0) close(file_);
  }
  CapturedStandardError(const CapturedStandardError&) = delete;
  CapturedStandardError& operator=(const CapturedStandardError&) = delete;

  /// How what was printed starts.
  std::string start() const {
    std::fflush(stderr);
    char text[512];
    const ssize_t size = file_ < 0 ? 0 : pread(file_, text, sizeof text, 0);
    return {text, size < 0 ? 0 : static_cast<std::size_t>(size)};
  }

 private:
  static std::mutex& mutex() {
    static std::mutex one;
    return one;
  }

  std::scoped_lock<std::mutex> lock_;
  int file_ = -1;
  int before_ = -1;
};

std::string first_line(std::string_view text) {
  return std::string(text.substr(0, text.find('\n')));
}

unsigned byte_at(std::string_view bytes, std::size_t i) {
  return static_cast<unsigned char>(bytes[i]);
}

std::uint32_t big_endian(std::string_view bytes, std::size_t position, int count) {
  std::uint32_t value = 0;
  for (int i = 0; i < count; ++i) {
    value = value << 8 | byte_at(bytes, position + static_cast<std::size_t>(i));
  }
  return value;
}

/// What a file says of its picture before the pixels.
struct Claim {
  std::int64_t width = 0;
  std::int64_t height = 0;
  std::uint64_t least_bytes = 0;  ///< the least that so many pixels can be compressed to
};

void check_claim(const Source& source, const Claim& claim, std::uint64_t compressed_bytes) {
  check_size(source, claim.width, claim.height);
  if (std::max(claim.width, claim.height) > 1 << 20) {
    fail(source, "a side is longer than 2^20 pixels, more than OpenCV reads");
  }
  check_not_cut_off(source, compressed_bytes, claim.least_bytes);
}

// --- PNG (https://www.w3.org/TR/png/) ---

Claim png_claim(const Source& source) {
  const std::string_view bytes = source.bytes;
  if (bytes.size() < 33 || bytes.substr(12, 4) != "IHDR") {
    fail(source, "cut off or damaged: a PNG file starts with an IHDR chunk");
  }
  constexpr std::array<unsigned, 7> channels_of_color_type = {1, 1, 3, 1, 2, 1, 4};
  Claim claim{big_endian(bytes, 16, 4), big_endian(bytes, 20, 4)};
  const unsigned depth = byte_at(bytes, 24);
  const unsigned channels = channels_of_color_type[std::min(byte_at(bytes, 25), 6U)];
  check_size(source, claim.width, claim.height);
  const auto row_bits = static_cast<std::uint64_t>(claim.width) * depth * channels;
  const auto height = static_cast<std::uint64_t>(claim.height);
  claim.least_bytes = height * (1 + row_bits / 8) / 1032;  // Deflate packs at most 1032 to 1.
  return claim;
}

/// Walks over the chunks to the last, IEND.
void check_png(const Source& source) {
  const Claim claim = png_claim(source);
  const std::string_view bytes = source.bytes;
  std::uint64_t compressed = 0;
  for (std::size_t position = 8;;) {
    check_not_cut_off(source, bytes.size(), position + 12);
    const std::uint64_t length = big_endian(bytes, position, 4);
    const std::string_view type = bytes.substr(position + 4, 4);
    check_not_cut_off(source, bytes.size(), position + 12 + length);
    if (type == "IEND") break;
    if (type == "IDAT") compressed += length;
    position += 12 + length;
  }
  check_claim(source, claim, compressed);
}

// --- JPEG (ITU-T T.81) ---

bool is_frame_header(unsigned marker) {
  return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

Claim jpeg_claim(const Source& source, unsigned marker, std::string_view frame) {
  check_not_cut_off(source, frame.size(), 6);
  const unsigned components = byte_at(frame, 5);
  check_not_cut_off(source, frame.size(), 6 + 3 * components);
  Claim claim{big_endian(frame, 3, 2), big_endian(frame, 1, 2)};
  unsigned horizontal = 1;
  unsigned vertical = 1;
  for (unsigned i = 0; i < components; ++i) {
    const unsigned sampling = byte_at(frame, 7 + 3 * i);
    horizontal = std::max(horizontal, sampling >> 4);
    vertical = std::max(vertical, sampling & 15U);
  }
  const bool huffman_coded = marker < 0xC9;
  if (huffman_coded) {  // A block of pixels takes at least one bit.
    const auto blocks = [](std::int64_t side, unsigned factor) {
      return static_cast<std::uint64_t>(side) / (8 * factor);
    };
    claim.least_bytes = blocks(claim.width, horizontal) * blocks(claim.height, vertical) / 8;
  }
  return claim;
}

/// The position of the next marker's code: what follows bytes 0xFF and is none of them, nor, within
/// compressed data, a stuffed 0 or a restart marker.
std::size_t next_marker(const Source& source, std::size_t position) {
  const std::string_view bytes = source.bytes;
  for (; position + 1 < bytes.size(); ++position) {
    const unsigned code = byte_at(bytes, position + 1);
    const bool marks_nothing = code == 0 || code == 0xFF || (code >= 0xD0 && code <= 0xD7);
    if (byte_at(bytes, position) == 0xFF && !marks_nothing) return position + 1;
  }
  fail(source, "cut off: the end-of-image marker of a JPEG file is missing");
}

/// A scan without content takes a few bytes and costs a pass over all pixels: a small file can keep
/// a reader busy for hours. Pictures that are built up gradually have 10 to 20 scans.
void check_scans(const Source& source, const Claim& claim, std::int64_t scans) {
  constexpr std::int64_t most_pixels = std::int64_t{1} << 34;  // 64 scans of the largest picture
  if (scans > most_pixels / (claim.width * claim.height)) {
    fail(source, "has " + std::to_string(scans) + " scans of " + std::to_string(claim.width) + "x" +
                     std::to_string(claim.height) + " pixels, expected at most 2^34 pixels in all");
  }
}

/// Walks over the segments to the last marker, end of image.
void check_jpeg(const Source& source) {
  const std::string_view bytes = source.bytes;
  std::optional<Claim> claim;
  std::int64_t scans = 0;
  for (std::size_t position = 2;;) {
    position = next_marker(source, position);
    const unsigned marker = byte_at(bytes, position++);
    if (marker == 0xD9) break;
    check_not_cut_off(source, bytes.size(), position + 2);
    const std::size_t length = std::max(big_endian(bytes, position, 2), 2U);
    check_not_cut_off(source, bytes.size(), position + length);
    if (marker == 0xDA) ++scans;
    if (is_frame_header(marker) && !claim) {
      claim = jpeg_claim(source, marker, bytes.substr(position + 2, length - 2));
    }
    position += length;
  }
  if (!claim) fail(source, "damaged: a JPEG file needs a frame header");
  check_claim(source, *claim, bytes.size());
  check_scans(source, *claim, scans);
}

/// Whether libjpeg's complaint means that pixels were lost.
bool tells_of_lost_pixels(const std::string& line) {
  return std::ranges::any_of(
      std::initializer_list<std::string_view>{"remature end", "bad Huffman", "instead of RST"},
      [&](std::string_view words) { return line.find(words) != std::string::npos; });
}

// --- Between OpenCV's pictures and ours ---

template <class Pixel>
constexpr int opencv_type() {
  constexpr PixelKind kind = pixel_kind<Pixel>;
  return CV_MAKETYPE(kind.depth == Depth::bits8    ? CV_8U
                     : kind.depth == Depth::bits16 ? CV_16U
                                                   : CV_32F,
                     kind.channels);
}

template <class Pixel>
AnyImage from_opencv(const cv::Mat& picture) {
  constexpr int channels = pixel_kind<Pixel>.channels;
  Image<Pixel> image(picture.cols, picture.rows);
  cv::Mat pixels(picture.rows, picture.cols, opencv_type<Pixel>(), image.row(0));
  if constexpr (channels == 1) {
    picture.copyTo(pixels);
  } else {
    cv::cvtColor(picture, pixels, channels == 3 ? cv::COLOR_BGR2RGB : cv::COLOR_BGRA2RGBA);
  }
  return image;
}

AnyImage from_opencv(const Source& source, const cv::Mat& picture) {
  switch (picture.type()) {
    case CV_8UC1:
      return from_opencv<std::uint8_t>(picture);
    case CV_8UC3:
      return from_opencv<Rgb8>(picture);
    case CV_8UC4:
      return from_opencv<Rgba8>(picture);
    case CV_16UC1:
      return from_opencv<std::uint16_t>(picture);
    case CV_16UC3:
      return from_opencv<Rgb16>(picture);
    case CV_16UC4:
      return from_opencv<Rgba16>(picture);
    default:
      fail(source, "its kind of pixel is unknown");
  }
}

template <class Pixel>
cv::Mat to_opencv(const Image<Pixel>& image) {
  cv::Mat pixels(image.height(), image.width(), opencv_type<Pixel>(),
                 const_cast<Pixel*>(image.row(0)));  // NOLINT: only read
  constexpr int channels = pixel_kind<Pixel>.channels;
  if (channels == 1) return pixels;
  cv::Mat swapped;
  cv::cvtColor(pixels, swapped, channels == 3 ? cv::COLOR_RGB2BGR : cv::COLOR_RGBA2BGRA);
  return swapped;
}

struct Codecs {
  OpenCvLibrary library{RASTERLAB_OPENCV_CODECS};
  decltype(cv::imencode)* encode = library.function<decltype(cv::imencode)>(
      "imencode",
      std::string(OpenCvLibrary::string) + "RKNS_11_InputArrayERSt6vectorIhSaIhEERKSB_IiSaIiEE");
  cv::Mat (*decode)(cv::InputArray,
                    int) = library.function<cv::Mat(cv::InputArray, int)>("imdecode",
                                                                          "RKNS_11_InputArrayEi");
};

const Codecs& codecs() {
  static const Codecs loaded;
  return loaded;
}

AnyImage decode_by_opencv(const Source& source, const char* format, int flags) {
  cv::Mat picture;
  std::string complaint;
  try {
    const CapturedStandardError captured;
    const cv::Mat bytes(1, static_cast<int>(source.bytes.size()), CV_8U,
                        const_cast<char*>(source.bytes.data()));  // NOLINT: only read
    picture = codecs().decode(bytes, flags);
    complaint = first_line(captured.start());
  } catch (const std::exception& error) {
    complaint = first_line(error.what());
  }
  if (picture.empty() || tells_of_lost_pixels(complaint)) {
    fail(source, std::string("damaged: its ") + format + " data cannot be decoded" +
                     (complaint.empty() ? "" : " (" + complaint + ")"));
  }
  return from_opencv(source, picture);
}

std::string encode_by_opencv(const char* extension, const AnyImage& image,
                             const std::vector<int>& parameters) {
  const cv::Mat picture = std::visit([](const auto& pixels) { return to_opencv(pixels); }, image);
  std::vector<unsigned char> bytes;
  const CapturedStandardError captured;
  if (!codecs().encode(extension, picture, bytes, parameters)) return {};
  return {bytes.begin(), bytes.end()};
}

}  // namespace

AnyImage decode_png(const Source& source) {
  check_png(source);
  return decode_by_opencv(source, "PNG", cv::IMREAD_UNCHANGED);
}

AnyImage decode_jpeg(const Source& source) {
  check_jpeg(source);
  // Unlike IMREAD_UNCHANGED, these turn the picture as a camera's orientation mark says.
  return decode_by_opencv(source, "JPEG", cv::IMREAD_ANYCOLOR | cv::IMREAD_ANYDEPTH);
}

std::string encode_png(const AnyImage& image) {
  // By default OpenCV compresses less, to files up to 4 times as large.
  return encode_by_opencv(".png", image, {cv::IMWRITE_PNG_COMPRESSION, 6});
}

std::string encode_jpeg(const AnyImage& image, int quality) {
  return encode_by_opencv(".jpg", image, {cv::IMWRITE_JPEG_QUALITY, quality});
}

}  // namespace rasterlab::formats
