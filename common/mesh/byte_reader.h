// Taking numbers out of the bytes of a binary file.
#pragma once

#include "common/image/check.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace rasterlab {

class ByteReader {
 public:
  /// `bytes` must outlive the object; `file` names it in messages.
  ByteReader(std::string_view bytes, std::endian order, std::string file)
      : bytes_(bytes), order_(order), file_(std::move(file)) {}

  /// The next number. Throws InputError at the end of the file.
  template <class Number>
  Number take() {
    std::array<char, sizeof(Number)> raw;
    const std::string_view taken = take_bytes(raw.size());
    std::copy(taken.begin(), taken.end(), raw.begin());
    if (order_ != std::endian::native) std::reverse(raw.begin(), raw.end());
    return std::bit_cast<Number>(raw);
  }

  /// The next bytes as they are. Throws InputError where there are fewer.
  std::string_view take_bytes(std::size_t count) {
    if (bytes_.size() < count) throw InputError(file_ + ": the file ends too early");
    const std::string_view taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
  }

  std::size_t left() const { return bytes_.size(); }

 private:
  std::string_view bytes_;
  std::endian order_;
  std::string file_;
};

}  // namespace rasterlab
