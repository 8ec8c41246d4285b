#include "common/mesh/read_ply.h"

#include "common/image/check.h"
#include "common/mesh/byte_reader.h"
#include "common/mesh/mesh_builder.h"
#include "common/mesh/text_lines.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

namespace rasterlab {
namespace {

using Corner = MeshBuilder::Corner;

// ---- Header

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::optional<Type> parse_type(std::string_view word) {
  static const std::map<std::string_view, Type> types = {
      {"char", Type::int8},      {"int8", Type::int8},       {"uchar", Type::uint8},
      {"uint8", Type::uint8},    {"short", Type::int16},     {"int16", Type::int16},
      {"ushort", Type::uint16},  {"uint16", Type::uint16},   {"int", Type::int32},
      {"int32", Type::int32},    {"uint", Type::uint32},     {"uint32", Type::uint32},
      {"float", Type::float32},  {"float32", Type::float32}, {"double", Type::float64},
      {"float64", Type::float64}};
  const auto found = types.find(word);
  return found == types.end() ? std::nullopt : std::optional(found->second);
}

/// What a property is for.
enum class Role { x, y, z, nx, ny, nz, red, green, blue, u, v, corners, corner_uvs, other };
constexpr std::size_t role_count = static_cast<std::size_t>(Role::other) + 1;

Role role_of(std::string_view name) {
  static const std::map<std::string_view, Role> roles = {
      {"x", Role::x},
      {"y", Role::y},
      {"z", Role::z},
      {"nx", Role::nx},
      {"ny", Role::ny},
      {"nz", Role::nz},
      {"red", Role::red},
      {"green", Role::green},
      {"blue", Role::blue},
      {"r", Role::red},
      {"g", Role::green},
      {"b", Role::blue},
      {"diffuse_red", Role::red},
      {"diffuse_green", Role::green},
      {"diffuse_blue", Role::blue},
      {"u", Role::u},
      {"v", Role::v},
      {"s", Role::u},
      {"t", Role::v},
      {"texture_u", Role::u},
      {"texture_v", Role::v},
      {"texcoord_u", Role::u},
      {"texcoord_v", Role::v},
      {"vertex_indices", Role::corners},
      {"vertex_index", Role::corners},
      {"texcoord", Role::corner_uvs},
  };
  const auto found = roles.find(name);
  return found == roles.end() ? Role::other : found->second;
}

struct Property {
  Role role = Role::other;
  Type type = Type::float32;
  std::optional<Type> count_type;  ///< of a list
};

struct Element {
  std::string name;
  long long count = 0;
  std::vector<Property> properties;

  bool has(Role role) const {
    return std::any_of(properties.begin(), properties.end(),
                       [&](const Property& property) { return property.role == role; });
  }
};

enum class Format { text, little_endian, big_endian };

struct Header {
  Format format = Format::text;
  std::vector<Element> elements;
  std::size_t lines = 0;
  std::string_view body;
};

class HeaderText {
 public:
  HeaderText(std::string_view bytes, const std::string& file)
      : bytes_(bytes), lines_(bytes, file) {}

  Header read() {
    if (!lines_.next() || lines_.take_word() != "ply")
      lines_.fail("a PLY file begins with the line 'ply'");
    while (true) {
      if (!lines_.next()) lines_.fail("the file ends in its header, before 'end_header'");
      const std::string_view keyword = lines_.take_word();
      if (keyword == "end_header") break;
      if (keyword == "format") {
        read_format();
      } else if (keyword == "element") {
        read_element();
      } else if (keyword == "property") {
        read_property();
      }
    }
    header_.lines = lines_.line();
    header_.body = bytes_.substr(bytes_.size() - lines_.bytes_left());
    return header_;
  }

 private:
  void read_format() {
    const std::string_view word = lines_.take_word();
    if (word == "ascii") {
      header_.format = Format::text;
    } else if (word == "binary_little_endian") {
      header_.format = Format::little_endian;
    } else if (word == "binary_big_endian") {
      header_.format = Format::big_endian;
    } else {
      lines_.fail(quote(word) +
                  " is no format: ascii, binary_little_endian or binary_big_endian expected");
    }
  }

