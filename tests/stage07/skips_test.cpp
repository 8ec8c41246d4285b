// What stage 07 leaves out because no shader reads it: textures, their levels, normals of vertices,
// derivatives. Each changes no byte of a picture, has a switch and is counted.
#include "common/image/bytes.h"
#include "common/shaders/culled.h"
#include "common/shaders/lattice.h"
#include "common/shaders/shaders.h"

#include "tests/stage07/scene.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/scratch.h"

#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace rasterlab {
namespace skips_test {  // not unnamed: templates of the library have these as members

/// What somebody wrote who says nothing of what it doesn't read.
struct EdgesInBlack {
  using Reads = Attributes<WorldPosition>;

  explicit EdgesInBlack(const ShaderInputs& /*inputs*/) {}

  template <class Point>
  auto color_at(const Point& point) const {
    return point.dx.position;
  }
};
struct UnknownAttribute {};

}  // namespace skips_test

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// --- What shaders say ---

template <class Shader>
class stage07_unread : public testing::Test {
 protected:
  static SurfacePoint<Shader::template Varyings, float> random_point(std::mt19937& random) {
    auto point = zero_point<Shader::template Varyings>();
    std::uniform_real_distribution<float> value(0.1F, 0.9F);
    for (int i = 0; i < number_count<Shader::template Varyings>(); ++i) {
      numbers(point.value)[i] = value(random);
    }
    return point;
  }

  static Fragment<float> shade(const Shader& shader,
                               SurfacePoint<Shader::template Varyings, float> point,
                               float derivatives) {
    for (auto* varyings : {&point.dx, &point.dy}) {
      std::fill_n(numbers(*varyings), number_count<Shader::template Varyings>(), derivatives);
    }
    return to_fragment(shader.fragment(point));
  }
};

using Shaders =
    testing::Types<Plain<ConstantColor>, Plain<TextureColor>, Flat<VertexColor>, Flat<TextureColor>,
                   GouraudSurface<VertexColor>, GouraudSurface<TextureColor>,
                   QuantizedGouraud<ConstantColor>, BumpedInObjectSpace<ConstantColor>,
                   Bumped<VertexColor>, PhongSurface<VertexColor>, PhongSurface<TextureColor>,
                   BlinnPhongSurface<ConstantColor>, BumpedPhong<ConstantColor>,
                   GouraudHighlight<VertexColor>, BumpedShinyPhong<TextureColor>,
                   Surface<ConstantColor, FaceNormal, SpecularMapped<Phong>>, Lattice,
                   Culled<PhongSurface<ConstantColor>>, Culled<Flat<TextureColor>>>;
TYPED_TEST_SUITE(stage07_unread, Shaders);

template <class Shader>
struct Make {
  static Shader from(const ShaderInputs& inputs) { return Shader(inputs); }
};
template <class Shader>
struct Make<Culled<Shader>> {
  static Culled<Shader> from(const ShaderInputs& inputs) { return {Shader(inputs), Cull::none}; }
};

TYPED_TEST(stage07_unread, derivatives_matter_to_those_that_read_them) {
  const TestScene scene("uv_sphere:4");
  const TypeParam shader = Make<TypeParam>::from(scene.inputs());
  std::mt19937 random(3);
  int different = 0;
  for (int i = 0; i < 100; ++i) {
    const auto point = this->random_point(random);
    const Fragment<float> one = this->shade(shader, point, 0);
    const Fragment<float> other = this->shade(shader, point, 0.25F);
    different += one.color != other.color || one.discarded != other.discarded ? 1 : 0;
  }
  EXPECT_EQ(different > 0, reads_derivatives<TypeParam>());
}

