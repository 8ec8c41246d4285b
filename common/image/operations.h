// What one does to a whole picture: turn it over, change its size, show numbers as grey.
#pragma once

#include "common/image/image.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace rasterlab {

/// The first column becomes the last.
template <class Pixel>
Image<Pixel> flipped_horizontally(const Image<Pixel>& image) {
  Image<Pixel> result = image;
  for (int y = 0; y < image.height(); ++y) {
    std::reverse(result.row(y), result.row(y) + image.width());
  }
  return result;
}

/// The top row becomes the bottom one.
template <class Pixel>
Image<Pixel> flipped_vertically(const Image<Pixel>& image) {
  Image<Pixel> result = image;
  for (int y = 0; y < image.height(); ++y) {
    std::copy_n(image.row(y), image.width(), result.row(image.height() - 1 - y));
  }
  return result;
}

/// The picture at another size, larger or smaller: each new pixel is the old one its centre falls
/// into, none is mixed. Throws CheckError when a side is negative, or an empty picture is to become
/// one that is not.
template <class Pixel>
Image<Pixel> resized(const Image<Pixel>& image, int width, int height) {
  if (checked_pixel_count(width, height) == 0) return Image<Pixel>(width, height);
  if (image.empty()) throw CheckError("an empty image cannot be resized to one with pixels");
  // The centre (x + 1/2) · old / new, rounded down in integers.
  const auto source = [](int i, int from, int to) {
    return static_cast<int>((2 * std::int64_t{i} + 1) * from / (2 * std::int64_t{to}));
  };
  Image<Pixel> result(width, height, image(0, 0));
  for (int y = 0; y < height; ++y) {
    const Pixel* from = image.row(source(y, image.height(), height));
    for (int x = 0; x < width; ++x) result.row(y)[x] = from[source(x, image.width(), width)];
  }
  return result;
}

/// Every pixel becomes a block of factor × factor. Throws CheckError for factor < 1.
template <class Pixel>
Image<Pixel> enlarged(const Image<Pixel>& image, int factor) {
  if (factor < 1 ||
      std::max(image.width(), image.height()) > std::numeric_limits<int>::max() / factor) {
    throw CheckError("an image cannot be enlarged by " + std::to_string(factor));
  }
  return resized(image, image.width() * factor, image.height() * factor);
}

/// Copies `part` into `whole`, its top left pixel to (x, y); what would be outside is left out.
template <class Pixel>
void paste(const Image<Pixel>& part, int x, int y, Image<Pixel>& whole) {
  for (int row = 0; row < part.height(); ++row) {
    for (int column = 0; column < part.width(); ++column) {
      if (whole.contains(x + column, y + row)) {
        whole.row(y + row)[x + column] = part.row(row)[column];
      }
    }
  }
}

/// The pictures in rows of `columns`, in reading order, `gap` pixels of `background` between them;
/// each in the top left corner of a cell as large as the largest. Throws CheckError for columns < 1
/// or gap < 0.
template <class Pixel>
Image<Pixel> side_by_side(const std::vector<Image<Pixel>>& pictures, int columns, int gap = 1,
                          const Pixel& background = blank_pixel<Pixel>()) {
  if (columns < 1 || gap < 0) throw CheckError("pictures stand in at least one column");
  if (pictures.empty()) return {};
  const int count = static_cast<int>(pictures.size());
  int width = gap;
  int height = gap;
  for (const Image<Pixel>& picture : pictures) {
    width = std::max(width, picture.width() + gap);
    height = std::max(height, picture.height() + gap);
  }
  const int rows = (count + columns - 1) / columns;
  Image<Pixel> whole(std::min(count, columns) * width - gap, rows * height - gap, background);
  for (int i = 0; i < count; ++i) {
    paste(pictures[static_cast<std::size_t>(i)], i % columns * width, i / columns * height, whole);
  }
  return whole;
}

/// Shows numbers as grey: `black` becomes 0 and `white` 255, linear between, what lies beyond
/// either is clamped to it, NaN becomes 0; either may be the larger. A depth picture with near
/// things bright: grey_picture(depth, far, near). Throws CheckError when `black` and `white` are
/// equal or not finite.
Image<std::uint8_t> grey_picture(const Image<float>& values, float black, float white);

/// The least and the greatest of the values that are finite; {0, 0} where none is.
std::pair<float, float> finite_range(const Image<float>& values);

}  // namespace rasterlab
