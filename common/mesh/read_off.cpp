#include "common/mesh/read_off.h"

#include "common/image/check.h"
#include "common/mesh/byte_reader.h"
#include "common/mesh/mesh_builder.h"
#include "common/mesh/text_lines.h"

#include <algorithm>
#include <array>
#include <optional>

namespace rasterlab {
namespace {

using Corner = MeshBuilder::Corner;

/// What the first word of a file says.
struct Header {
  bool has_uv = false;             // ST
  bool has_color = false;          // C
  bool has_normal = false;         // N
  bool has_w = false;              // 4
  std::string_view glued_to_it{};  // "8" in "OFF8 6 0"
};

std::optional<Header> parse_header(std::string_view word) {
  Header header;
  while (!word.starts_with("OFF")) {
    if (word.starts_with("ST")) {
      header.has_uv = true;
      word.remove_prefix(1);
    } else if (word.starts_with('C')) {
      header.has_color = true;
    } else if (word.starts_with('N')) {
      header.has_normal = true;
    } else if (word.starts_with('4')) {
      header.has_w = true;
    } else {
      return std::nullopt;
    }
    word.remove_prefix(1);
  }
  header.glued_to_it = word.substr(3);
  return header;
}

/// The numbers of one vertex, in their order.
struct Layout {
  std::size_t position = 3;
  std::size_t normal = 0;
  std::size_t color = 0;
  std::size_t uv = 0;

  std::size_t columns() const { return position + normal + color + uv; }
};

/// What the header announces; `color` numbers where it announces colours.
Layout announced_layout(const Header& header, std::size_t color) {
  return {.position = header.has_w ? 4U : 3U,
          .normal = header.has_normal ? 3U : 0U,
          .color = header.has_color ? color : 0U,
          .uv = header.has_uv ? 2U : 0U};
}

/// What a vertex of so many columns must hold; nothing when it cannot be.
std::optional<Layout> recognized_layout(const Header& header, std::size_t columns) {
  Layout layout = announced_layout(header, 0);
  if (columns < layout.columns()) return std::nullopt;
  const std::size_t more = columns - layout.columns();
  switch (more) {
    case 0:
    case 1:  // an index into a table of colours that the file does not have
      break;
    case 2:
      layout.uv = 2;
      break;
    case 3:
      layout.color = 3;
      break;
    case 4:
      layout.color = 4;
      break;
    case 5:
      layout = {layout.position, layout.normal, 3, 2};
      break;
    case 6:
      layout = {layout.position, layout.normal, 4, 2};
      break;
    default:
      return std::nullopt;
  }
  return more == 1 || layout.columns() == columns ? std::optional(layout) : std::nullopt;
}

/// Collects vertices and faces, whichever way they are written.
class OffMesh {
 public:
  void set_layout(const Layout& layout) { layout_ = layout; }
  const Layout& layout() const { return layout_; }
  std::size_t vertex_count() const { return builder_.positions.size(); }

  /// `numbers`: as many as the layout has columns.
  void add_vertex(const float* numbers) {
    Eigen::Vector3f position(numbers[0], numbers[1], numbers[2]);
    if (layout_.position == 4) position /= numbers[3];
    builder_.positions.push_back(position);
    numbers += layout_.position;
    if (layout_.normal != 0) builder_.normals.emplace_back(numbers[0], numbers[1], numbers[2]);
    numbers += layout_.normal;
    if (layout_.color != 0) builder_.colors.emplace_back(numbers[0], numbers[1], numbers[2]);
    numbers += layout_.color;
    if (layout_.uv != 0) builder_.uvs.emplace_back(numbers[0], numbers[1]);
  }

  /// `color`: no numbers, or those of a colour. Vertex numbers are in range.
  void add_face(const std::vector<std::uint32_t>& vertices, const std::vector<float>& color) {
    if (vertices.size() < 3) return;
    const bool has_color = layout_.color == 0 && (color.size() == 3 || color.size() == 4);
    const auto face_color = static_cast<std::uint32_t>(builder_.colors.size());
    if (has_color) builder_.colors.emplace_back(color[0], color[1], color[2]);
    corners_.clear();
    for (const std::uint32_t vertex : vertices) {
      corners_.push_back({.position = vertex, .color = has_color ? face_color : MeshBuilder::none});
    }
    builder_.add_polygon(corners_);
  }

  Mesh build(const std::string& file) && {
    if (layout_.normal != 0) builder_.give_each_position(&Corner::normal);
    if (layout_.color != 0) builder_.give_each_position(&Corner::color);
    if (layout_.uv != 0) builder_.give_each_position(&Corner::uv);
    scale_colors(builder_.colors);
    return std::move(builder_).build(file);
  }

 private:
  Layout layout_;
  MeshBuilder builder_;
  std::vector<Corner> corners_;
};

// ---- Text

class OffText {
 public:
  OffText(std::string_view text, const std::string& file) : file_(file), lines_(text, file) {}