TYPED_TEST(stage07_unread, those_that_read_normals_of_vertices_need_them) {
  const TestScene scene("uv_sphere:4");
  Mesh bare = scene.mesh;
  bare.normals.clear();
  const ShaderInputs all = scene.inputs();
  const ShaderInputs inputs = {.mesh = bare,
                               .transforms = all.transforms,
                               .light = all.light,
                               .texture = all.texture,
                               .normal_map = all.normal_map,
                               .object_normal_map = all.object_normal_map,
                               .specular_map = all.specular_map};
  if (reads_vertex_normals<TypeParam>()) {
    EXPECT_THROW(Make<TypeParam>::from(inputs), InputError);
    return;
  }
  const auto with = Make<TypeParam>::from(all).vertex(scene.mesh, 5, 1);
  const auto without = Make<TypeParam>::from(inputs).vertex(bare, 5, 1);
  for (int i = 0; i < number_count<TypeParam::template Varyings>(); ++i) {
    EXPECT_EQ(numbers(without)[i], numbers(with)[i]) << "number " << i;
  }
}

TEST(stage07_unread_parts, what_says_nothing_may_read_everything) {
  EXPECT_TRUE((reads_derivatives<Surface<skips_test::EdgesInBlack, FaceNormal, Diffuse>>()));
  EXPECT_FALSE((reads_vertex_normals<Surface<skips_test::EdgesInBlack, FaceNormal, Diffuse>>()));
  EXPECT_TRUE((reads_vertex_normals<Attributes<WorldPosition, skips_test::UnknownAttribute>>()));
}

/// Which of a scene's textures a shader asks for when it is made.
template <class Shader>
std::vector<std::string> asked_for_by() {
  const TestScene scene("uv_sphere:4");
  ShaderInputs inputs = scene.inputs();
  std::vector<std::string> asked;
  const auto input = [&](const char* name) {
    return SamplerInput([&, name] {
      asked.emplace_back(name);
      return Sampler{&scene.texture};
    });
  };
  inputs.texture = input("texture");
  inputs.normal_map = input("normal map");
  inputs.object_normal_map = input("object normal map");
  inputs.specular_map = input("specular map");
  EXPECT_THAT(asked, IsEmpty());
  const Shader shader(inputs);
  return asked;
}

TEST(stage07_textures, a_shader_asks_for_the_textures_it_reads) {
  EXPECT_THAT(asked_for_by<PhongSurface<ConstantColor>>(), IsEmpty());
  EXPECT_THAT(asked_for_by<Lattice>(), IsEmpty());
  EXPECT_THAT(asked_for_by<Flat<TextureColor>>(), ElementsAre("texture"));
  EXPECT_THAT(asked_for_by<BumpedInObjectSpace<ConstantColor>>(), ElementsAre("object normal map"));
  EXPECT_THAT(asked_for_by<BumpedShinyPhong<TextureColor>>(),
              ElementsAre("texture", "normal map", "specular map"));
}

// --- The executable ---

constexpr int color_levels = 8;      // of data/brick.png, 128 × 128
constexpr int normal_levels = 10;    // of data/planet_normal_tangent.png, 512 × 256
constexpr int specular_levels = 10;  // of data/planet_specular.png, the same
constexpr int vertices = 4;          // of data/wall.off, which has no normals

struct Drawn {
  std::string picture;
  nlohmann::json counts;
};

/// Draws with every texture there is.
class stage07_skips : public testing::Test {
 protected:
  Drawn draw(const std::string& shader, const std::vector<std::string>& more = {},
             const std::string& mesh = (source_folder() / "data/wall.off").string()) const {
    const std::filesystem::path data = source_folder() / "data";
    std::vector<std::string> command = {program("07_shaders"),
                                        "--mesh",
                                        mesh,
                                        "--shader",
                                        shader,
                                        "--texture",
                                        data / "brick.png",
                                        "--normal-map",
                                        data / "planet_normal_tangent.png",
                                        "--specular-map",
                                        data / "planet_specular.png",
                                        "--size",
                                        "120x90",
                                        "--stats",
                                        "--out",
                                        "a.png"};
    command.insert(command.end(), more.begin(), more.end());
    const ProcessResult result = run_process(command, {.folder = folder_.path()});
    EXPECT_EQ(result.exit_status, 0) << result.err;
    const nlohmann::json statistics = nlohmann::json::parse(result.out, nullptr, false);
    EXPECT_TRUE(statistics.is_object()) << result.out;
    return {read_file(folder_ / "a.png"), statistics.at("counts")};
  }

