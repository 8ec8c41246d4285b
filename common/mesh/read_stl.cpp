#include "common/mesh/read_stl.h"

#include "common/image/check.h"
#include "common/mesh/byte_reader.h"
#include "common/mesh/mesh_builder.h"
#include "common/mesh/text_lines.h"

#include <array>
#include <cctype>
#include <optional>
#include <utility>

namespace rasterlab {
namespace {

using Corner = MeshBuilder::Corner;

constexpr std::size_t head_size = 84;  // a title of 80 bytes and the count of faces
constexpr std::size_t face_size = 50;  // normal, three corners, two bytes of no fixed meaning

std::optional<std::uint32_t> promised_faces(std::string_view bytes) {
  if (bytes.size() < head_size) return std::nullopt;
  return ByteReader(bytes.substr(80), std::endian::little, "").take<std::uint32_t>();
}

bool has_promised_size(std::string_view bytes) {
  const auto faces = promised_faces(bytes);
  return faces && bytes.size() == head_size + face_size * *faces;
}

std::string lower_case(std::string_view word) {
  std::string result(word);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

bool begins_with_solid(std::string_view bytes) {
  TextLines lines(bytes.substr(0, 256), "");
  return lines.next() && lower_case(lines.take_word()) == "solid";
}

/// Polygons of which each corner brought its own position.
Mesh build(MeshBuilder&& builder, const std::string& file) {
  const std::vector<std::uint32_t> joined = join_by_position(builder.positions);
  builder.renumber_positions(joined);
  return std::move(builder).build(file);
}

void add_corner(MeshBuilder& builder, std::vector<Corner>& polygon, float x, float y, float z) {
  polygon.push_back({.position = static_cast<std::uint32_t>(builder.positions.size())});
  builder.positions.emplace_back(x, y, z);
}

Mesh read_binary(std::string_view bytes, const std::string& file) {
  const auto faces = promised_faces(bytes);
  if (!faces)
    throw InputError(file + ": an STL file has at least 84 bytes, this one " +
                     std::to_string(bytes.size()));
  const std::size_t room = (bytes.size() - head_size) / face_size;
  if (room < *faces) {
    throw InputError(file + ": the header promises " + std::to_string(*faces) +
                     " faces, but the file ends after " + std::to_string(room));
  }
  MeshBuilder builder;
  std::vector<Corner> polygon;
  for (std::size_t i = 0; i < *faces; ++i) {
    ByteReader face(bytes.substr(head_size + face_size * i, face_size), std::endian::little, file);
    for (int skipped = 0; skipped < 3; ++skipped) face.take<float>();
    polygon.clear();
    for (int corner = 0; corner < 3; ++corner) {
      const auto x = face.take<float>();
      const auto y = face.take<float>();
      const auto z = face.take<float>();
      add_corner(builder, polygon, x, y, z);
    }
    builder.add_polygon(polygon);
  }
  return build(std::move(builder), file);
}

Mesh read_text(std::string_view text, const std::string& file) {
  TextLines lines(text, file);
  MeshBuilder builder;
  std::vector<Corner> polygon;
  bool in_loop = false;
  while (lines.next()) {
    const std::string keyword = lower_case(lines.take_word());
    if (keyword == "outer") {
      polygon.clear();
      in_loop = true;
    } else if (keyword == "vertex") {
      const auto x = lines.require_float("three coordinates of a vertex");
      const auto y = lines.require_float("three coordinates of a vertex");
      const auto z = lines.require_float("three coordinates of a vertex");
      add_corner(builder, polygon, x, y, z);
    } else if (keyword == "endloop") {
      if (polygon.size() < 3)
        lines.fail("a face of " + std::to_string(polygon.size()) + " corners");
      builder.add_polygon(polygon);
      in_loop = false;
    }
  }
  if (in_loop) lines.fail("the file ends within a face");
  return build(std::move(builder), file);
}

}  // namespace

bool looks_like_stl(std::string_view bytes) {
  return has_promised_size(bytes) || begins_with_solid(bytes);
}

Mesh read_stl(std::string_view bytes, const std::string& file) {
  if (!has_promised_size(bytes) && begins_with_solid(bytes)) return read_text(bytes, file);
  return read_binary(bytes, file);
}

}  // namespace rasterlab