  void read_element() {
    Element element;
    element.name = lines_.take_word();
    element.count = lines_.require_integer("the number of elements");
    if (element.count < 0) lines_.fail("a number of elements below 0");
    header_.elements.push_back(element);
  }

  void read_property() {
    if (header_.elements.empty()) lines_.fail("a property before any element");
    Property property;
    std::string_view word = lines_.take_word();
    if (word == "list") {
      property.count_type = require_type(lines_.take_word());
      word = lines_.take_word();
    }
    property.type = require_type(word);
    property.role = role_of(lines_.take_word());
    const bool must_be_list = property.role == Role::corners || property.role == Role::corner_uvs;
    if (must_be_list != property.count_type.has_value()) property.role = Role::other;
    header_.elements.back().properties.push_back(property);
  }

  Type require_type(std::string_view word) const {
    const auto type = parse_type(word);
    if (!type) lines_.fail(quote(word) + " is no type of a number");
    return *type;
  }

  std::string_view bytes_;
  TextLines lines_;
  Header header_;
};

// ---- Body

/// The numbers of the body, one after the other.
class Numbers {
 public:
  virtual ~Numbers() = default;
  virtual double take(Type type) = 0;
  [[noreturn]] virtual void fail(const std::string& problem) const = 0;
};

class TextNumbers : public Numbers {
 public:
  TextNumbers(const Header& header, const std::string& file)
      : lines_(header.body, file), lines_before_(header.lines) {}

  double take(Type) override {
    if (lines_.rest().empty() && !lines_.next()) fail("the file ends too early");
    const std::string_view word = lines_.take_word();
    const auto number = parse_double(word);
    if (!number) fail(quote(word) + " is not a number");
    return *number;
  }

  [[noreturn]] void fail(const std::string& problem) const override {
    lines_.fail_at(lines_before_ + lines_.line(), problem);
  }

 private:
  TextLines lines_;
  std::size_t lines_before_;
};

class BinaryNumbers : public Numbers {
 public:
  BinaryNumbers(const Header& header, const std::string& file)
      : file_(file),
        reader_(header.body,
                header.format == Format::big_endian ? std::endian::big : std::endian::little,
                file) {}

  double take(Type type) override {
    switch (type) {
      case Type::int8:
        return reader_.take<std::int8_t>();
      case Type::uint8:
        return reader_.take<std::uint8_t>();
      case Type::int16:
        return reader_.take<std::int16_t>();
      case Type::uint16:
        return reader_.take<std::uint16_t>();
      case Type::int32:
        return reader_.take<std::int32_t>();
      case Type::uint32:
        return reader_.take<std::uint32_t>();
      case Type::float32:
        return reader_.take<float>();
      case Type::float64:
        return reader_.take<double>();
    }
    return 0;
  }

  [[noreturn]] void fail(const std::string& problem) const override {
    throw InputError(file_ + ": " + problem);
  }

 private:
  std::string file_;
  ByteReader reader_;
};

/// What a colour's value is divided by.
double largest(Type type) {
  switch (type) {
    case Type::int8:
      return std::numeric_limits<std::int8_t>::max();
    case Type::uint8:
      return std::numeric_limits<std::uint8_t>::max();
    case Type::int16:
      return std::numeric_limits<std::int16_t>::max();
    case Type::uint16:
      return std::numeric_limits<std::uint16_t>::max();
    case Type::int32:
      return std::numeric_limits<std::int32_t>::max();
    case Type::uint32:
      return std::numeric_limits<std::uint32_t>::max();
    default:
      return 1;
  }
}

class PlyBody {
 public:
  PlyBody(const Header& header, Numbers& numbers) : header_(header), numbers_(numbers) {
    for (const Element& element : header.elements) {
      if (element.name == "vertex") vertices_ = element;
    }
    for (const Role role : {Role::x, Role::y, Role::z}) {
      if (!vertices_.has(role)) numbers.fail("the header promises no vertices with x, y and z");
    }
  }

