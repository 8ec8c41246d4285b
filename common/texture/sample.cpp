#include "common/texture/sample.h"

#include "common/image/check.h"

namespace rasterlab {
namespace {

/// The entry of that name in a table. Throws InputError.
template <class Table>
const auto& named(const Table& table, std::string_view name, const std::string& what) {
  std::string names;
  for (const auto& entry : table) {
    if (entry.name == name) return entry;
    names += (names.empty() ? "" : ", ") + entry.name;
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

const std::array<NamedWrap, 3>& wrap_modes() {
  static const std::array<NamedWrap, 3> modes = {
      {{Wrap::repeat, "repeat", "the texture over and over"},
       {Wrap::clamp, "clamp", "the colour of its edge"},
       {Wrap::mirror, "mirror", "over and over, every second one mirrored"}}};
  return modes;
}

Filter filter_named(std::string_view name) {
  return named(filter_ladder(), name, "filter").filter;
}

Wrap wrap_named(std::string_view name) {
  return named(wrap_modes(), name, "wrap mode").wrap;
}

}  // namespace rasterlab