  /// Each vertex and each face on a line of its own.
  Mesh read_by_lines() {
    read_start();
    for (long long i = 0; i < vertex_count_; ++i) {
      if (!lines_.next()) fail_at_end(i, vertex_count_, "vertices");
      read_vertex();
    }
    for (long long i = 0; i < face_count_; ++i) {
      if (!lines_.next()) fail_at_end(i, face_count_, "faces");
      read_face();
    }
    return std::move(mesh_).build(file_);
  }

  /// Lines end anywhere. Then only the header can say what a vertex has, and every word must be
  /// accounted for.
  Mesh read_as_stream() {
    read_start();
    mesh_.set_layout(announced_layout(header_, 4));
    std::array<float, 13> numbers{};
    for (long long i = 0; i < vertex_count_; ++i) {
      for (std::size_t k = 0; k < mesh_.layout().columns(); ++k) {
        move_to_word();
        numbers[k] = lines_.require_float("a number");
      }
      mesh_.add_vertex(numbers.data());
    }
    for (long long i = 0; i < face_count_; ++i) {
      move_to_word();
      const long long count = lines_.require_integer("the number of corners of a face");
      vertices_.clear();
      for (long long k = 0; k < count; ++k) {
        move_to_word();
        vertices_.push_back(read_index());
      }
      mesh_.add_face(vertices_, {});
    }
    if (!lines_.rest().empty() || lines_.next())
      lines_.fail("there is more than the header promises");
    return std::move(mesh_).build(file_);
  }

 private:
  void read_start() {
    if (!lines_.next()) lines_.fail("an OFF header was expected, not the end of the file");
    std::vector<long long> counts;
    const std::string_view first = lines_.rest();
    const std::string_view word = lines_.take_word();
    if (const auto header = parse_header(word)) {
      header_ = *header;
      if (!header->glued_to_it.empty()) counts.push_back(parse_count(header->glued_to_it));
    } else if (parse_integer(word)) {
      counts.push_back(parse_count(word));
    } else {
      lines_.fail(quote(first) + " is no OFF header: OFF, COFF, NOFF, STOFF, 4OFF or a " +
                  "combination of these was expected");
    }
    while (counts.size() < 2) {
      move_to_word();
      counts.push_back(parse_count(lines_.take_word()));
    }
    // The third, the number of edges, is of no use and may be missing.
    if (const auto edges = lines_.take_word(); !edges.empty()) parse_count(edges);
    counts_line_ = lines_.line();
    vertex_count_ = counts[0];
    face_count_ = counts[1];
  }

  long long parse_count(std::string_view word) const {
    const auto count = parse_integer(word);
    if (!count || *count < 0) {
      lines_.fail(quote(word) +
                  " is no count: the numbers of vertices, faces and edges were expected");
    }
    return *count;
  }

  void read_vertex() {
    std::array<float, 32> numbers{};
    std::size_t columns = 0;
    while (columns < numbers.size() && !lines_.rest().empty()) {
      numbers[columns++] = *lines_.take_float();
    }
    if (mesh_.vertex_count() == 0) {
      const auto layout = recognized_layout(header_, columns);
      if (!layout) {
        lines_.fail("a vertex of " + std::to_string(columns) + " numbers; " +
                    "x y z [w] [normal] [colour] [u v] were expected");
      }
      mesh_.set_layout(*layout);
    }
    if (columns < mesh_.layout().columns()) {
      lines_.fail("a vertex of " + std::to_string(columns) + " numbers; the first has " +
                  std::to_string(mesh_.layout().columns()));
    }
    mesh_.add_vertex(numbers.data());
  }

  void read_face() {
    const long long count = lines_.require_integer("the number of corners of a face");
    if (count < 1) lines_.fail("a face of " + std::to_string(count) + " corners");
    vertices_.clear();
    for (long long i = 0; i < count; ++i) vertices_.push_back(read_index());
    color_.clear();
    while (color_.size() < 4 && !lines_.rest().empty()) {
      const auto number = parse_float(lines_.take_word());
      if (!number) break;
      color_.push_back(*number);
    }
    mesh_.add_face(vertices_, color_);
  }

  std::uint32_t read_index() {
    const long long index = lines_.require_integer("the number of a vertex");
    if (index < 0 || index >= static_cast<long long>(mesh_.vertex_count())) {
      lines_.fail("a face refers to vertex " + std::to_string(index) +
                  "; there are vertices 0 to " +
                  std::to_string(static_cast<long long>(mesh_.vertex_count()) - 1));
    }
    return static_cast<std::uint32_t>(index);
  }

  /// Goes on to the next record when this one has no word left.
  void move_to_word() {
    if (lines_.rest().empty() && !lines_.next()) lines_.fail("the file ends too early");
  }

