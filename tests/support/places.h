// Where the tests find what they read and write.
#pragma once

#include <filesystem>

namespace rasterlab {

/// The repository's root.
std::filesystem::path source_folder();

/// The build's root.
std::filesystem::path binary_folder();

/// Where the executables are.
std::filesystem::path programs_folder();

/// The model files of Debian's assimp-testmodels; need not exist.
std::filesystem::path test_models_folder();

}  // namespace rasterlab
