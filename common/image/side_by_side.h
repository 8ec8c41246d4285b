// Several pictures in one, to be compared.
#pragma once

#include "common/image/image.h"

#include <algorithm>
#include <vector>

namespace rasterlab {

/// The pictures in rows of `columns`, in reading order, `gap` pixels of `background` between them.
/// Each cell is as large as the largest picture; smaller ones are in its top left corner. Throws
/// CheckError for columns < 1 or a negative gap.
template <class Pixel>
Image<Pixel> side_by_side(const std::vector<Image<Pixel>>& pictures, int columns, int gap,
                          const Pixel& background) {
  if (columns < 1 || gap < 0)
    throw CheckError("pictures side by side need at least one column and no negative gap");
  int width = 0;
  int height = 0;
  for (const Image<Pixel>& picture : pictures) {
    width = std::max(width, picture.width());
    height = std::max(height, picture.height());
  }
  const int count = static_cast<int>(pictures.size());
  const int used_columns = std::min(columns, count);
  const int rows = (count + columns - 1) / columns;
  if (count == 0) return {};
  Image<Pixel> result(used_columns * (width + gap) - gap, rows * (height + gap) - gap, background);
  for (int i = 0; i < count; ++i) {
    const Image<Pixel>& picture = pictures[static_cast<std::size_t>(i)];
    for (int y = 0; y < picture.height(); ++y) {
      std::copy_n(picture.row(y), picture.width(),
                  result.row(i / columns * (height + gap) + y) + i % columns * (width + gap));
    }
  }
  return result;
}

}  // namespace rasterlab
