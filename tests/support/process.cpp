#include "tests/support/process.h"

#include "tests/support/places.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <iostream>
#include <stdexcept>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rasterlab {

namespace {

/// What is kept of either output; the rest is read and dropped.
constexpr std::size_t longest_output = std::size_t{1} << 24;

/// A pipe whose ends close themselves.
class Pipe {
 public:
  Pipe() {
    if (pipe2(ends_.data(), O_CLOEXEC) != 0) throw std::runtime_error("cannot make a pipe");
  }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int reading() const { return ends_[0]; }
  int writing() const { return ends_[1]; }
  void close_writing() { close_end(1); }
  void close_reading() { close_end(0); }
  bool open() const { return ends_[0] >= 0; }

  /// Appends what has come in; closes the reading end at its end.
  void drain(std::string& text) {
    std::array<char, 65536> buffer{};
    const ssize_t count = read(reading(), buffer.data(), buffer.size());
    if (count > 0) {
      const std::size_t room = longest_output - std::min(longest_output, text.size());
      text.append(buffer.data(), std::min(static_cast<std::size_t>(count), room));
    } else if (count == 0 || errno != EINTR) {
      close_reading();
    }
  }

 private:
  void close_end(std::size_t end) {
    if (ends_[end] >= 0) close(ends_[end]);
    ends_[end] = -1;
  }

  std::array<int, 2> ends_{-1, -1};
};

[[noreturn]] void become(const std::vector<std::string>& command, const ProcessOptions& options,
                         const Pipe& out, const Pipe& err) {
  setpgid(0, 0);
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  dup2(nothing, STDIN_FILENO);
  dup2(out.writing(), STDOUT_FILENO);
  dup2(err.writing(), STDERR_FILENO);
  std::vector<char*> arguments;
  for (const std::string& argument : command)
    arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  if (options.folder.empty() || chdir(options.folder.c_str()) == 0)
    execvp(arguments[0], arguments.data());
  const char* reason = std::strerror(errno);
  static_cast<void>(!write(STDERR_FILENO, reason, std::strlen(reason)));
  _exit(127);
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& command, const ProcessOptions& options) {
  ProcessResult result;
  Pipe out;
  Pipe err;
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot start " + command.front());
  if (child == 0) become(command, options, out, err);
  out.close_writing();
  err.close_writing();
  const auto end = std::chrono::steady_clock::now() + options.limit;
  while (out.open() || err.open()) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
        end - std::chrono::steady_clock::now());
    if (left.count() <= 0) {
      result.timed_out = true;
      kill(-child, SIGKILL);
      break;
    }
    std::array<pollfd, 2> waiting{{{out.reading(), POLLIN, 0}, {err.reading(), POLLIN, 0}}};
    if (poll(waiting.data(), waiting.size(), static_cast<int>(left.count())) <= 0) continue;
    if (waiting[0].revents != 0) out.drain(result.out);
    if (waiting[1].revents != 0) err.drain(result.err);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  result.exit_status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  if (result.exit_status == 127 && !WIFSIGNALED(status))
    throw std::runtime_error("cannot start " + command.front() + ": " + result.err);
  // In a starter a test says what is missing, whatever it then finds amiss.
  if (result.err.find("not written yet") != std::string::npos) std::cerr << result.err;
  return result;
}

std::string program(const std::string& name) {
  return (programs_folder() / name).string();
}

}  // namespace rasterlab
