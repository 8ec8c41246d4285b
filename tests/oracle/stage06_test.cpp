// The pictures of stage 06 against the ray caster: textures and light in double precision.
#include "common/image/files.h"
#include "common/mesh/read_mesh.h"

#include "tests/oracle/geometry_cases.h"
#include "tests/oracle/shading.h"
#include "tests/oracle/soft_picture.h"
#include "tests/oracle/texturing.h"
#include "tests/support/places.h"
#include "tests/support/scratch.h"

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
  const Agreement agreement =
      compare_colors(witness, picture.color, [&](double x, double y, const Hit& hit) {
        const Shade read =
            sample(texture, filter, wrap, steps_at(witness, surface, x, y, hit.face));
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

}  // namespace
}  // namespace rasterlab::oracle
