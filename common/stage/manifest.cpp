#include "common/stage/manifest.h"

#include "common/image/check.h"

#include <nlohmann/json.hpp>

namespace rasterlab {
namespace {

[[noreturn]] void throw_expected(const std::string& what) {
  throw InputError("exercises.json: expected " + what);
}

std::string text_at(const nlohmann::json& entry, const char* key, const std::string& where) {
  const auto text = entry.find(key);
  if (text == entry.end() || !text->is_string()) {
    throw_expected("a string \"" + std::string(key) + "\" in " + where);
  }
  return text->get<std::string>();
}

ManifestEntry parse_entry(const nlohmann::json& entry, std::size_t index) {
  const std::string where = "exercise " + std::to_string(index + 1);
  if (!entry.is_object()) throw_expected(where + " to be an object");
  ManifestEntry parsed{text_at(entry, "id", where), text_at(entry, "title", where), {}};
  const nlohmann::json writes = entry.value("writes", nlohmann::json::array());
  if (!writes.is_array()) throw_expected("\"writes\" of " + where + " to be an array");
  for (const nlohmann::json& name : writes) {
    if (!name.is_string()) throw_expected("\"writes\" of " + where + " to hold strings");
    parsed.writes.push_back(name.get<std::string>());
  }
  return parsed;
}

}  // namespace

std::vector<ManifestEntry> parse_manifest(std::string_view json) {
  const nlohmann::json manifest = nlohmann::json::parse(json, nullptr, /*allow_exceptions=*/false);
  if (!manifest.is_object() || !manifest.contains("exercises") ||
      !manifest.at("exercises").is_array()) {
    throw_expected("an object with an array \"exercises\"");
  }
  std::vector<ManifestEntry> entries;
  for (const nlohmann::json& entry : manifest.at("exercises")) {
    entries.push_back(parse_entry(entry, entries.size()));
  }
  return entries;
}

}  // namespace rasterlab
