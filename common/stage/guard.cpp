#include "common/stage/guard.h"

#include "common/image/check.h"

#include <algorithm>
#include <fstream>
#include <iostream>

#include <CLI/CLI.hpp>

namespace rasterlab {
namespace {

/// One line, whatever a library put into its message.
void say(const std::string& program, std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::cerr << program << ": " << message << std::endl;
}

}  // namespace

int run_guarded(const std::string& program, const std::function<int()>& body) {
  try {
    return body();
  } catch (const UsageError& error) {
    say(program, error.what());
    return 2;
  } catch (const CheckError& error) {
    std::ofstream("backtrace_log.txt") << program << ": " << error.what() << "\n"
                                       << error.call_stack();
    say(program, std::string(error.what()) + " (call stack in backtrace_log.txt)");
    return 1;
  } catch (const std::bad_alloc&) {
    say(program, "out of memory");
    return 1;
  } catch (const std::exception& error) {
    say(program, error.what());
    return 1;
  }
}

bool parse_command_line(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    std::cout << app.help();
    return false;
  } catch (const CLI::ParseError& error) {
    throw UsageError(std::string(error.what()) + " (--help lists what there is)");
  }
  return true;
}

}  // namespace rasterlab
