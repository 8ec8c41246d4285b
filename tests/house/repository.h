// The repository as these tests read it: its folders, manifests and the names of its tests.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace rasterlab::house {

/// The repository's root.
std::filesystem::path root();

/// The stage folders there are, in order: "01_lines" …
std::vector<std::string> stages();

/// The exercises of a stage's exercises.json.
nlohmann::json exercises(const std::string& stage);

/// Every test CTest knows, by its dotted name.
const std::vector<std::string>& test_names();

/// Whether any test matches the pattern.
bool some_test_matches(const std::string& pattern);

/// The lines of a text, without their ends.
std::vector<std::string> lines(const std::string& text);

}  // namespace rasterlab::house