  [[noreturn]] void fail_at_end(long long found, long long promised,
                                const std::string& what) const {
    lines_.fail("the file ends after " + std::to_string(found) + " of the " +
                std::to_string(promised) + " " + what + " that line " +
                std::to_string(counts_line_) + " promises");
  }

  const std::string& file_;
  TextLines lines_;
  Header header_;
  std::size_t counts_line_ = 0;
  long long vertex_count_ = 0;
  long long face_count_ = 0;
  OffMesh mesh_;
  std::vector<std::uint32_t> vertices_;
  std::vector<float> color_;
};

Mesh read_text(std::string_view text, const std::string& file) {
  try {
    return OffText(text, file).read_by_lines();
  } catch (const InputError&) {
    try {
      return OffText(text, file).read_as_stream();
    } catch (const InputError&) {  // what is wrong with the lines says more
    }
    throw;
  }
}

// ---- Binary

/// A way to write binary OFF; there is no mark in the file to tell.
struct Dialect {
  std::endian order;
  bool faces_have_colors;
  std::size_t color_numbers;
};

constexpr std::array<Dialect, 8> dialects = {{{std::endian::big, true, 4},
                                              {std::endian::little, false, 3},
                                              {std::endian::little, false, 4},
                                              {std::endian::big, true, 3},
                                              {std::endian::big, false, 4},
                                              {std::endian::big, false, 3},
                                              {std::endian::little, true, 4},
                                              {std::endian::little, true, 3}}};

/// A colour's number: a float, or 0…255 in an integer, whose bits are those of a tiny float.
float take_color(ByteReader& reader) {
  const auto bits = reader.take<std::uint32_t>();
  return bits < 256 ? static_cast<float>(bits) : std::bit_cast<float>(bits);
}

void take_vertex(ByteReader& reader, OffMesh& mesh) {
  std::array<float, 13> numbers{};
  const Layout& layout = mesh.layout();
  const std::size_t color_start = layout.position + layout.normal;
  for (std::size_t i = 0; i < layout.columns(); ++i) {
    const bool is_color = i >= color_start && i < color_start + layout.color;
    numbers[i] = is_color ? take_color(reader) : reader.take<float>();
  }
  mesh.add_vertex(numbers.data());
}

Mesh read_binary_as(const Dialect& dialect, const Header& header, std::string_view bytes,
                    const std::string& file) {
  ByteReader reader(bytes, dialect.order, file);
  const auto vertex_count = reader.take<std::uint32_t>();
  const auto face_count = reader.take<std::uint32_t>();
  reader.take<std::uint32_t>();  // edges
  OffMesh mesh;
  mesh.set_layout(announced_layout(header, dialect.color_numbers));
  for (std::uint32_t i = 0; i < vertex_count; ++i) take_vertex(reader, mesh);
  std::vector<std::uint32_t> vertices;
  std::vector<float> color;
  for (std::uint32_t i = 0; i < face_count; ++i) {
    vertices.clear();
    for (auto corners = reader.take<std::uint32_t>(); corners > 0; --corners) {
      vertices.push_back(reader.take<std::uint32_t>());
      if (vertices.back() >= vertex_count)
        throw InputError(file + ": a vertex number is too large");
    }
    if (vertices.empty()) throw InputError(file + ": a face of 0 corners");
    color.clear();
    auto numbers = dialect.faces_have_colors ? reader.take<std::uint32_t>() : 0;
    for (; numbers > 0; --numbers) color.push_back(take_color(reader));
    mesh.add_face(vertices, color);
  }
  if (reader.left() > 1) throw InputError(file + ": there is more than the counts promise");
  return std::move(mesh).build(file);
}

Mesh read_binary(const Header& header, std::string_view bytes, const std::string& file) {
  for (const Dialect& dialect : dialects) {
    try {
      return read_binary_as(dialect, header, bytes, file);
    } catch (const InputError&) {  // not written this way
    }
  }
  throw InputError(file +
                   ": the counts of a binary OFF file were expected to fit its size and its " +
                   "faces its vertices; in no byte order they do");
}

/// The first line: up to the first line feed.
std::string_view first_line(std::string_view bytes) {
  return bytes.substr(0, bytes.find('\n'));
}

}  // namespace

bool looks_like_off(std::string_view bytes) {
  TextLines lines(bytes.substr(0, 4096), "");
  return lines.next() && parse_header(lines.take_word()).has_value();
}

Mesh read_off(std::string_view bytes, const std::string& file) {
  const std::string_view line = first_line(bytes);
  TextLines words(line, file);
  if (words.next()) {
    const auto header = parse_header(words.take_word());
    if (header && words.take_word() == "BINARY") {
      return read_binary(*header, bytes.substr(std::min(line.size() + 1, bytes.size())), file);
    }
  }
  return read_text(bytes, file);
}

}  // namespace rasterlab
