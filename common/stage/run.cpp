#include "common/stage/run.h"

#include "common/image/files.h"
#include "common/stage/guard.h"

#include <cstdio>
#include <fstream>
#include <iostream>

#include <unistd.h>

namespace rasterlab {

Run::Run(RunSettings settings) : settings_(std::move(settings)) {}

/// --out names a file when it ends like one; a folder's name with a dot can be given with a
/// trailing slash.
bool Run::out_is_file() const {
  return settings_.out.has_extension() && settings_.out.has_filename() &&
         !std::filesystem::is_directory(settings_.out);
}

std::filesystem::path Run::path_in_folder(const std::string& file_name) const {
  std::filesystem::create_directories(settings_.out);
  return settings_.out / file_name;
}

void Run::keep_as_single(const std::string& file_name, const Writer& write) {
  if (write_single_) {
    throw UsageError("--out " + settings_.out.string() + " is one file, but both " + single_name_ +
                     " and " + file_name +
                     " are to be written: expected a folder, or --exercise and --algorithm that "
                     "leave one picture");
  }
  single_name_ = file_name;
  write_single_ = write;
}

void Run::finish() {
  if (!write_single_) return;
  write_single_(settings_.out);
  announce(settings_.out);
}

void Run::announce(const std::filesystem::path& path) const {
  if (!settings_.quiet) std::cout << "wrote " << path.string() << "\n" << std::flush;
}

template <class Pixel>
void Run::picture(const std::string& name, const Image<Pixel>& image) {
  const std::string file_name = name + (std::is_same_v<Pixel, float> ? ".pfm" : ".png");
  if (out_is_file()) {
    keep_as_single(file_name, [image](const auto& path) { write_image(path, image); });
    return;
  }
  const std::filesystem::path path = path_in_folder(file_name);
  write_image(path, image);
  announce(path);
}

template void Run::picture(const std::string&, const Image<std::uint8_t>&);
template void Run::picture(const std::string&, const Image<Rgb8>&);
template void Run::picture(const std::string&, const Image<Rgba8>&);
template void Run::picture(const std::string&, const Image<float>&);

void Run::printout(const std::string& name, const std::string& text) {
  const bool is_asked_for = !settings_.exercise.empty();
  if (is_asked_for && !settings_.statistics) {  // whose output is one JSON object and nothing else
    std::cout << text << std::flush;
    return;
  }
  file(name + ".txt", [text](const std::filesystem::path& path) { std::ofstream(path) << text; });
}

void Run::file(const std::string& file_name, const Writer& write) {
  const Writer write_whole = [write](const auto& path) { write_atomically(path, write); };
  if (out_is_file()) {
    keep_as_single(file_name, write_whole);
    return;
  }
  const std::filesystem::path path = path_in_folder(file_name);
  write_whole(path);
  announce(path);
}

void Run::progress(const std::string& label, int done, int total) const {
  if (settings_.quiet || isatty(STDERR_FILENO) == 0) return;
  std::fprintf(stderr, "\r%s %d/%d%s", label.c_str(), done, total, done == total ? "\n" : "");
}

}  // namespace rasterlab