  Mesh read(const std::string& file) {
    for (const Element& element : header_.elements) {
      // An element without properties takes no bytes, so that nothing but its count would end the
      // loop.
      if (element.properties.empty()) continue;
      for (long long i = 0; i < element.count; ++i) {
        take_element(element);
        if (element.name == "vertex") add_vertex();
        if (element.name == "face") add_face(element);
      }
    }
    if (vertices_.has(Role::nx)) builder_.give_each_position(&Corner::normal);
    if (vertices_.has(Role::red)) builder_.give_each_position(&Corner::color);
    if (vertices_.has(Role::u)) builder_.give_each_position(&Corner::uv);
    return std::move(builder_).build(file);
  }

 private:
  void take_element(const Element& element) {
    for (const Property& property : element.properties) {
      if (!property.count_type) {
        values_[static_cast<std::size_t>(property.role)] =
            scaled(property, numbers_.take(property.type));
        continue;
      }
      std::vector<double>& list = lists_[static_cast<std::size_t>(property.role)];
      list.clear();
      const double count = numbers_.take(*property.count_type);
      for (auto left = as_count(count); left > 0; --left)
        list.push_back(numbers_.take(property.type));
    }
  }

  /// Of what any type can say; what is negative or no number is an empty list.
  static std::uint64_t as_count(double number) {
    constexpr double most = std::numeric_limits<std::uint32_t>::max();
    return static_cast<std::uint64_t>(std::fmin(std::fmax(number, 0.0), most));
  }

  static double scaled(const Property& property, double number) {
    const bool is_color = property.role >= Role::red && property.role <= Role::blue;
    return is_color ? number / largest(property.type) : number;
  }

  float value(Role role) const {
    return static_cast<float>(values_[static_cast<std::size_t>(role)]);
  }

  Eigen::Vector3f vector(Role first, Role second, Role third) const {
    return {value(first), value(second), value(third)};
  }

  void add_vertex() {
    builder_.positions.push_back(vector(Role::x, Role::y, Role::z));
    if (vertices_.has(Role::nx)) builder_.normals.push_back(vector(Role::nx, Role::ny, Role::nz));
    if (vertices_.has(Role::red)) {
      builder_.colors.push_back(vector(Role::red, Role::green, Role::blue));
    }
    if (vertices_.has(Role::u)) builder_.uvs.emplace_back(value(Role::u), value(Role::v));
  }

  void add_face(const Element& element) {
    const std::vector<double>& indices = lists_[static_cast<std::size_t>(Role::corners)];
    const std::vector<double>& uvs = lists_[static_cast<std::size_t>(Role::corner_uvs)];
    Corner corner;
    if (!vertices_.has(Role::red) && element.has(Role::red)) {
      corner.color = static_cast<std::uint32_t>(builder_.colors.size());
      builder_.colors.push_back(vector(Role::red, Role::green, Role::blue));
    }
    corners_.clear();
    for (std::size_t i = 0; i < indices.size(); ++i) {
      corner.position = checked_index(indices[i]);
      if (!vertices_.has(Role::u) && uvs.size() == 2 * indices.size()) {
        corner.uv = static_cast<std::uint32_t>(builder_.uvs.size());
        builder_.uvs.emplace_back(static_cast<float>(uvs[2 * i]),
                                  static_cast<float>(uvs[2 * i + 1]));
      }
      corners_.push_back(corner);
    }
    if (corners_.size() >= 3) builder_.add_polygon(corners_);
  }

  std::uint32_t checked_index(double index) const {
    const auto count = static_cast<double>(vertices_.count);
    if (!(index >= 0 && index < count && index < MeshBuilder::none)) {
      std::ostringstream text;
      text.precision(17);
      text << "a face refers to vertex " << index << "; there are vertices 0 to " << count - 1;
      numbers_.fail(text.str());
    }
    return static_cast<std::uint32_t>(index);
  }

  const Header& header_;
  Numbers& numbers_;
  Element vertices_;
  MeshBuilder builder_;
  std::array<double, role_count> values_{};
  std::array<std::vector<double>, role_count> lists_;
  std::vector<Corner> corners_;
};

}  // namespace

Mesh read_ply(std::string_view bytes, const std::string& file) {
  const Header header = HeaderText(bytes, file).read();
  if (header.format == Format::text) {
    TextNumbers numbers(header, file);
    return PlyBody(header, numbers).read(file);
  }
  BinaryNumbers numbers(header, file);
  return PlyBody(header, numbers).read(file);
}

}  // namespace rasterlab
