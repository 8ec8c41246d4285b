#include "common/viewer/viewer.h"

#include "common/image/animation.h"
#include "common/image/files.h"
#include "common/image/window.h"
#include "common/mesh/read_mesh.h"
#include "common/mesh/shapes.h"
#include "common/projection/look_at.h"
#include "common/viewer/camera.h"
#include "common/viewer/flags.h"
#include "common/viewer/tiled_drawing.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <limits>
#include <memory>

namespace rasterlab {
namespace {

constexpr int animation_milliseconds = 40;

// --- What is drawn ---

Image<Rgb8> load(const std::filesystem::path& path) {
  return path.empty() ? Image<Rgb8>() : read_image<Rgb8>(path);
}

const std::string& or_first(const std::string& chosen, const Choices& choices) {
  return chosen.empty() && !choices.empty() ? choices.front().name : chosen;
}

Subject load_subject(const ViewerFlags& flags, const ViewerOptions& options,
                     const std::optional<Scene>& scene) {
  return {.mesh = read_mesh(scene ? scene->mesh : std::filesystem::path(flags.mesh)),
          .color = flags.color,
          .material = flags.material.value_or(scene ? scene->material : Material{}),
          .texture = load(flags.texture),
          .normal_map = load(flags.normal_map),
          .specular_map = load(flags.specular_map),
          .shader = or_first(flags.shader, options.shaders),
          .filter = or_first(flags.filter, options.filters),
          .wrap = or_first(flags.wrap, options.wraps),
          .cull = flags.cull,
          .threads = flags.threads,
          .simd = flags.simd,
          .without = flags.without};
}

// "bunny" for /usr/share/…/bunny.obj, "cube" for builtin:cube:4.
std::string name_of(const ViewerFlags& flags) {
  const std::filesystem::path file =
      flags.scene.empty() ? std::filesystem::path(flags.mesh) : flags.scene;
  std::string name = file.stem().string();
  if (flags.scene.empty() && flags.mesh.starts_with("builtin:")) {
    name = flags.mesh.substr(flags.mesh.find(':') + 1);
    std::replace(name.begin(), name.end(), ':', '_');
  }
  return name;
}

// The box around the mesh; around the origin where there is nothing.
Eigen::AlignedBox3f box_of(const Mesh& mesh) {
  const Eigen::AlignedBox3f box = bounding_box(mesh);
  return box.isEmpty() ? Eigen::AlignedBox3f(-Eigen::Vector3f::Ones(), Eigen::Vector3f::Ones())
                       : box;
}

// --- From where, and in which light ---

// Far away, over the camera's left shoulder.
Light default_light(const Camera& camera) {
  const Eigen::Matrix4f view = look_at(camera.eye, camera.center, camera.up);
  const Eigen::Vector3f in_camera = Eigen::Vector3f(-0.4F, 0.6F, 1).normalized();
  Light light;
  light.position.head<3>() = view.topLeftCorner<3, 3>().transpose() * in_camera;
  light.position.w() = 0;
  return light;
}

// --- What becomes of the pictures ---

// "b_0007.png" for "b.png" and frame 7.
std::filesystem::path numbered(const std::filesystem::path& path, int frame, int frames) {
  if (frames == 0 || path.empty()) return path;
  const std::string last = std::to_string(frames - 1);
  std::string number = std::to_string(frame);
  number.insert(0, std::max<std::size_t>(last.size(), 4) - number.size(), '0');
  return path.parent_path() / (path.stem().string() + "_" + number + path.extension().string());
}

// The largest index that a file for --ids holds besides the one that means nothing.
std::size_t largest_id(const std::filesystem::path& path) {
  return path.extension() == ".pgm" ? 65534 : std::size_t{1} << 24;
}

void write_ids(const std::filesystem::path& path, const Image<std::int32_t>& ids) {
  const auto write = [&]<class Pixel>(Image<Pixel> picture, Pixel nothing) {
    std::transform(ids.pixels().begin(), ids.pixels().end(), picture.pixels().begin(),
                   [&](std::int32_t id) { return id < 0 ? nothing : static_cast<Pixel>(id); });
    write_image(path, picture);
  };
  if (path.extension() == ".pgm") {
    write(Image<std::uint16_t>(ids.width(), ids.height()), std::uint16_t{65535});
  } else {
    write(Image<float>(ids.width(), ids.height()), -1.0F);
  }
}

nlohmann::json timing(std::vector<double> milliseconds) {
  const nlohmann::json samples = milliseconds;
  std::sort(milliseconds.begin(), milliseconds.end());
  const std::size_t middle = milliseconds.size() / 2;
  const double median = milliseconds.size() % 2 == 1
                            ? milliseconds[middle]
                            : (milliseconds[middle - 1] + milliseconds[middle]) / 2;
  return {{"median", median}, {"minimum", milliseconds.front()}, {"samples", samples}};
}

// --- One run ---

class Viewing {
 public:
  Viewing(const ViewerFlags& flags, const ViewerOptions& options, Run& run)
      : flags_(flags),
        run_(run),
        scene_(flags.scene.empty() ? std::nullopt : std::optional(read_scene(flags.scene))),
        subject_(load_subject(flags, options, scene_)),
        stand_{box_of(subject_.mesh), subject_.mesh.positions,
               run.size(scene_ ? Size{scene_->width, scene_->height} : Size{640, 480})},
        camera_(make_camera(merged(flags.camera, scene_ ? camera_of(*scene_) : CameraWishes{}),
                            stand_, camera_turns() ? flags.frames : 1)),
        light_(scene_ ? scene_->light : default_light(camera_)),
        turn_light_(options.turn_light),
        draw_((flags.tiled ? options.tiled : options.exercise)(subject_)) {
    if (flags.light) light_.position = *flags.light;
    if (!flags.ids.empty() && subject_.mesh.triangles.size() > largest_id(flags.ids) + 1) {
      throw UsageError("--ids " + flags.ids.string() + ": the mesh has " +
                       std::to_string(subject_.mesh.triangles.size()) +
                       " faces, more than the format can number: expected a .pfm file");
    }
  }

