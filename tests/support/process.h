// Runs a program as a user would and keeps everything it says.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace rasterlab {

struct ProcessResult {
  int exit_status = 0;  ///< 128 + signal number when a signal ended it
  bool timed_out = false;
  std::string out;  ///< this and the next: at most 16 MB
  std::string err;
};

struct ProcessOptions {
  std::filesystem::path folder = {};  ///< working directory; empty: this program's
  std::chrono::seconds limit{60};     ///< after this the process and its children are killed
};

/// `command[0]` is looked up in PATH unless it names a folder. Standard input is empty.
/// Throws std::runtime_error when the program cannot be started.
ProcessResult run_process(const std::vector<std::string>& command,
                          const ProcessOptions& options = {});

/// The path of one of this build's executables: "04_projection".
std::string program(const std::string& name);

}  // namespace rasterlab
