#include "common/mesh/read_mesh.h"

#include "common/image/bytes.h"
#include "common/image/check.h"
#include "common/mesh/read_obj.h"
#include "common/mesh/read_off.h"
#include "common/mesh/read_om.h"
#include "common/mesh/read_ply.h"
#include "common/mesh/read_stl.h"
#include "common/mesh/shapes.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>

namespace rasterlab {
namespace {

struct Format {
  std::string_view extension;
  bool (*begins_so)(std::string_view bytes);
  Mesh (*read)(std::string_view bytes, const std::string& file);
};

bool looks_like_ply(std::string_view bytes) {
  return bytes.starts_with("ply\n") || bytes.starts_with("ply\r");
}

/// OBJ has no mark of its own: it is known by its extension only.
bool never(std::string_view) {
  return false;
}

constexpr std::array<Format, 5> formats = {{{".off", &looks_like_off, &read_off},
                                            {".ply", &looks_like_ply, &read_ply},
                                            {".om", &looks_like_om, &read_om},
                                            {".stl", &looks_like_stl, &read_stl},
                                            {".obj", &never, &read_obj}}};

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

const Format& format_of(const std::filesystem::path& file, std::string_view bytes) {
  const std::string extension = lower_case(file.extension().string());
  for (const Format& format : formats) {
    if (format.extension == extension) return format;
  }
  for (const Format& format : formats) {
    if (format.begins_so(bytes)) return format;
  }
  throw InputError(file.string() +
                   ": neither its name nor its content is that of a mesh: OFF, OBJ, " +
                   "PLY, STL or OM expected");
}

}  // namespace

Mesh read_mesh(const std::filesystem::path& file) {
  const std::string name = file.string();
  const std::string builtin = "builtin:";
  if (name.starts_with(builtin)) return make_shape(name.substr(builtin.size()));
  return read_mesh_bytes(read_file(file), file);
}

Mesh read_mesh_bytes(std::string_view bytes, const std::filesystem::path& file) {
  const std::string name = file.string();
  if (bytes.empty()) throw InputError(name + ": the file is empty, a mesh was expected");
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
    throw InputError(name + ": the text is UTF-16; UTF-8 or ASCII was expected");
  }
  return format_of(file, bytes).read(bytes, name);
}

}  // namespace rasterlab
