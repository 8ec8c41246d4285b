// A stage's exercises.json, as far as its executable needs it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rasterlab {

struct ManifestEntry {
  std::string id;                   ///< "01.5"
  std::string title;                ///< one line
  std::vector<std::string> writes;  ///< the files it leaves
};

/// The exercises, in the manifest's order; what else it says is not looked at. Throws InputError,
/// one line which names the exercise, when it is no manifest.
std::vector<ManifestEntry> parse_manifest(std::string_view json);

}  // namespace rasterlab
