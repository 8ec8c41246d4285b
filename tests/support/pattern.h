// Names with a star in them, as manifests use them.
#pragma once

#include <string>

namespace rasterlab {

/// Whether a name matches a pattern in which * stands for anything: "stage01.draw_line.*".
bool matches(const std::string& pattern, const std::string& name);

}  // namespace rasterlab
