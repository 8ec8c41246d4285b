// Reading small mesh files that a test makes up.
#pragma once

#include "common/image/check.h"
#include "common/mesh/read_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <string>
#include <string_view>

namespace rasterlab {

inline Mesh read_as(const std::string& name, std::string_view bytes) {
  return read_mesh_bytes(bytes, name);
}

/// The message with which `bytes` as a file of that name are refused; empty when they are read.
inline std::string refusal(const std::string& name, std::string_view bytes) {
  try {
    read_mesh_bytes(bytes, name);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

inline void replace_all(std::string& text, std::string_view old, std::string_view by) {
  for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += by.size()) {
    text.replace(at, old.size(), by);
  }
}

/// Appends a number's bytes in that order.
template <class Number>
void append(std::string& bytes, Number number, std::endian order = std::endian::little) {
  std::array<char, sizeof(Number)> raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.begin(), raw.end());
}

}  // namespace rasterlab
