// Rules 1 and 2 of the house: who may include whom, read from the include lines.
#include "common/image/files.h"

#include "tests/house/repository.h"
#include "tests/support/scratch.h"

#include <fstream>
#include <map>
#include <regex>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterlab::house {
namespace {

namespace fs = std::filesystem;

/// The topics in the order the stages bring them.
const std::vector<std::string> topics{"lines",    "triangles", "zbuffer", "projection",
                                      "lighting", "texture",   "shaders"};

/// What each room of common may include beside itself; for a topic also every earlier topic.
std::map<std::string, std::set<std::string>> allowed_rooms() {
  std::map<std::string, std::set<std::string>> allowed{
      {"image", {}},
      {"mesh", {"image"}},
      {"engine", {"image", "mesh"}},
      {"stage", {"image", "mesh"}},
      {"viewer", {"image", "mesh", "stage", "engine", "projection"}}};
  std::set<std::string> earlier{"image", "mesh"};
  for (const std::string& topic : topics) {
    allowed[topic] = earlier;
    earlier.insert(topic);
  }
  return allowed;
}

/// What the main.cpp of stage 1 … 7 may include of common: what is given and no later topic.
std::set<std::string> rooms_of_stage(int number) {
  std::set<std::string> rooms{"image", "mesh", "engine", "stage"};
  if (number >= 4) rooms.insert("viewer");
  rooms.insert(topics.begin(), topics.begin() + number);
  return rooms;
}

std::vector<std::string> includes(const fs::path& file) {
  static const std::regex include(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  std::vector<std::string> found;
  for (const std::string& line : lines(read_file(file))) {
    std::smatch match;
    if (std::regex_search(line, match, include)) found.push_back(match[1]);
  }
  return found;
}

bool is_stage_folder(const std::string& name) {
  return std::regex_match(name, std::regex("0[1-7]_[a-z]+"));
}

/// The first folder of a path, and the second where the first is common.
struct Place {
  std::string folder;
  std::string room;
};

Place place_of(const fs::path& path) {
  auto part = path.begin();
  Place place{.folder = *part++, .room = {}};
  const bool has_rooms = place.folder == "common" || place.folder == "tests";
  if (has_rooms && part != path.end()) place.room = *part;
  return place;
}

/// What is wrong with one include of a file, both relative to the root; empty when nothing is.
std::string fault(const fs::path& file, const std::string& included) {
  static const auto allowed = allowed_rooms();
  const Place from = place_of(file);
  const Place to = place_of(included);
  const bool is_source = file.extension() == ".cpp";
  if (included.rfind("OpenMesh/", 0) == 0 && !(from.room == "mesh" && is_source)) {
    return "OpenMesh belongs in common/mesh/*.cpp";
  }
  const bool is_peer = from.folder == "bench" && file.filename() == "peer.cpp";
  if (included.rfind("opencv2/", 0) == 0 && !(from.room == "image" && is_source) && !is_peer) {
    return "OpenCV belongs in common/image/*.cpp, and as a peer in bench/*/peer.cpp";
  }
  if (is_stage_folder(to.folder)) {
    return to.folder == from.folder ? "" : "nobody else includes a stage";
  }
  for (const std::string private_folder : {"tests", "bench", "grading"}) {
    const bool is_its_test = from.folder == "tests" && from.room == private_folder;
    if (to.folder == private_folder && from.folder != private_folder && !is_its_test)
      return "nobody includes " + private_folder;
  }
  if (to.folder != "common" || to.room == from.room) return "";
  if (from.folder == "common") {
    if (allowed.count(from.room) == 0) return "a room this test does not know";
    return allowed.at(from.room).count(to.room) != 0 ? ""
                                                     : from.room + " may not include " + to.room;
  }
  if (is_stage_folder(from.folder)) {
    const int number = from.folder[1] - '0';
    return rooms_of_stage(number).count(to.room) != 0
               ? ""
               : "stage " + from.folder + " may not include " + to.room;
  }
  return "";
}

/// Every fault of a tree, one a line.
std::string faults(const fs::path& tree) {
  std::string found;
  for (const auto& top : fs::directory_iterator(tree)) {
    const std::string name = top.path().filename();
    const bool has_sources = name == "common" || name == "tests" || name == "bench" ||
                             name == "tools" || name == "data" || name == "grading" ||
                             is_stage_folder(name);
    if (!top.is_directory() || !has_sources) continue;
    for (const auto& entry : fs::recursive_directory_iterator(top.path())) {
      const std::string extension = entry.path().extension();
      if (extension != ".h" && extension != ".cpp") continue;
      const fs::path file = fs::relative(entry.path(), tree);
      for (const std::string& included : includes(entry.path())) {
        const std::string what = fault(file, included);
        if (!what.empty()) found += file.string() + " includes " + included + ": " + what + "\n";
      }
    }
  }
  return found;
}

TEST(house_layers, include_lines_keep_to_the_rooms_order) {
  EXPECT_EQ(faults(root()), "");
}

TEST(house_layers, common_has_only_rooms_with_a_place_in_the_order) {
  for (const auto& entry : fs::directory_iterator(root() / "common")) {
    if (!entry.is_directory()) continue;
    EXPECT_EQ(allowed_rooms().count(entry.path().filename()), 1U) << entry.path();
  }
}

struct Violation {
  std::string file;
  std::string line;
  std::string complaint;
};

class house_layers_violation : public testing::TestWithParam<Violation> {};

TEST_P(house_layers_violation, is_found) {
  const ScratchFolder tree;
  const fs::path file = tree / GetParam().file;
  fs::create_directories(file.parent_path());
  std::ofstream(file) << "#pragma once\n" << GetParam().line << "\n";
  EXPECT_THAT(faults(tree.path()), testing::HasSubstr(GetParam().complaint));
}

INSTANTIATE_TEST_SUITE_P(
    , house_layers_violation,
    testing::Values(
        Violation{"common/lines/a.cpp", "#include \"common/triangles/b.h\"",
                  "lines may not include triangles"},
        Violation{"common/lighting/a.h", "#include \"common/engine/b.h\"",
                  "lighting may not include engine"},
        Violation{"common/engine/a.cpp", "# include \"common/lines/b.h\"",
                  "engine may not include lines"},
        Violation{"common/image/a.cpp", "#include \"common/mesh/mesh.h\"",
                  "image may not include mesh"},
        Violation{"common/viewer/a.cpp", "#include \"common/lighting/b.h\"",
                  "viewer may not include lighting"},
        Violation{"common/stage/a.cpp", "#include \"common/lines/b.h\"",
                  "stage may not include lines"},
        Violation{"02_triangles/main.cpp", "#include \"common/zbuffer/b.h\"",
                  "02_triangles may not include zbuffer"},
        Violation{"03_zbuffer/main.cpp", "#include \"common/viewer/b.h\"",
                  "03_zbuffer may not include viewer"},
        Violation{"common/lines/a.cpp", "#include \"01_lines/main.h\"",
                  "nobody else includes a stage"},
        Violation{"02_triangles/a.cpp", "#include \"01_lines/own.h\"",
                  "nobody else includes a stage"},
        Violation{"common/lines/a.cpp", "#include \"tests/support/scratch.h\"",
                  "nobody includes tests"},
        Violation{"tests/lines/a.cpp", "#include \"bench/b.h\"", "nobody includes bench"},
        Violation{"common/lines/a.cpp", "#include <opencv2/core.hpp>", "OpenCV belongs in"},
        Violation{"common/image/a.h", "#include <opencv2/core.hpp>", "OpenCV belongs in"},
        Violation{"bench/lines/main.cpp", "#include <opencv2/core.hpp>", "OpenCV belongs in"},
        Violation{"common/mesh/a.h", "#include <OpenMesh/Core/IO/MeshIO.hh>",
                  "OpenMesh belongs in"},
        Violation{"common/attic/a.h", "#include \"common/image/image.h\"",
                  "a room this test does not know"}));

}  // namespace
}  // namespace rasterlab::house
