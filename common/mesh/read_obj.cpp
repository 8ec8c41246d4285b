#include "common/mesh/read_obj.h"

#include "common/mesh/mesh_builder.h"
#include "common/mesh/text_lines.h"

#include <array>
#include <cmath>
#include <utility>

namespace rasterlab {
namespace {

using Corner = MeshBuilder::Corner;

/// The greatest index into one of the lists, and where it was used: an index may be used before its
/// element.
struct GreatestIndex {
  const char* what;
  long long index = 0;  ///< counted from 1
  std::size_t line = 0;
};

Eigen::Vector3f no_color() {
  return Eigen::Vector3f::Constant(NAN);
}

class ObjText {
 public:
  ObjText(std::string_view text, const std::string& file)
      : file_(file), lines_(text, file, TextLines::Continuation::backslash) {}

  Mesh read() {
    while (lines_.next()) {
      const std::string_view keyword = lines_.take_word();
      if (keyword == "v") {
        read_position();
      } else if (keyword == "vt") {
        read_uv();
      } else if (keyword == "vn") {
        builder_.normals.push_back(read_vector("three numbers of a normal"));
      } else if (keyword == "f") {
        read_face();
      }
    }
    check(position_, builder_.positions.size());
    check(uv_, builder_.uvs.size());
    check(normal_, builder_.normals.size());
    if (!builder_.colors.empty()) {
      builder_.colors.resize(builder_.positions.size(), no_color());
      builder_.give_each_position(&Corner::color);
      scale_colors(builder_.colors);
    }
    return std::move(builder_).build(file_);
  }

 private:
  Eigen::Vector3f read_vector(std::string_view what) {
    const float x = lines_.require_float(what);
    const float y = lines_.require_float(what);
    const float z = lines_.require_float(what);
    return {x, y, z};
  }

  /// x y z, and perhaps w or a colour or both.
  void read_position() {
    builder_.positions.push_back(read_vector("three coordinates of a vertex"));
    std::array<float, 4> more{};
    std::size_t count = 0;
    while (count < more.size() && !lines_.rest().empty()) more[count++] = *lines_.take_float();
    if (count >= 3) {
      builder_.colors.resize(builder_.positions.size(), no_color());
      builder_.colors.back() = {more[0], more[1], more[2]};
    }
  }

  void read_uv() {
    const float u = lines_.require_float("u and v of a texture coordinate");
    const float v = lines_.take_float().value_or(0);
    builder_.uvs.emplace_back(u, v);
  }

  void read_face() {
    corners_.clear();
    while (!lines_.rest().empty()) corners_.push_back(read_corner(lines_.take_word()));
    if (corners_.empty()) lines_.fail("a face without corners");
    if (corners_.size() >= 3) builder_.add_polygon(corners_);
  }

  /// "v", "v/vt", "v//vn" or "v/vt/vn".
  Corner read_corner(std::string_view word) {
    const std::string_view whole = word;
    Corner corner;
    corner.position = resolve(take_field(word), whole, builder_.positions.size(), position_);
    if (const auto field = take_field(word); !field.empty()) {
      corner.uv = resolve(field, whole, builder_.uvs.size(), uv_);
    }
    if (const auto field = take_field(word); !field.empty()) {
      corner.normal = resolve(field, whole, builder_.normals.size(), normal_);
    }
    return corner;
  }

  static std::string_view take_field(std::string_view& word) {
    const std::string_view field = word.substr(0, word.find('/'));
    word.remove_prefix(std::min(field.size() + 1, word.size()));
    return field;
  }

  /// An index into a list, counted from 1, or back from its end so far with -1; gives it counted
  /// from 0.
  std::uint32_t resolve(std::string_view field, std::string_view corner, std::size_t size,
                        GreatestIndex& greatest) const {
    const auto number = parse_integer(field);
    if (!number)
      lines_.fail(quote(corner) + " is no corner of a face: v, v/vt, v//vn or v/vt/vn expected");
    const auto count = static_cast<long long>(size);
    const long long index = *number < 0 ? count + *number + 1 : *number;
    if (*number == 0 || index < 1 || index > most_elements) {
      lines_.fail("a face refers to " + std::string(greatest.what) + " " + std::to_string(*number) +
                  ", which there is not: " + std::to_string(count) + " are defined so far");
    }
    if (index > greatest.index) {
      greatest.index = index;
      greatest.line = lines_.line();
    }
    return static_cast<std::uint32_t>(index - 1);
  }

  void check(const GreatestIndex& greatest, std::size_t size) const {
    if (greatest.index <= static_cast<long long>(size)) return;
    lines_.fail_at(greatest.line, "a face refers to " + std::string(greatest.what) + " " +
                                      std::to_string(greatest.index) + "; the file has " +
                                      std::to_string(size));
  }

  static constexpr long long most_elements = 0xFFFFFFF0;

  const std::string& file_;
  TextLines lines_;
  MeshBuilder builder_;
  std::vector<Corner> corners_;
  GreatestIndex position_{"vertex"};
  GreatestIndex uv_{"texture coordinate"};
  GreatestIndex normal_{"normal"};
};

}  // namespace

Mesh read_obj(std::string_view text, const std::string& file) {
  return ObjText(text, file).read();
}

}  // namespace rasterlab
