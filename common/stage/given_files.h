// Files the stages draw that come with the project or with Debian.
#pragma once

#include <filesystem>
#include <string>

namespace rasterlab {

/// A file of the repository's `data` folder.
std::filesystem::path data_path(const std::string& file_name);

/// The Stanford bunny of Debian's package glmark2-data. Throws InputError naming the package when
/// it is not installed.
std::filesystem::path bunny_path();

}  // namespace rasterlab
