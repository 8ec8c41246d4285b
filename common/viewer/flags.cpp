#include "common/viewer/flags.h"

#include "common/image/window.h"
#include "common/stage/guard.h"
#include "common/viewer/tiled_drawing.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

namespace rasterlab {
namespace {

constexpr const char* group = "Drawing any mesh";

[[noreturn]] void refuse(const std::string& flag, const std::string& text,
                         const std::string& expected) {
  throw UsageError(flag + " " + text + ": expected " + expected);
}

// What is between the commas of `text`.
std::vector<std::string> split(std::string_view text) {
  std::vector<std::string> fields;
  while (true) {
    const std::string_view field = text.substr(0, text.find(','));
    fields.emplace_back(field);
    if (field.size() == text.size()) return fields;
    text.remove_prefix(field.size() + 1);
  }
}

// The numbers between the commas of `text`; empty where one of them is none.
std::vector<float> split_numbers(std::string_view text) {
  std::vector<float> numbers;
  for (const std::string& field : split(text)) {
    const char* end = field.data() + field.size();
    float number = 0;
    const auto [rest, error] = std::from_chars(field.data(), end, number);
    if (error != std::errc() || rest != end || !std::isfinite(number)) return {};
    numbers.push_back(number);
  }
  return numbers;
}

// Adds a flag whose value is from `least` to `most` numbers between commas.
template <class Store>
void add_numbers(CLI::App& app, const std::string& flag, const std::string& form,
                 const std::string& description, std::size_t least, std::size_t most, Store store) {
  app.add_option_function<std::string>(
         flag,
         [=](const std::string& text) {
           const std::vector<float> numbers = split_numbers(text);
           if (numbers.size() < least || numbers.size() > most) {
             refuse(flag, text, form + ", finite numbers between commas");
           }
           store(numbers, text);
         },
         description)
      ->type_name(form)
      ->group(group);
}

void add_vector(CLI::App& app, const std::string& flag, const std::string& description,
                std::optional<Eigen::Vector3f>& value) {
  add_numbers(app, flag, "x,y,z", description, 3, 3,
              [&value](const std::vector<float>& numbers, const std::string&) {
                value = Eigen::Vector3f(numbers[0], numbers[1], numbers[2]);
              });
}

void add_number(CLI::App& app, const std::string& flag, const std::string& form,
                const std::string& description, std::optional<float>& value) {
  add_numbers(
      app, flag, form, description, 1, 1,
      [&value](const std::vector<float>& numbers, const std::string&) { value = numbers[0]; });
}

void add_count(CLI::App& app, const std::string& flag, const std::string& description, int least,
               int& value) {
  app.add_option_function<std::string>(
         flag,
         [=, &value](const std::string& text) {
           const std::vector<float> numbers = split_numbers(text);
           if (numbers.size() != 1 || numbers[0] < static_cast<float>(least) || numbers[0] > 1e6F ||
               numbers[0] != std::floor(numbers[0])) {
             refuse(flag, text, "a whole number from " + std::to_string(least) + " to 1000000");
           }
           value = static_cast<int>(numbers[0]);
         },
         description)
      ->type_name("N")
      ->group(group);
}

template <class Value>
void add_file(CLI::App& app, const std::string& flag, const std::string& form,
              const std::string& description, Value& value) {
  app.add_option_function<std::string>(
         flag,
         [=, &value](const std::string& text) {
           if (text.empty()) refuse(flag, "''", "the name of a file");
           value = text;
         },
         description)
      ->type_name(form)
      ->group(group);
}

// A file to write that holds what pictures don't: the last letters of its name say in which format.
void add_result(CLI::App& app, const std::string& flag, const std::vector<std::string>& extensions,
                const std::string& description, std::filesystem::path& path) {
  std::string form = "FILE" + extensions.front();
  for (std::size_t i = 1; i < extensions.size(); ++i) form += "|" + extensions[i];
  app.add_option_function<std::string>(
         flag,
         [=, &path](const std::string& text) {
           path = text;
           if (std::find(extensions.begin(), extensions.end(), path.extension()) ==
               extensions.end()) {
             refuse(flag, text.empty() ? "''" : text, form);
           }
         },
         description)
      ->type_name(form)
      ->group(group);
}

std::string joined(const Choices& choices) {
  std::string all;
  for (const Choice& choice : choices) all += (all.empty() ? "" : ", ") + choice.name;
  return all;
}

std::string default_of(const Choices& choices) {
  return choices.empty() ? "" : " (default " + choices.front().name + "); 'list' names the ways";
}

bool has(const Choices& choices, const std::string& name) {
  return std::any_of(choices.begin(), choices.end(),
                     [&](const Choice& choice) { return choice.name == name; });
}

// Adds a flag whose value is one of `choices`, the first unless given, or `list`.
void add_choice(CLI::App& app, const std::string& flag, const std::string& description,
                const Choices& choices, std::string& value) {
  if (choices.empty()) return;
  app.add_option_function<std::string>(
         flag,
         [=, &value](const std::string& text) {
           if (text != "list" && !has(choices, text)) {
             refuse(flag, text, "list or one of " + joined(choices));
           }
           value = text;
         },
         description)
      ->type_name("NAME")
      ->group(group);
}

// Adds a flag whose value is some of `choices` between commas, or `list`.
void add_choices(CLI::App& app, const std::string& flag, const std::string& description,
                 const Choices& choices, std::vector<std::string>& values) {
  app.add_option_function<std::string>(
         flag,
         [=, &values](const std::string& text) {
           values = split(text);
           for (const std::string& value : values) {
             if (text != "list" && !has(choices, value)) {
               refuse(flag, value.empty() ? "''" : value,
                      "list or, between commas, some of " + joined(choices));
             }
           }
         },
         description)
      ->type_name("NAME,...")
      ->group(group);
}

void add_camera_flags(CLI::App& app, CameraWishes& camera) {
  add_vector(app, "--eye", "Where the camera stands; without it the mesh is framed", camera.eye);
  add_vector(app, "--center", "What it looks at (default: the middle of the mesh)", camera.center);
  add_vector(app, "--up", "Which way is up (default 0,1,0)", camera.up);
  add_number(app, "--fovy", "DEG", "Angle between bottom and top of the picture (default 40)",
             camera.fovy);
  add_number(app, "--near", "N", "Distance of the near plane (default: fits the mesh)",
             camera.near);
  app.add_option_function<std::string>(
         "--far",
         [&camera](const std::string& text) {
           const std::vector<float> numbers = split_numbers(text);
           if (text != "inf" && numbers.size() != 1) refuse("--far", text, "a number or inf");
           camera.far = text == "inf" ? std::numeric_limits<float>::infinity() : numbers[0];
         },
         "Distance of the far plane (default inf; with --ortho: fits the mesh)")
      ->type_name("N|inf")
      ->group(group);
  add_number(app, "--ortho", "H", "No perspective: what is seen is H high", camera.ortho_height);
}

void add_surface_flags(CLI::App& app, const ViewerOptions& options, ViewerFlags& flags) {
  if (options.turn_light != nullptr) {
    add_numbers(app, "--light", "x,y,z,w",
                "The light, at (x,y,z)/w, or in direction (x,y,z) when w is 0 (without w: 1); by "
                "default far away, over the camera's left shoulder",
                3, 4, [&flags](const std::vector<float>& n, const std::string& text) {
                  flags.light = Eigen::Vector4f(n[0], n[1], n[2], n.size() > 3 ? n[3] : 1);
                  if (flags.light->isZero(0)) {
                    refuse("--light", text, "x,y,z,w that are not all 0");
                  }
                });
    add_numbers(app, "--material", "ka,kd,ks,shininess",
                "Shares of ambient, diffuse and specular light, exponent of the highlight (default "
                "0.2,0.8,0.6,128)",
                4, 4, [&flags](const std::vector<float>& n, const std::string& text) {
                  if (*std::min_element(n.begin(), n.end()) < 0) {
                    refuse("--material", text, "ka,kd,ks,shininess, none below 0");
                  }
                  flags.material = Material{n[0], n[1], n[2], n[3]};
                });
  }
  add_numbers(app, "--color", "r,g,b", "Colour of the surface, each 0 to 1 (default: the mesh's)",
              3, 3, [&flags](const std::vector<float>& n, const std::string& text) {
                const auto [least, most] = std::minmax_element(n.begin(), n.end());
                if (*least < 0 || *most > 1) refuse("--color", text, "r,g,b, each from 0 to 1");
                flags.color = Color(n[0], n[1], n[2]);
              });
  if (options.textured) {
    add_file(app, "--texture", "FILE", "Picture that gives the surface its colour", flags.texture);
  }
  if (options.mapped) {
    add_file(app, "--normal-map", "FILE", "Picture that tilts the surface's normals",
             flags.normal_map);
    add_file(app, "--specular-map", "FILE", "Picture that says how strong highlights are",
             flags.specular_map);
  }
  add_choice(app, "--shader", "How surfaces are shaded" + default_of(options.shaders),
             options.shaders, flags.shader);
  add_choice(app, "--filter", "How textures are read" + default_of(options.filters),
             options.filters, flags.filter);
  add_choice(app, "--wrap", "What a texture is beyond its edges" + default_of(options.wraps),
             options.wraps, flags.wrap);
}

void add_cull_flag(CLI::App& app, Cull& cull) {
  app.add_option_function<std::string>(
         "--cull",
         [&cull](const std::string& text) {
           if (text == "none") {
             cull = Cull::none;
           } else if (text == "back") {
             cull = Cull::back;
           } else if (text == "front") {
             cull = Cull::front;
           } else {
             refuse("--cull", text, "none, back or front");
           }
         },
         "Leave out the faces that turn this side to the camera (default none)")
      ->type_name("none|back|front")
      ->group(group);
}

void add_engine_flags(CLI::App& app, const ViewerOptions& options, ViewerFlags& flags) {
  flags.tiled = options.tiled && options.tiled_by_default;
  if (!options.tiled) return;
  app.add_option_function<std::string>(
         "--engine",
         [&flags](const std::string& text) {
           if (text != "exercise" && text != "tiled") {
             refuse("--engine", text, "exercise or tiled");
           }
           flags.tiled = text == "tiled";
         },
         "What draws: the exercises' code, or the fast engine; both cover the same pixels "
         "(default " +
             std::string(flags.tiled ? "tiled)" : "exercise)"))
      ->type_name("exercise|tiled")
      ->group(group);
  add_count(app, "--threads", "Threads of the tiled engine; 0 = all cores (default)", 0,
            flags.threads);
  add_choice(app, "--simd",
             "Instruction set of the tiled engine (default: the best); 'list' names them",
             simd_choices(), flags.simd);
  add_choices(app, "--without",
              "What the tiled engine is not to skip (--stats counts what it skips; no pixel "
              "changes); not with --engine exercise; 'list' names them",
              skip_choices(options), flags.without);
}

void add_output_flags(CLI::App& app, ViewerFlags& flags) {
  add_count(app, "--frames",
            "Go round once in N pictures NAME_0000.png … and as one that plays, NAME.png", 1,
            flags.frames);
  app.add_flag("--turntable", flags.turntable, "With --frames: the camera goes round")
      ->group(group);
  add_count(app, "--repeat", "Draw N times; --stats gives median, minimum and all times", 1,
            flags.repeat);
  add_result(app, "--depth", {".pfm"}, "Write the distance along the view axis, +inf for nothing",
             flags.depth);
  add_result(app, "--ids", {".pgm", ".pfm"},
             "Write the index of the face seen at each pixel; nothing is 65535 in .pgm, -1 in .pfm",
             flags.ids);
  if (windows_are_built_in()) {
    app.add_flag("--window", flags.window,
                 "Show it live: drag turns, the wheel zooms, Esc leaves; nothing is written")
        ->group(group);
  }
}

}  // namespace

void add_viewer_flags(CLI::App& app, const ViewerOptions& options, ViewerFlags& flags) {
  add_file(app, "--mesh", "FILE",
           "Draw this mesh (OFF, OBJ, PLY, STL, OM) or builtin:NAME; builtin:list names those",
           flags.mesh);
  add_file(app, "--scene", "FILE.scene", "Draw this scene: mesh, camera, light, material",
           flags.scene);
  add_camera_flags(app, flags.camera);
  add_surface_flags(app, options, flags);
  add_cull_flag(app, flags.cull);
  add_engine_flags(app, options, flags);
  add_output_flags(app, flags);
  app.parse_complete_callback([&app, &flags] {
    for (const CLI::Option* option : app.get_options()) {
      if (option->get_group() == group && option->count() > 0 && flags.first_used.empty()) {
        flags.first_used = option->get_name();
      }
    }
  });
}

}  // namespace rasterlab
