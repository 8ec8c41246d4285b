// The pictures of stage 06 against the ray caster: textures and light in double precision.
#include "common/image/files.h"
#include "common/mesh/read_mesh.h"
#include "common/mesh/shapes.h"

#include "tests/oracle/geometry_cases.h"
#include "tests/oracle/shading.h"
#include "tests/oracle/soft_picture.h"
#include "tests/oracle/texturing.h"
#include "tests/support/places.h"
#include "tests/support/scratch.h"

#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include <gtest/gtest.h>

namespace rasterlab::oracle {
namespace {

namespace fs = std::filesystem;

class stage06_witness_of : public testing::TestWithParam<GeometryCase> {};

TEST_P(stage06_witness_of, sees_the_same) {
  EXPECT_GT(expect_geometry("06_texture", GetParam()).drawn, 0) << "nothing to compare";
}

INSTANTIATE_TEST_SUITE_P(, stage06_witness_of, testing::ValuesIn(built_in_cases()),
                         case_name<testing::TestParamInfo<GeometryCase>>);

/// Draws with stage 06 and compares colours; the texture is a file.
Agreement compare_textured(const GeometryCase& geometry, const fs::path& texture_file,
                           const std::string& filter, const std::string& wrap) {
  const auto& [name, mesh_name, viewpoint, width, height, cull] = geometry;
  Lighting lighting{.light = {1, 2, 3, 0}, .shininess = 20};
  std::vector<std::string> flags = viewpoint.flags();
  const std::vector<std::string> light = lighting.flags();
  flags.insert(flags.end(), light.begin(), light.end());
  flags.insert(flags.end(), {"--cull", cull_name(cull), "--texture", texture_file.string(),
                             "--filter", filter, "--wrap", wrap});
  const Picture picture = take_picture("06_texture", mesh_name, width, height, flags);
  const Mesh mesh = read_mesh(mesh_name);
  const RayCaster witness(mesh, viewpoint.camera(width, height), width, height, cull);
  const Surface surface(mesh);
  const DeepTexture texture(read_image<Rgb8>(texture_file));
  lighting.eye = eye_of(viewpoint);
  Agreement agreement =
      compare_colors(witness, picture.color, [&](double x, double y, const Hit& hit) {
        const Shade read = sample(texture, filter, wrap, steps_at(witness, surface, x, y, hit));
        Shade shade = light_point(lighting, surface.position(hit), surface.normal(hit), read.color);
        shade.key.insert(shade.key.end(), read.key.begin(), read.key.end());
        shade.at_jump = read.at_jump;
        return shade;
      });
  std::cout << mesh_name << " " << filter << " " << wrap << ": " << agreement;
  EXPECT_EQ(agreement.wrong, 0) << agreement << testing::PrintToString(flags);
  return agreement;
}

TEST_P(stage06_witness_of, is_textured_the_same_by_every_filter) {
  const ScratchFolder scratch;
  write_image(scratch / "soft.png", soft_picture());
  const std::vector<std::string> wraps{"repeat", "clamp", "mirror"};
  std::size_t turn = 0;
  for (const std::string filter :
       {"nearest", "bilinear", "mip-mapped", "trilinear", "anisotropic"}) {
    compare_textured(GetParam(), scratch / "soft.png", filter, wraps[turn++ % 3]);
  }
}

/// A mesh whose texture coordinates leave [0, 1] on every side.
fs::path far_reaching_wall(const fs::path& folder) {
  const std::string text =
      "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt -1.7 -2.2\nvt 2.6 -1.9\nvt 2.3 1.8\nvt -1.4 2.7\n"
      "vn 0 0 1\nf 1/1/1 2/2/1 3/3/1 4/4/1\n";
  write_file(folder / "wall.obj", text);
  return folder / "wall.obj";
}

TEST(stage06_witness, coordinates_outside_wrap_the_same) {
  const ScratchFolder scratch;
  write_image(scratch / "soft.png", soft_picture());
  const GeometryCase geometry{
      .name = "wall", .mesh = far_reaching_wall(scratch.path()), .width = 200, .height = 150};
  for (const std::string wrap : {"repeat", "clamp", "mirror"}) {
    for (const std::string filter : {"nearest", "bilinear", "trilinear"}) {
      EXPECT_GT(compare_textured(geometry, scratch / "soft.png", filter, wrap).drawn, 5000);
    }
  }
}

/// The textured models beside the repository, which are no part of it.
TEST(stage06_witness, real_textured_models_are_the_same) {
  const fs::path folder = source_folder().parent_path() / "shared/data";
  if (!fs::exists(folder / "spot")) {
    GTEST_SKIP() << "NOT COMPARED: the textured models are not in " << folder;
  }
  const std::vector<std::pair<std::string, std::string>> models{
      {"spot/spot_triangulated.obj", "spot/spot_texture.png"},
      {"frankie/Frankie.obj", "frankie/flyingsquirrel_skin_col.png"}};
  for (const auto& [mesh_file, texture] : models) {
    GeometryCase geometry = framed("model", folder / mesh_file, read_mesh(folder / mesh_file));
    geometry.width = 240;
    geometry.height = 180;
    for (const std::string filter : {"trilinear", "anisotropic"}) {
      EXPECT_GT(compare_textured(geometry, folder / texture, filter, "repeat").drawn, 1000);
    }
  }
}

// --- The exercises' own figures ---

/// A figure by one texture, lit or not.
void expect_textured_figure(const std::string& file, const Image<Rgb8>& figure,
                            const FigureScene& scene, const fs::path& texture_file,
                            const std::string& filter, const std::optional<Lighting>& lighting) {
  const RayCaster witness(scene.mesh, scene.camera, figure.width(), figure.height(), scene.cull);
  const Surface surface(scene.mesh);
  const DeepTexture texture(read_image<Rgb8>(texture_file));
  const Agreement agreement =
      compare_colors(witness, figure, [&](double x, double y, const Hit& hit) {
        Shade shade = sample(texture, filter, "repeat", steps_at(witness, surface, x, y, hit));
        if (!lighting) return shade;
        Shade lit = light_point(*lighting, surface.position(hit), surface.normal(hit), shade.color);
        lit.key.insert(lit.key.end(), shade.key.begin(), shade.key.end());
        lit.at_jump = shade.at_jump;
        return lit;
      });
  std::cout << file << ": " << agreement;
  EXPECT_EQ(agreement.wrong, 0) << file << ": " << agreement;
  EXPECT_GT(agreement.drawn, 10000) << file;
}

/// For filters that look at no neighbours.
Steps at_point(const Eigen::Vector2d& uv) {
  return {uv, Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
}

/// The letter of 06.1, from the top.
Image<Rgb8> letter() {
  const std::array<std::string, 8> rows{"r.......", "..####..", "..#.....", "..###...",
                                        "..#.....", "..#.....", "..#.....", ".......b"};
  Image<Rgb8> image(8, 8);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const char pixel = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
      image(x, y) = pixel == '#'   ? Rgb8{40, 60, 90}
                    : pixel == 'r' ? Rgb8{220, 40, 40}
                    : pixel == 'b' ? Rgb8{40, 80, 220}
                                   : Rgb8{255, 240, 200};
    }
  }
  return image;
}

/// (u, v) goes from (−1, −1) at the bottom left to (2, 2).
TEST(stage06_figures, a_letter_repeated_clamped_and_mirrored) {
  const Figures figures("06_texture", "06.1");
  const DeepTexture texture(letter());
  for (const std::string wrap : {"repeat", "clamp", "mirror"}) {
    const Image<Rgb8> figure = figures("06.1_" + wrap + ".png");
    int wrong = 0;
    for (int y = 0; y < figure.height(); ++y) {
      for (int x = 0; x < figure.width(); ++x) {
        const Steps steps =
            at_point({3 * (x + 0.5) / figure.width() - 1, 2 - 3 * (y + 0.5) / figure.height()});
        const Eigen::Vector3d color = 255 * sample(texture, "nearest", wrap, steps).color;
        const Rgb8 stored = figure(x, y);
        const Eigen::Vector3d actual(stored.r, stored.g, stored.b);
        if ((actual - color).cwiseAbs().maxCoeff() > 0.5) ++wrong;
      }
    }
    EXPECT_EQ(wrong, 0) << wrap << ", of " << figure.width() << "x" << figure.height();
  }
}

TEST(stage06_figures, the_planet) {
  const Eigen::Vector3d eye(0, 1.2, 3);
  expect_textured_figure("06.2_planet.png", Figures("06_texture", "06.2")("06.2_planet.png"),
                         {.mesh = make_shape("uv_sphere:64"),
                          .camera = {.view = look_at(eye, {0, 0, 0}, {0, 1, 0}),
                                     .projection = perspective(40, 1, 0.1, 20)},
                          .cull = Cull::back},
                         source_folder() / "data/planet_color.png", "trilinear",
                         Lighting{.light = {-1, 1, 1, 0},
                                  .ambient = 0.1,
                                  .diffuse = 1,
                                  .specular = 0.3,
                                  .shininess = 20,
                                  .eye = eye.homogeneous()});
}

/// Where on a face a rung of the perspective ladder has window point (x, y), and between which
/// pixels of the row it mixes.
struct PlaceOnWall {
  Hit hit;
  std::vector<long> key = {};
};
using PlaceByRung = std::function<PlaceOnWall(const RayCaster&, double x, double y, const Hit&)>;

PlaceOnWall exactly(const RayCaster&, double, double, const Hit& hit) {
  return {hit};
}

PlaceOnWall affinely(const RayCaster& witness, double x, double y, const Hit& hit) {
  return {witness.affine_plane(x, y, hit.face)};
}

/// Exact at every `length`th of the pixels that the face covers in the row, and at the last of
/// them.
PlaceByRung in_runs_of(int length) {
  return [length](const RayCaster& witness, double x, double y, const Hit& hit) -> PlaceOnWall {
    const auto pixel = static_cast<int>(std::floor(x));
    const double beside = x - pixel;
    const auto covered = [&](int column) {
      return column >= 0 && column < witness.width() &&
             witness.covers(column + beside, y, hit.face);
    };
    int first = pixel;
    while (covered(first - 1)) --first;
    int last = pixel;
    while (covered(last + 1)) ++last;
    const int begin = pixel - (pixel - first) % length;
    const int end = std::min(begin + length, last);
    PlaceOnWall place{hit, {begin, end}};
    if (end <= begin) return place;
    const double part = static_cast<double>(pixel - begin) / (end - begin);
    place.hit.weights = (1 - part) * witness.drawn_plane(begin + beside, y, hit.face).weights +
                        part * witness.drawn_plane(end + beside, y, hit.face).weights;
    return place;
  };
}

TEST(stage06_figures, the_wall_by_every_rung) {
  const Figures figures("06_texture", "06.3", {"--size", "200x150"});
  const Mesh wall = read_mesh(source_folder() / "data/wall.off");
  const Surface surface(wall);
  const DeepTexture texture(read_image<Rgb8>(source_folder() / "data/brick.png"));
  const RayCaster witness(wall,
                          {.view = look_at({-4.6, 0.3, 2.6}, {-1.6, 0, 0}, {0, 1, 0}),
                           .projection = perspective(45, 4.0 / 3, 0.1, 20)},
                          200, 150);
  const auto compare = [&](const Image<Rgb8>& figure, const PlaceByRung& place_by) {
    return compare_colors(witness, figure, [&](double x, double y, const Hit& hit) {
      const PlaceOnWall place = place_by(witness, x, y, hit);
      Shade shade =
          sample(texture, "bilinear", "repeat", at_point(surface.texture_coordinates(place.hit)));
      shade.key = place.key;
      return shade;
    });
  };
  for (const auto& [rung, place_by] :
       std::vector<std::pair<std::string, PlaceByRung>>{{"affine", affinely},
                                                        {"runs_of_16", in_runs_of(16)},
                                                        {"runs_of_8", in_runs_of(8)},
                                                        {"exact", exactly}}) {
    const Image<Rgb8> figure = figures("06.3_" + rung + ".png");
    const Agreement agreement = compare(figure, place_by);
    std::cout << rung << ": " << agreement;
    EXPECT_EQ(agreement.wrong, 0) << rung << ": " << agreement;
    EXPECT_GT(agreement.drawn, 10000) << rung;
    EXPECT_EQ(compare(figure, exactly).wrong > 100, rung != "exact") << rung;
  }
}

TEST(stage06_figures, the_floor_to_the_horizon) {
  const Figures figures("06_texture", "06.4");
  Mesh floor = make_shape("grid:1");
  for (Eigen::Vector2f& uv : floor.texture_coordinates) uv *= 200;
  for (Eigen::Vector3f& position : floor.positions) position *= 200;
  for (const std::string filter :
       {"nearest", "bilinear", "mip-mapped", "trilinear", "anisotropic"}) {
    const std::string file = "06.4_" + filter + ".png";
    expect_textured_figure(file, figures(file),
                           {.mesh = floor,
                            .camera = {.view = look_at({0, 1, 0}, {0.3, 0.8, -1}, {0, 1, 0}),
                                       .projection = perspective(50, 1.5, 0.1, 1000)}},
                           source_folder() / "data/checker.png", filter, std::nullopt);
  }
}

}  // namespace
}  // namespace rasterlab::oracle
