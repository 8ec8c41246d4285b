// Writes the textures of data/ into a folder.
#include "common/image/files.h"
#include "common/stage/guard.h"

#include "data/textures.h"

#include <iostream>

#include <CLI/CLI.hpp>

int main(int argc, char** argv) {
  using namespace rasterlab;
  return run_guarded("make_textures", [&] {
    CLI::App app("Writes the textures of data/ into a folder", "make_textures");
    std::filesystem::path folder;
    app.add_option("FOLDER", folder, "Where to write them")->required();
    try {
      app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
      std::cout << app.help();
      return 0;
    } catch (const CLI::ParseError& error) {
      throw UsageError(error.what());
    }
    std::filesystem::create_directories(folder);
    for (const auto& [file, image] : make_textures()) {
      write_image(folder / file, image);
      std::cout << "wrote " << (folder / file).string() << "\n";
    }
    return 0;
  });
}
