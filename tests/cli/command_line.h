// What every executable promises its callers, said as checks.
#pragma once

#include "tests/support/process.h"
#include "tests/support/scratch.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace rasterlab::cli {

/// The executables of the stages present, in order.
std::vector<std::string> stages();

/// Those that draw any mesh: 04 to 07.
std::vector<std::string> viewer_stages();

/// Runs one of this build's executables in `folder`.
ProcessResult run(const std::string& name, const std::vector<std::string>& arguments,
                  const std::filesystem::path& folder);

/// The files under a folder by relative path, with their content.
std::map<std::string, std::string> files_in(const std::filesystem::path& folder);

/// Expects what was printed on standard error to be exactly one line of the program's.
void expect_one_line(const std::string& name, const ProcessResult& result);

/// Runs an executable in an empty folder and expects exactly one line on standard error, starting
/// with its name, the exit status, nothing on standard output, and no file written.
void expect_refusal(const std::string& name, const std::vector<std::string>& arguments, int status);

/// A broken file as an executable may be handed it.
struct BadFile {
  std::string what;
  std::filesystem::path path;
};

/// In `folder`: no such file, a folder, an empty file and noise, each named with this extension
/// (".off").
std::vector<BadFile> bad_files(const std::filesystem::path& folder, const std::string& extension);

}  // namespace rasterlab::cli
