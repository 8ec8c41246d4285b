// How an executable of ours ends when something goes wrong.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace CLI {
class App;
}

namespace rasterlab {

/// A command line that asks for what is not there. Ends an executable with exit status 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs `body` and returns its exit status. What it throws becomes one line on standard error,
/// "PROGRAM: message", and the status 2 for UsageError, else 1. A failed check also leaves its call
/// stack in `backtrace_log.txt`.
int run_guarded(const std::string& program, const std::function<int()>& body);

/// Parses a command line; false when it asked for help, which is then printed. Throws UsageError.
bool parse_command_line(CLI::App& app, int argc, char** argv);

}  // namespace rasterlab
