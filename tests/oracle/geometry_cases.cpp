#include "tests/oracle/geometry_cases.h"

#include "common/mesh/read_mesh.h"

#include "tests/support/places.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <limits>
#include <regex>

namespace rasterlab::oracle {

namespace fs = std::filesystem;

std::vector<GeometryCase> built_in_cases() {
  const double infinity = std::numeric_limits<double>::infinity();
  return {
      {.name = "cube", .mesh = "builtin:cube"},
      {.name = "cube_culled", .mesh = "builtin:cube", .cull = Cull::back},
      {.name = "cube_inside_out", .mesh = "builtin:cube:3", .cull = Cull::front},
      {.name = "cube_from_inside",
       .mesh = "builtin:cube:2",
       .viewpoint = {.eye = {0.3, -0.2, 0.5}, .center = {-1, 0.4, -1}, .fovy = 100, .near = 0.01}},
      {.name = "cube_cut_by_near_plane",
       .mesh = "builtin:cube:4",
       .viewpoint = {.eye = {1.2, 0.9, 1.1}, .fovy = 75, .near = 0.6}},
      {.name = "wall", .mesh = "builtin:wall"},
      {.name = "wall_from_behind_tall",
       .mesh = "builtin:wall:5",
       .viewpoint = {.eye = {-0.8, 0.3, -1.5}},
       .width = 50,
       .height = 91},
      {.name = "grid_to_infinity",
       .mesh = "builtin:grid:7",
       .viewpoint = {.eye = {0.1, 0.15, 0.2},
                     .center = {0, 0, -1},
                     .fovy = 60,
                     .near = 0.05,
                     .far = infinity}},
      {.name = "uv_sphere", .mesh = "builtin:uv_sphere"},
      {.name = "icosphere_orthographic",
       .mesh = "builtin:icosphere",
       .viewpoint = {.eye = {3, 1, 2}, .ortho = 2.5}},
      {.name = "torus", .mesh = "builtin:torus", .cull = Cull::back},
      {.name = "torus_from_inside_the_tube",
       .mesh = "builtin:torus:24",
       .viewpoint = {.eye = {0.7, 0, 0}, .center = {0.6, 0, 1}, .fovy = 90, .near = 0.001}},
      {.name = "torus_knot", .mesh = "builtin:torus_knot", .width = 160, .height = 120},
      {.name = "torus_knot_upside_down_long_lens",
       .mesh = "builtin:torus_knot:6",
       .viewpoint = {.eye = {-9, -7, 12}, .up = {0.2, -1, 0}, .fovy = 7, .near = 1, .far = 40}},
  };
}

GeometryCase framed(const std::string& name, const fs::path& file, const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Mesh::Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) box.extend(mesh.positions[vertex].cast<double>());
  }
  const double radius = box.diagonal().norm() / 2;
  GeometryCase geometry{.name = name, .mesh = file.string(), .width = 120, .height = 90};
  geometry.viewpoint.center = box.center();
  geometry.viewpoint.eye = box.center() + radius * Eigen::Vector3d(1.3, 0.9, 2.2);
  geometry.viewpoint.near = 0.2 * radius;
  geometry.viewpoint.far = 8 * radius;
  return geometry;
}

namespace {

bool is_mesh_file(const fs::path& path) {
  std::string extension = path.extension();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension == ".off" || extension == ".obj" || extension == ".ply" || extension == ".stl";
}

}  // namespace

std::vector<GeometryCase> foreign_cases() {
  std::vector<fs::path> files{"/usr/share/glmark2/models/bunny.obj"};
  for (const char* folder : {"OBJ", "OFF", "PLY", "STL"}) {
    const fs::path path = test_models_folder() / folder;
    if (!fs::exists(path)) continue;
    for (const auto& entry : fs::directory_iterator(path)) {
      if (is_mesh_file(entry.path())) files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<GeometryCase> cases;
  for (const fs::path& file : files) {
    const std::string name =
        std::regex_replace(file.filename().string(), std::regex("[^A-Za-z0-9]"), "_");
    try {
      const Mesh mesh = read_mesh(file);
      if (!mesh.empty()) cases.push_back(framed(name, file, mesh));
    } catch (const std::exception& error) {
      std::cout << "left out: " << error.what() << "\n";
    }
  }
  return cases;
}

Agreement expect_geometry(const std::string& stage, const GeometryCase& geometry,
                          const std::vector<std::string>& more_flags) {
  const auto& [name, mesh, viewpoint, width, height, cull] = geometry;
  std::vector<std::string> flags = viewpoint.flags();
  flags.insert(flags.end(), {"--cull", cull_name(cull)});
  flags.insert(flags.end(), more_flags.begin(), more_flags.end());
  const Picture picture = take_picture(stage, mesh, width, height, flags);
  const RayCaster witness(read_mesh(mesh), viewpoint.camera(width, height), width, height, cull);
  Agreement agreement = compare_geometry(witness, picture);
  std::cout << mesh << ": " << agreement;
  EXPECT_EQ(agreement.wrong, 0) << agreement;
  return agreement;
}

}  // namespace rasterlab::oracle
