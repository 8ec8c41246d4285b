// Where a measurement comes from.
#pragma once

#include <string>

namespace rasterlab::bench {

/// The commit that the sources are at, "-dirty" when they have been changed since.
const std::string& commit();

/// The processor's name.
const std::string& machine();

}  // namespace rasterlab::bench
