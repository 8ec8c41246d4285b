// The viewer's flags, as given on the command line.
#pragma once

#include "common/image/pixel.h"
#include "common/projection/triangle_pixels.h"
#include "common/viewer/camera.h"
#include "common/viewer/viewer.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Dense>

namespace CLI {
class App;
}

namespace rasterlab {

struct ViewerFlags {
  std::string mesh;
  std::filesystem::path scene;
  CameraWishes camera;
  std::optional<Eigen::Vector4f> light;
  std::optional<Material> material;
  std::optional<Color> color;
  std::filesystem::path texture;
  std::filesystem::path normal_map;
  std::filesystem::path specular_map;
  std::string shader;
  std::string filter;
  std::string wrap;
  Cull cull = Cull::none;
  bool tiled = false;
  int threads = 0;
  std::string simd;
  std::vector<std::string> without;
  int frames = 0;  ///< 0: a single picture
  bool turntable = false;
  int repeat = 1;
  std::filesystem::path depth;
  std::filesystem::path ids;
  bool window = false;
  std::string first_used = {};  ///< the first of these flags on the command line

  bool asks_for_drawing() const { return !mesh.empty() || !scene.empty(); }
};

/// Adds the flags of what the stage offers; parsing fills in `flags`, which outlives `app`. What is
/// no value of its flag throws UsageError.
void add_viewer_flags(CLI::App& app, const ViewerOptions& options, ViewerFlags& flags);

}  // namespace rasterlab