  void draw() {
    Frame frame = make_frame(stand_.size.width, stand_.size.height);
    if (!flags_.depth.empty()) frame.distance = Image<float>(frame.width(), frame.height());
    if (!flags_.ids.empty()) frame.ids = Image<std::int32_t>(frame.width(), frame.height());
    const int frames = std::max(flags_.frames, 1);
    if (flags_.frames > 0 && !run_.out_is_file()) {
      std::filesystem::create_directories(run_.settings().out);
    }
    for (int i = 0; i < frames; ++i) {
      const nlohmann::json counts = draw_timed(view(i), frame);
      if (i == 0) run_.statistics()["counts"] = counts;
      write(frame, i);
      if (frames > 1) run_.progress("frame", i + 1, frames);
    }
    finish();
  }

  // Until the window is closed.
  void show() {
    Frame frame = make_frame(stand_.size.width, stand_.size.height);
    Window window("RasterLab: " + name_of(flags_));
    bool changed = true;
    for (WindowEvents events; !events.closed; events = window.poll(10)) {
      changed = steer(events) || changed;
      if (changed) draw_(view(0), frame);
      if (changed) window.show(frame.color);
      changed = false;
    }
  }

 private:
  // Moves the camera as the mouse says; whether it said anything.
  bool steer(const WindowEvents& events) {
    constexpr float degrees_per_pixel = 0.4F;
    constexpr float nearer_per_notch = 0.9F;
    if (events.drag_x == 0 && events.drag_y == 0 && events.wheel == 0) return false;
    camera_ = turned(camera_, -degrees_per_pixel * static_cast<float>(events.drag_x));
    camera_ = raised(camera_, degrees_per_pixel * static_cast<float>(events.drag_y));
    camera_ = zoomed(camera_, std::pow(nearer_per_notch, static_cast<float>(events.wheel)));
    return true;
  }

  bool camera_turns() const {
    return flags_.frames > 0 && (flags_.turntable || turn_light_ == nullptr);
  }

  View view(int frame) const {
    const float angle =
        360 * static_cast<float>(frame) / static_cast<float>(std::max(flags_.frames, 1));
    if (camera_turns()) return {transforms_of(turned(camera_, angle), stand_), light_};
    const Transforms transforms = transforms_of(camera_, stand_);
    if (turn_light_ == nullptr) return {transforms, light_};
    return {transforms, turn_light_(light_, camera_.center, camera_.up, angle)};
  }

  nlohmann::json draw_timed(const View& view, Frame& frame) {
    nlohmann::json counts;
    for (int i = 0; i < flags_.repeat; ++i) {
      const auto start = std::chrono::steady_clock::now();
      counts = draw_(view, frame);
      const std::chrono::duration<double, std::milli> elapsed =
          std::chrono::steady_clock::now() - start;
      milliseconds_.push_back(elapsed.count());
      if (flags_.repeat > 1 && flags_.frames == 0) run_.progress("drawn", i + 1, flags_.repeat);
    }
    return counts;
  }

  void write(const Frame& frame, int index) {
    if (flags_.frames == 0) {
      run_.picture(name_of(flags_), frame.color);
    } else {
      write_and_announce(numbered(picture_path(), index, flags_.frames),
                         [&](const auto& path) { write_image(path, frame.color); });
      animation_.add(frame.color);
    }
    write_and_announce(numbered(flags_.depth, index, flags_.frames),
                       [&](const auto& path) { write_image(path, frame.distance); });
    write_and_announce(numbered(flags_.ids, index, flags_.frames),
                       [&](const auto& path) { write_ids(path, frame.ids); });
  }

