#include "common/image/bytes.h"

#include "common/image/check.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>

#include <fcntl.h>
#include <unistd.h>

namespace rasterlab {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void throw_cannot(const char* verb, const fs::path& path, const std::string& why) {
  throw InputError(path.string() + ": cannot be " + verb + ": " + why);
}

/// A new empty file beside `target`; removed with this object unless it became the target.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& target) : target_(target) {
    static std::atomic<unsigned> counter = 0;
    const std::string name = ".rasterlab-" + std::to_string(getpid()) + "-" +
                             std::to_string(counter++) + target.extension().string();
    path_ = target.parent_path() / name;
    const int file = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file < 0) throw_cannot("written", target, std::strerror(errno));
    close(file);
  }
  ~TemporaryFile() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const fs::path& path() const { return path_; }

  void become_target() {
    std::error_code error;
    fs::rename(path_, target_, error);
    if (error) throw_cannot("written", target_, error.message());
    path_.clear();
  }

 private:
  fs::path target_;
  fs::path path_;
};

}  // namespace

std::string read_file(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) throw_cannot("read", path, "it is a folder, expected a file");
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw_cannot("read", path, std::strerror(errno));
  std::string bytes;
  const std::uintmax_t size = fs::file_size(path, error);
  if (!error) bytes.reserve(size);
  char block[1 << 16];
  while (stream.read(block, sizeof block) || stream.gcount() > 0) {
    bytes.append(block, static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) throw_cannot("read", path, std::strerror(errno));
  return bytes;
}

void write_atomically(const fs::path& path,
                      const std::function<void(const fs::path& temporary)>& write) {
  std::error_code error;
  fs::path target = path;
  if (fs::is_symlink(path, error)) {
    const fs::path resolved = fs::canonical(path, error);
    if (!error) target = resolved;
  }
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status)) throw_cannot("written", path, "it is a folder, expected a file");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    write(target);
    return;
  }
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) {
    throw_cannot("written", path, "there is no folder " + folder.string());
  }
  TemporaryFile temporary(target);
  write(temporary.path());
  temporary.become_target();
}

void write_file(const fs::path& path, std::string_view bytes) {
  write_atomically(path, [&](const fs::path& temporary) {
    errno = 0;
    std::ofstream stream(temporary, std::ios::binary);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (!stream) throw_cannot("written", path, std::strerror(errno));
  });
}

}  // namespace rasterlab
