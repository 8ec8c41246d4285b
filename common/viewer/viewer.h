// What stages 04 to 07 share to draw any mesh from any side: the flags of `--mesh FILE`, loading,
// framing, the light or the camera going round, depth and ids as files, timing, the live window. A
// stage brings how a frame is drawn.
//
//   int main(int argc, char** argv) {
//     return run_stage(argc, argv, {.name = "04_projection", .exercises = …,
//                                   .own_inputs = {viewer({.exercise = &make_drawing})}});
//   }
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/mesh/mesh.h"
#include "common/projection/draw_mesh.h"
#include "common/projection/frame.h"
#include "common/projection/scene.h"
#include "common/stage/stage.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace rasterlab {

/// What is drawn and how: loaded and decided once, the same for every frame.
struct Subject {
  Mesh mesh;
  std::optional<Color> color = {};  ///< --color; not given: the mesh's own colours, else grey
  Material material = {};
  Image<Rgb8> texture = {};  ///< this and the next two are empty where not given
  Image<Rgb8> normal_map = {};
  Image<Rgb8> specular_map = {};
  std::string shader = {};  ///< this and the next two are among those the stage offers
  std::string filter = {};
  std::string wrap = {};
  Cull cull = Cull::none;
  int threads = 0;                        ///< of the tiled engine; 0: all cores
  std::string simd = {};                  ///< of the tiled engine; empty: the best there is
  std::vector<std::string> without = {};  ///< what not to skip: see skips()

  /// Whether to skip what has that name, in the engine or when preparing: unless `without` has it.
  bool skips(const std::string& name) const;
};

/// From where a frame is seen and in which light.
struct View {
  Transforms transforms;
  Light light;  ///< in the world
};

/// Draws a frame, over whatever was in it. Returns what --stats shows under "counts": work done,
/// and work skipped by reason.
using DrawFrame = std::function<nlohmann::json(const View& view, Frame& frame)>;

/// Prepares what is the same for every frame, and gives what draws one. The subject outlives it.
using PrepareDrawing = std::function<DrawFrame(const Subject& subject)>;

/// A value that a flag takes, as `list` shows it.
struct Choice {
  std::string name;
  std::string description = {};
};
using Choices = std::vector<Choice>;

/// The same with the choice of that name first, where a flag's default stands.
Choices with_default(Choices choices, const std::string& name);

/// What a stage brings. Flags for what it does not offer do not exist.
struct ViewerOptions {
  PrepareDrawing exercise;
  PrepareDrawing tiled = {};  ///< empty: no --engine, --threads, --simd, --without
  bool tiled_by_default = false;
  /// The light carried round an axis through a centre by an angle in degrees; given: --light,
  /// --material, and --frames turns the light.
  Light (*turn_light)(const Light& light, const Eigen::Vector3f& center,
                      const Eigen::Vector3f& axis, float angle) = nullptr;
  bool textured = false;  ///< --texture
  bool mapped = false;    ///< --normal-map, --specular-map
  Choices shaders = {};   ///< --shader; the first is the default
  Choices filters = {};   ///< --filter; the first is the default
  Choices wraps = {};     ///< --wrap; the first is the default
  Choices skips = {};     ///< what preparing a drawing skips, for --without
};

/// The viewer as one of a stage's own inputs: it runs when --mesh or --scene is given.
OwnInput viewer(const ViewerOptions& options);

}  // namespace rasterlab
