// Whole files: read, and written so that no half of one is ever seen.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace rasterlab {

/// All bytes of a file. Throws InputError when it does not exist, is a folder or cannot be read.
std::string read_file(const std::filesystem::path& path);

/// Makes a file whole or not at all: `write` gets the path of a temporary file beside `path`, of
/// the same extension, which is renamed to `path` when `write` returns and removed when it throws.
/// A symbolic link is followed. Where `path` is no ordinary file, as /dev/stdout, `write` gets
/// `path` itself. Throws InputError when `path` is a folder, or its folder is missing or not
/// writable.
void write_atomically(const std::filesystem::path& path,
                      const std::function<void(const std::filesystem::path& temporary)>& write);

/// Makes a file of these bytes, whole or not at all. Throws InputError when that cannot be.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace rasterlab