  static std::vector<int> skipped(const Drawn& drawn) {
    return {drawn.counts.at("textures_skipped"), drawn.counts.at("levels_skipped"),
            drawn.counts.at("normals_skipped")};
  }

  ScratchFolder folder_;
};

TEST_F(stage07_skips, count_what_is_not_made) {
  EXPECT_THAT(skipped(draw("flat")), ElementsAre(3, 0, vertices));
  EXPECT_THAT(skipped(draw("phong")), ElementsAre(3, 0, 0));
  EXPECT_THAT(skipped(draw("flat_texture")), ElementsAre(2, 0, vertices));
  EXPECT_THAT(skipped(draw("flat_texture", {"--filter", "bilinear"})),
              ElementsAre(2, color_levels - 1, vertices));
  EXPECT_THAT(skipped(draw("normal_object", {"--filter", "nearest"})),
              ElementsAre(2, normal_levels - 1, vertices));
  EXPECT_THAT(skipped(draw("phong_all_maps", {"--filter", "nearest"})),
              ElementsAre(0, color_levels - 1 + normal_levels - 1 + specular_levels - 1, 0));
  EXPECT_THAT(skipped(draw("flat", {"--engine", "exercise"})), ElementsAre(3, 0, vertices));
  EXPECT_THAT(skipped(draw("flat", {}, "builtin:cube")), ElementsAre(3, 0, 0))
      << "normals that are there aren't skipped";
}

TEST_F(stage07_skips, count_nothing_when_switched_off) {
  const auto counts = [this](const std::string& names) {
    return skipped(draw("flat_texture", {"--filter", "nearest", "--without", names}));
  };
  EXPECT_THAT(counts("unread normals"), ElementsAre(2, color_levels - 1, 0));
  EXPECT_THAT(counts("unread levels"), ElementsAre(2, 0, vertices));
  EXPECT_THAT(counts("unread textures"),
              ElementsAre(0, color_levels - 1 + normal_levels - 1 + specular_levels - 1, vertices));
  EXPECT_THAT(counts("unread textures,unread normals,unread levels"), ElementsAre(0, 0, 0));
}

TEST_F(stage07_skips, derivatives_are_spared_where_no_part_reads_them) {
  const auto unread = [this](const std::string& shader, const std::vector<std::string>& more = {}) {
    return draw(shader, more).counts.at("derivatives_unread").get<int>();
  };
  EXPECT_GT(unread("phong"), 0);
  EXPECT_EQ(unread("phong", {"--without", "unread attributes"}), 0);
  EXPECT_EQ(unread("phong_texture"), 0);
}

TEST_F(stage07_skips, change_no_byte) {
  std::vector<std::string> names;
  std::istringstream lines(run_process({program("07_shaders"), "--without", "list"}).out);
  for (std::string line; std::getline(lines, line);) names.push_back(line);
  EXPECT_EQ(names.size(), 17U);
  EXPECT_THAT(names, testing::IsSupersetOf({"unread textures", "unread levels", "unread normals",
                                            "hidden clusters"}));
  for (const std::string shader : {"flat", "phong", "normal_object", "phong_all_maps"}) {
    for (const std::string filter : {"bilinear", "trilinear"}) {
      const Drawn expected = draw(shader, {"--filter", filter});
      for (const std::string& name : names) {
        const Drawn drawn = draw(shader, {"--filter", filter, "--without", name});
        EXPECT_TRUE(drawn.picture == expected.picture)
            << shader << ", " << filter << ", without " << name;
      }
    }
  }
}

}  // namespace
}  // namespace rasterlab
