#include "common/texture/sample.h"

#include "common/image/check.h"

#include <algorithm>

namespace rasterlab {
namespace {

struct NamedWrap {
  Wrap wrap;
  std::string_view name;
};

constexpr std::array<NamedWrap, 3> wraps = {
    {{Wrap::repeat, "repeat"}, {Wrap::clamp, "clamp"}, {Wrap::mirror, "mirror"}}};

/// The entry of that name in a table. Throws InputError.
template <class Table>
const auto& named(const Table& table, std::string_view name, const std::string& what) {
  std::string names;
  for (const auto& entry : table) {
    if (entry.name == name) return entry;
    names += (names.empty() ? "" : ", ") + std::string(entry.name);
  }
  throw InputError("no " + what + " is called '" + std::string(name) + "': expected one of " +
                   names);
}

}  // namespace

const std::array<FilterRung, 5>& filter_ladder() {
  static const std::array<FilterRung, 5> ladder = {
      {{Filter::nearest, "nearest", "squares near by, sparkle far off"},
       {Filter::bilinear, "bilinear", "sparkle far off"},
       {Filter::mip_mapped, "mip-mapped", "lines between the levels, blurred at grazing angles"},
       {Filter::trilinear, "trilinear", "blurred at grazing angles"},
       {Filter::anisotropic, "anisotropic", "blurred where a pixel is over 16 times as long"}}};
  return ladder;
}

std::vector<std::string> filter_names() {
  std::vector<std::string> names;
  for (const FilterRung& rung : filter_ladder()) names.push_back(rung.name);
  // The first is taken where none is asked for.
  const auto usual = std::find(names.begin(), names.end(), "trilinear");
  std::rotate(names.begin(), usual, usual + 1);
  return names;
}

std::vector<std::string> wrap_names() {
  std::vector<std::string> names;
  for (const NamedWrap& wrap : wraps) names.emplace_back(wrap.name);
  return names;
}

Filter filter_named(std::string_view name) {
  return named(filter_ladder(), name, "filter").filter;
}

Wrap wrap_named(std::string_view name) {
  return named(wraps, name, "wrap mode").wrap;
}

}  // namespace rasterlab