  template <class Write>
  void write_and_announce(const std::filesystem::path& path, const Write& write) const {
    if (path.empty()) return;
    write(path);
    run_.announce(path);
  }

  // Where the picture goes, or would go if there were one frame only.
  std::filesystem::path picture_path() const {
    return run_.out_is_file() ? run_.settings().out
                              : run_.settings().out / (name_of(flags_) + ".png");
  }

  void finish() {
    if (flags_.frames > 0) {
      write_and_announce(picture_path().replace_extension(".png"),
                         [&](const auto& path) { animation_.write(path, animation_milliseconds); });
    }
    nlohmann::json& statistics = run_.statistics();
    statistics["engine"] = flags_.tiled ? "tiled" : "exercise";
    statistics["size"] = {stand_.size.width, stand_.size.height};
    statistics["triangles"] = subject_.mesh.triangles.size();
    statistics["draw_milliseconds"] = timing(milliseconds_);
  }

  const ViewerFlags& flags_;
  Run& run_;
  std::optional<Scene> scene_;
  Subject subject_;
  Stand stand_;
  Camera camera_;
  Light light_;
  decltype(ViewerOptions::turn_light) turn_light_;
  DrawFrame draw_;
  Animation animation_;
  std::vector<double> milliseconds_;
};

// --- What is printed instead of drawn ---

void print(const Choices& choices) {
  std::size_t width = 0;
  for (const Choice& choice : choices) width = std::max(width, choice.name.size());
  for (const Choice& choice : choices) {
    std::cout << choice.name;
    if (!choice.description.empty()) {
      std::cout << std::string(width + 2 - choice.name.size(), ' ') << choice.description;
    }
    std::cout << "\n";
  }
}

const std::vector<std::string> list_only = {"list"};

// Whether a flag asked for a list, which then was printed.
bool printed_list(const ViewerFlags& flags, const ViewerOptions& options) {
  if (flags.mesh == "builtin:list") {
    for (const Shape& shape : shapes()) {
      std::cout << "builtin:" << shape.name << "  " << shape.description << "\n";
    }
  } else if (flags.shader == "list") {
    print(options.shaders);
  } else if (flags.filter == "list") {
    print(options.filters);
  } else if (flags.wrap == "list") {
    print(options.wraps);
  } else if (flags.simd == "list") {
    print(simd_choices());
  } else if (flags.without == list_only) {
    print(skip_choices(options));
  } else {
    return false;
  }
  return true;
}

bool asks_for_list(const ViewerFlags& flags) {
  return flags.shader == "list" || flags.filter == "list" || flags.wrap == "list" ||
         flags.simd == "list" || flags.without == list_only;
}

void check(const ViewerFlags& flags, const RunSettings& settings) {
  if (!flags.mesh.empty() && !flags.scene.empty()) {
    throw UsageError("--mesh and --scene: expected one of the two");
  }
  if (!settings.exercise.empty()) {
    throw UsageError("--exercise " + settings.exercise +
                     ": expected without --mesh and --scene, which draw a mesh instead");
  }
  if (flags.window && flags.frames > 0) {
    throw UsageError("--window and --frames: expected one of the two");
  }
  const Size size = settings.size.value_or(Size{1, 1});
  if (std::max(size.width, size.height) > longest_side) {
    throw UsageError("--size " + std::to_string(size.width) + "x" + std::to_string(size.height) +
                     ": expected sides of at most " + std::to_string(longest_side));
  }
  if (!flags.without.empty() && !flags.tiled) {
    throw UsageError(
        "--without: expected with --engine tiled, for the exercises' code has no such switches");
  }
  if (flags.turntable && flags.frames == 0) {
    throw UsageError("--turntable: expected with --frames N");
  }
}

}  // namespace

bool Subject::skips(const std::string& name) const {
  return std::find(without.begin(), without.end(), name) == without.end();
}

Choices with_default(Choices choices, const std::string& name) {
  const auto usual = std::find_if(choices.begin(), choices.end(),
                                  [&](const Choice& choice) { return choice.name == name; });
  if (usual != choices.end()) std::rotate(choices.begin(), usual, usual + 1);
  return choices;
}

OwnInput viewer(const ViewerOptions& options) {
  const auto flags = std::make_shared<ViewerFlags>();
  return {
      .add_flags = [=](CLI::App& app) { add_viewer_flags(app, options, *flags); },
      .given =
          [=] {
            const bool asked = flags->asks_for_drawing() || asks_for_list(*flags);
            if (!asked && !flags->first_used.empty()) {
              throw UsageError(flags->first_used + ": expected with --mesh or --scene");
            }
            return asked;
          },
      .run =
          [=](Run& run) {
            if (printed_list(*flags, options)) return;
            check(*flags, run.settings());
            Viewing viewing(*flags, options, run);
            flags->window ? viewing.show() : viewing.draw();
          },
  };
}

}  // namespace rasterlab
