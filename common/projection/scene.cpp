#include "common/projection/scene.h"

#include "common/image/check.h"
#include "common/image/files.h"
#include "common/projection/clip.h"

#include <charconv>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace rasterlab {
namespace {

// The records of a scene, one after another.
class SceneReader {
 public:
  explicit SceneReader(const std::filesystem::path& path) : path_(path), text_(read_file(path)) {}

  // Goes to the next line that holds a record, `expected` in words.
  void next(const std::string& expected) {
    expected_ = expected;
    while (std::getline(text_, line_)) {
      ++line_number_;
      fields_.clear();
      if (line_.ends_with('\r')) line_.pop_back();
      std::istringstream words(line_);
      for (std::string word; words >> word;) fields_.push_back(word);
      if (!fields_.empty() && fields_[0][0] != '#') return;
    }
    throw InputError(path_.string() + ": ends after line " + std::to_string(line_number_) +
                     ", expected " + expected_);
  }

  [[noreturn]] void fail() const {
    throw InputError(path_.string() + ":" + std::to_string(line_number_) + ": expected " +
                     expected_ + ", found: " + line_);
  }

  const std::string& word(std::size_t index) const {
    if (index >= fields_.size()) fail();
    return fields_[index];
  }

  bool has_number(std::size_t index) const {
    float ignored = 0;
    return index < fields_.size() && parse(fields_[index], ignored);
  }

  float number(std::size_t index) const {
    float value = 0;
    if (!parse(word(index), value)) fail();
    return value;
  }

  float positive(std::size_t index) const {
    const float value = number(index);
    if (!(value > 0)) fail();
    return value;
  }

  float not_negative(std::size_t index) const {
    const float value = number(index);
    if (value < 0) fail();
    return value;
  }

  int side(std::size_t index) const {
    const float value = number(index);
    if (!(value >= 1 && value <= longest_side && value == std::floor(value))) fail();
    return static_cast<int>(value);
  }

  Eigen::Vector3f vector() const { return {number(0), number(1), number(2)}; }

 private:
  static bool parse(const std::string& field, float& value) {
    const char* begin = field.data() + (field[0] == '+' ? 1 : 0);
    const char* end = field.data() + field.size();
    const auto [rest, error] = std::from_chars(begin, end, value);
    return error == std::errc() && rest == end && std::isfinite(value);
  }

  std::filesystem::path path_;
  std::istringstream text_;
  std::string line_;
  int line_number_ = 0;
  std::string expected_;
  std::vector<std::string> fields_;
};

// As named, or beside the scene.
std::filesystem::path find_mesh(const std::filesystem::path& scene, const SceneReader& reader) {
  const std::string& name = reader.word(0);
  std::error_code none;  // a name too long for the file system is no file either
  if (name.starts_with("builtin:") || std::filesystem::exists(name, none)) return name;
  std::filesystem::path beside = scene.parent_path() / name;
  if (std::filesystem::exists(beside, none)) return beside;
  reader.fail();
}

// Four numbers, or five when the position is homogeneous.
void read_light(const SceneReader& reader, Light& light) {
  light.position = reader.vector().homogeneous();
  light.intensity = reader.number(3);
  if (reader.has_number(4)) {
    light.position.w() = reader.number(3);
    light.intensity = reader.number(4);
  }
}

}  // namespace

Scene read_scene(const std::filesystem::path& path) {
  SceneReader reader(path);
  Scene scene;
  reader.next("the file of a mesh, in the working directory or beside the scene");
  scene.mesh = find_mesh(path, reader);
  reader.next("the eye, three numbers x y z");
  scene.eye = reader.vector();
  reader.next("the point looked at, three numbers x y z");
  scene.look_at = reader.vector();
  reader.next("the direction of image y, three numbers x y z");
  scene.up = reader.vector();
  reader.next("the focal length in pixels, a number above 0");
  scene.focal_length = reader.positive(0);
  reader.next("the picture's width and height, whole numbers from 1 to " +
              std::to_string(longest_side));
  scene.width = reader.side(0);
  scene.height = reader.side(1);
  reader.next("the ambient intensity, a number");
  scene.light.ambient_intensity = reader.number(0);
  reader.next("the light, x y z [w] and its intensity: four or five numbers");
  read_light(reader, scene.light);
  reader.next("the material, four numbers Ka Kd Ks shininess, the last not below 0");
  scene.material = {reader.number(0), reader.number(1), reader.number(2), reader.not_negative(3)};
  return scene;
}

}  // namespace rasterlab
