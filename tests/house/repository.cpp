#include "tests/house/repository.h"

#include "common/image/files.h"

#include "tests/support/pattern.h"
#include "tests/support/places.h"
#include "tests/support/process.h"

#include <algorithm>
#include <sstream>

namespace rasterlab::house {

namespace fs = std::filesystem;

fs::path root() {
  return source_folder();
}

std::vector<std::string> stages() {
  std::vector<std::string> found;
  for (const auto& entry : fs::directory_iterator(root())) {
    if (fs::exists(entry.path() / "exercises.json")) found.push_back(entry.path().filename());
  }
  std::sort(found.begin(), found.end());
  return found;
}

nlohmann::json exercises(const std::string& stage) {
  return nlohmann::json::parse(read_file(root() / stage / "exercises.json")).at("exercises");
}

const std::vector<std::string>& test_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> found;
    const ProcessResult listing =
        run_process({"ctest", "--test-dir", binary_folder().string(), "--show-only=json-v1"});
    const nlohmann::json tests = nlohmann::json::parse(listing.out);
    for (const nlohmann::json& test : tests.at("tests")) found.push_back(test.at("name"));
    return found;
  }();
  return names;
}

bool some_test_matches(const std::string& pattern) {
  return std::any_of(test_names().begin(), test_names().end(),
                     [&](const std::string& name) { return matches(pattern, name); });
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> found;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) found.push_back(line);
  return found;
}

}  // namespace rasterlab::house
