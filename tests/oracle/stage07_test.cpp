// The pictures of stage 07 against the ray caster: every shader, in double precision.
#include "common/image/files.h"
#include "common/mesh/read_mesh.h"
#include "common/mesh/shapes.h"
#include "common/shaders/culled.h"
#include "common/shaders/draw_shaded.h"
#include "common/shaders/shaders.h"

#include "tests/oracle/geometry_cases.h"
#include "tests/oracle/shader_looks.h"
#include "tests/oracle/soft_picture.h"
#include "tests/support/places.h"
#include "tests/support/scratch.h"

#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace rasterlab::oracle {
namespace {

namespace fs = std::filesystem;

class stage07_witness_of : public testing::TestWithParam<GeometryCase> {};

INSTANTIATE_TEST_SUITE_P(, stage07_witness_of, testing::ValuesIn(built_in_cases()),
                         case_name<testing::TestParamInfo<GeometryCase>>);

TEST_P(stage07_witness_of, sees_the_same) {
  for (const char* engine : {"exercise", "tiled"}) {
    EXPECT_GT(expect_geometry("07_shaders", GetParam(), {"--engine", engine}).drawn, 0)
        << "nothing to compare";
  }
}

/// The picture's channels brought into a range where 2c − 1 is a normal that leans, no more.
Image<Rgb8> soft_normals() {
  Image<Rgb8> image = soft_picture();
  for (Rgb8& pixel : image.pixels()) {
    pixel.r = static_cast<std::uint8_t>(64 + pixel.r / 2);
    pixel.g = static_cast<std::uint8_t>(64 + pixel.g / 2);
    pixel.b = static_cast<std::uint8_t>(192 + pixel.b / 4);
  }
  return image;
}

/// The textures as files, for the stage, and as the witness reads them.
struct MapFiles {
  fs::path color;
  fs::path normal;
  fs::path specular;

  std::vector<std::string> flags() const {
    return {"--texture",     color.string(),   "--normal-map",
            normal.string(), "--specular-map", specular.string()};
  }
  Maps maps() const {
    const auto read = [](const fs::path& file) { return DeepTexture(read_image<Rgb8>(file)); };
    return {read(color), read(normal), read(specular)};
  }
};

MapFiles write_soft_maps(const fs::path& folder) {
  write_image(folder / "soft.png", soft_picture());
  write_image(folder / "normals.png", soft_normals());
  return {folder / "soft.png", folder / "normals.png", folder / "soft.png"};
}

/// One mesh from one side with its maps, to compare by many shaders.
class ShaderCase {
 public:
  ShaderCase(const GeometryCase& geometry, const Lighting& lighting, const MapFiles& files)
      : geometry_(geometry),
        mesh_(read_mesh(geometry.mesh)),
        witness_(mesh_, geometry.viewpoint.camera(geometry.width, geometry.height), geometry.width,
                 geometry.height, geometry.cull),
        surface_(mesh_),
        maps_(files.maps()),
        lighting_(lighting),
        files_(files) {
    lighting_.eye = eye_of(geometry.viewpoint);
  }

  const Mesh& mesh() const { return mesh_; }

  Image<Rgb8> take(const std::string& shader, const std::string& engine) const {
    std::vector<std::string> flags = geometry_.viewpoint.flags();
    for (const auto& more :
         {lighting_.flags(), files_.flags(),
          std::vector<std::string>{"--cull", cull_name(geometry_.cull), "--shader", shader,
                                   "--filter", filter_of(shader), "--engine", engine}}) {
      flags.insert(flags.end(), more.begin(), more.end());
    }
    return take_picture("07_shaders", geometry_.mesh, geometry_.width, geometry_.height, flags)
        .color;
  }

  Agreement compare(const ShaderLook& look, const Image<Rgb8>& picture) const {
    return compare_colors(witness_, picture, [&](double x, double y, const Hit& hit) {
      return shade_look(look, scene(filter_of(look.name)), x, y, hit);
    });
  }

  Agreement compare_lattice(const Image<Rgb8>& picture) const {
    return compare_colors(witness_, picture, [&](double x, double y, const Hit&) {
      return see_through_lattice(scene("trilinear"), x, y);
    });
  }

 private:
  /// Smaller levels of a texture are rounded to 8 bits. A colour is off by half a code for that,
  /// but light on a normal by more than one: normal maps are compared at their finest level.
  static std::string filter_of(const std::string& shader) {
    const bool has_normals = std::any_of(
        shader_looks().begin(), shader_looks().end(),
        [&](const ShaderLook& look) { return look.name == shader && look.normal_mapped(); });
    return has_normals ? "bilinear" : "trilinear";
  }

  ShadedScene scene(const std::string& filter) const {
    return {witness_, surface_, lighting_, maps_, filter};
  }

  GeometryCase geometry_;
  Mesh mesh_;
  RayCaster witness_;
  Surface surface_;
  Maps maps_;
  Lighting lighting_;
  MapFiles files_;
};

void expect_agreement(const std::string& what, const Agreement& agreement) {
  std::cout << what << ": " << agreement;
  EXPECT_EQ(agreement.wrong, 0) << what << ": " << agreement;
}

const ShaderLook& look_named(const std::string& name) {
  const auto& looks = shader_looks();
  return *std::find_if(looks.begin(), looks.end(),
                       [&](const ShaderLook& look) { return look.name == name; });
}

const Lighting near_light{.light = {2, 1.5, 2.5, 1}, .ambient = 0.1, .shininess = 10};

TEST_P(stage07_witness_of, every_shader_shows_the_same) {
  const ScratchFolder scratch;
  const ShaderCase shaders(GetParam(), near_light, write_soft_maps(scratch.path()));
  for (const char* engine : {"exercise", "tiled"}) {
    for (const ShaderLook& look : shader_looks()) {
      expect_agreement(look.name + ", " + engine,
                       shaders.compare(look, shaders.take(look.name, engine)));
    }
  }
}

TEST_P(stage07_witness_of, one_sees_the_same_through_the_lattice) {
  const ScratchFolder scratch;
  const ShaderCase shaders(GetParam(), near_light, write_soft_maps(scratch.path()));
  for (const char* engine : {"exercise", "tiled"}) {
    expect_agreement(engine, shaders.compare_lattice(shaders.take("lattice", engine)));
  }
}

TEST(stage07_witness, is_not_easily_satisfied) {
  const ScratchFolder scratch;
  const GeometryCase geometry{.name = "knot", .mesh = "builtin:torus_knot"};
  const ShaderCase shaders(geometry, near_light, write_soft_maps(scratch.path()));
  for (const auto& [drawn, expected] : std::vector<std::pair<std::string, std::string>>{
           {"phong", "blinn_phong"},
           {"gouraud", "normal"},
           {"gouraud", "quantized"},
           {"normal", "normal_object"},
           {"phong_normal_texture", "phong_all_maps"}}) {
    const Agreement agreement =
        shaders.compare(look_named(expected), shaders.take(drawn, "exercise"));
    EXPECT_GT(agreement.wrong, 100) << drawn << " passes for " << expected;
  }
  EXPECT_GT(shaders.compare_lattice(shaders.take("phong", "exercise")).wrong, 100);
}

/// A mesh that maps the texture twice, the second time mirrored.
fs::path mirrored_book(const fs::path& folder) {
  write_file(folder / "book.obj",
             "v -1 -1 0.4\nv 0 -1 0\nv 1 -1 0.4\nv -1 1 0.4\nv 0 1 0\nv 1 1 0.4\n"
             "vt 1 0\nvt 0 0\nvt 1 1\nvt 0 1\n"
             "f 1/1 2/2 5/4 4/3\nf 2/2 3/1 6/3 5/4\n");
  return folder / "book.obj";
}

TEST(stage07_witness, mirrored_texture_coordinates_bend_the_same_way) {
  const ScratchFolder scratch;
  const GeometryCase geometry{
      .name = "book", .mesh = mirrored_book(scratch.path()), .width = 160, .height = 120};
  const ShaderCase shaders(geometry, near_light, write_soft_maps(scratch.path()));
  for (const char* shader : {"normal", "phong_normal", "phong_all_maps"}) {
    const Agreement agreement =
        shaders.compare(look_named(shader), shaders.take(shader, "exercise"));
    expect_agreement(shader, agreement);
    EXPECT_GT(agreement.drawn, 4000);
  }
}

TEST(stage07_witness, a_culled_shader_shows_the_same) {
  for (const Cull cull : {Cull::back, Cull::front}) {
    const GeometryCase geometry{.name = "torus", .mesh = "builtin:torus:12", .cull = cull};
    const Camera camera = geometry.viewpoint.camera(geometry.width, geometry.height);
    const Mesh mesh = read_mesh(geometry.mesh);
    const ShaderInputs inputs = {.mesh = mesh,
                                 .transforms = {.view = camera.view.cast<float>(),
                                                .projection = camera.projection.cast<float>()},
                                 .light = {.position = {1, 2, 3, 0}}};
    Frame frame = make_frame(geometry.width, geometry.height);
    const Culled<PhongSurface<ConstantColor>> shader{PhongSurface<ConstantColor>(inputs), cull};
    draw_shaded(mesh, inputs.transforms, Cull::none, shader, frame);
    const RayCaster witness(mesh, camera, geometry.width, geometry.height, cull);
    const Surface surface(mesh);
    const Lighting lighting{.eye = eye_of(geometry.viewpoint)};
    expect_agreement(cull_name(cull),
                     compare_colors(witness, frame.color, [&](double, double, const Hit& hit) {
                       return shade_phong(surface, lighting, hit);
                     }));
  }
}

TEST(stage07_witness, models_no_one_here_wrote_show_the_same) {
  const ScratchFolder scratch;
  const MapFiles maps = write_soft_maps(scratch.path());
  for (const GeometryCase& geometry : foreign_cases()) {
    SCOPED_TRACE(geometry.mesh);
    const ShaderCase shaders(geometry, near_light, maps);
    std::vector<std::string> names{"flat", "phong"};
    if (!shaders.mesh().texture_coordinates.empty()) names.push_back("phong_normal_texture");
    for (const std::string& name : names) {
      expect_agreement(geometry.mesh + ", " + name,
                       shaders.compare(look_named(name), shaders.take(name, "exercise")));
    }
  }
}

/// The textured models beside the repository, which are no part of it.
TEST(stage07_witness, real_textured_models_show_the_same) {
  const fs::path folder = source_folder().parent_path() / "shared/data";
  if (!fs::exists(folder / "spot")) {
    GTEST_SKIP() << "NOT COMPARED: the textured models are not in " << folder;
  }
  const fs::path squirrel = folder / "frankie/flyingsquirrel_skin_col.png";
  const fs::path fur = folder / "frankie/flyingsquirrel_skin_nor.png";
  const fs::path cow = folder / "spot/spot_texture.png";
  const std::vector<std::tuple<std::string, MapFiles, std::vector<std::string>>> models{
      {"spot/spot_triangulated.obj", {cow, cow, cow}, {"flat_texture", "phong_texture"}},
      {"frankie/Frankie.obj",
       {squirrel, fur, squirrel},
       {"gouraud_texture", "phong_texture", "phong_normal_texture"}}};
  for (const auto& [file, maps, names] : models) {
    GeometryCase geometry = framed("model", folder / file, read_mesh(folder / file));
    geometry.width = 240;
    geometry.height = 180;
    const ShaderCase shaders(geometry, near_light, maps);
    for (const std::string& name : names) {
      const Agreement agreement = shaders.compare(look_named(name), shaders.take(name, "exercise"));
      expect_agreement(file + ", " + name, agreement);
      EXPECT_GT(agreement.drawn, 1000);
    }
  }
}

// --- The exercises' own figures ---

/// The planet of stage 07's figures, or what is left of it; its maps, whatever is painted on it.
class PlanetFigure {
 public:
  PlanetFigure(Mesh mesh, const Eigen::Vector3d& eye, const Lighting& lighting, int side,
               Cull cull = Cull::none)
      : mesh_(std::move(mesh)),
        witness_(
            mesh_,
            {.view = look_at(eye, {0, 0, 0}, {0, 1, 0}), .projection = perspective(40, 1, 0.1, 20)},
            side, side, cull),
        surface_(mesh_),
        lighting_(lighting) {
    lighting_.eye = eye.homogeneous();
  }

  void expect(const std::string& file, const Image<Rgb8>& figure, const std::string& look) const {
    const ShadedScene scene{witness_, surface_, lighting_, maps(look), "trilinear"};
    const Agreement agreement =
        compare_colors(witness_, figure, [&](double x, double y, const Hit& hit) {
          if (look == "lattice") return see_through_lattice(scene, x, y);
          if (look == "golden lattice") return see_through_lattice(scene, x, y, {0.9, 0.8, 0.6});
          if (look == "phong at the corners") return phong_at_corners(hit);
          return shade_look(look_named(look), scene, x, y, hit);
        });
    expect_agreement(file, agreement);
    EXPECT_GT(agreement.drawn, 1000) << file;
  }

  static Mesh colored(int subdivision) {
    Mesh mesh = make_shape("uv_sphere", subdivision);
    for (const Eigen::Vector3f& position : mesh.positions) {
      mesh.colors.push_back((position + Eigen::Vector3f::Ones()) / 2);
    }
    return mesh;
  }

  static Mesh in_one_color(const std::string& shape, const Eigen::Vector3f& color) {
    Mesh mesh = make_shape(shape);
    mesh.colors.assign(mesh.positions.size(), color);
    return mesh;
  }

 private:
  /// What light adds is mixed between the corners, not the colours it gives: so nothing clamps
  /// before.
  Shade phong_at_corners(const Hit& hit) const {
    Lighting dull = lighting_;
    dull.specular = 0;
    Shade sum{.color = Eigen::Vector3d::Zero()};
    for (int i = 0; i < 3; ++i) {
      const Hit corner = Surface::corner(hit, i);
      const auto light = [&](const Lighting& lighting, const Eigen::Vector3d& color) {
        return light_point(lighting, surface_.position(corner), surface_.normal(corner), color)
            .color;
      };
      sum.color += hit.weights[i] * (light(dull, surface_.color(corner)) +
                                     light(lighting_, Eigen::Vector3d::Zero()));
    }
    return sum;
  }

  static const Maps& maps(const std::string& look) {
    const auto read = [](const char* file) {
      return DeepTexture(read_image<Rgb8>(source_folder() / "data" / file));
    };
    static const Maps tangent{read("planet_color.png"), read("planet_normal_tangent.png"),
                              read("planet_specular.png")};
    static const Maps object{tangent.color, read("planet_normal_object.png"), tangent.specular};
    return look == "normal_object" ? object : tangent;
  }

  Mesh mesh_;
  RayCaster witness_;
  Surface surface_;
  Lighting lighting_;
};

const Lighting from_the_left{
    .light = {-1, 0.7, 1, 0}, .ambient = 0.1, .diffuse = 1, .specular = 0.5, .shininess = 30};

/// One of the pictures of a sheet of two by two.
Image<Rgb8> quarter(const Image<Rgb8>& sheet, int side, int column, int row) {
  Image<Rgb8> cell(side, side);
  const int step = sheet.width() - side;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) cell(x, y) = sheet(column * step + x, row * step + y);
  }
  return cell;
}

TEST(stage07_figures, flat_and_gouraud_with_and_without_a_texture) {
  const Image<Rgb8> sheet = Figures("07_shaders", "07.2")("07.2_four_shaders.png");
  const PlanetFigure figure(PlanetFigure::in_one_color("uv_sphere:12", {1, 1, 1}), {0, 1, 3},
                            from_the_left, 240);
  figure.expect("flat", quarter(sheet, 240, 0, 0), "flat");
  figure.expect("flat textured", quarter(sheet, 240, 1, 0), "flat_texture");
  figure.expect("Gouraud", quarter(sheet, 240, 0, 1), "gouraud");
  figure.expect("Gouraud textured", quarter(sheet, 240, 1, 1), "gouraud_texture");
}

TEST(stage07_figures, five_levels) {
  const Figures figures("07_shaders", "07.3");
  const PlanetFigure figure(PlanetFigure::in_one_color("torus_knot:24", {1, 0.6F, 0}),
                            {0, 1.2, 2.8}, from_the_left, 360);
  figure.expect("07.3_gouraud.png", figures("07.3_gouraud.png"), "gouraud");
  figure.expect("07.3_quantized.png", figures("07.3_quantized.png"), "quantized");
}

TEST(stage07_figures, a_ball_with_holes) {
  PlanetFigure(PlanetFigure::colored(48), {0, 1, 3}, from_the_left, 360)
      .expect("07.1_lattice.png", Figures("07_shaders", "07.1")("07.1_lattice.png"),
              "golden lattice");
}

TEST(stage07_figures, normals_from_maps) {
  const Figures figures("07_shaders", "07.4");
  const PlanetFigure figure(PlanetFigure::in_one_color("uv_sphere:32", {0.9F, 0.9F, 0.9F}),
                            {0, 1, 3}, from_the_left, 360);
  for (const auto& [name, look] : {std::pair{"without", "gouraud"},
                                   {"tangent_space", "normal"},
                                   {"planet", "normal_texture"},
                                   {"object_space", "normal_object"}}) {
    const std::string file = std::string("07.4_") + name + ".png";
    figure.expect(file, figures(file), look);
  }
}

TEST(stage07_figures, a_bowl_culled) {
  const Figures figures("07_shaders", "07.5");
  Mesh bowl = PlanetFigure::colored(24);
  std::erase_if(bowl.triangles, [&](const Mesh::Triangle& triangle) {
    return bowl.positions[triangle[0]].y() > 0.4F;
  });
  Lighting lighting = from_the_left;
  lighting.ambient = lighting.diffuse = lighting.specular = 0.6;
  lighting.shininess = 128;
  for (const auto& [file, cull] : {std::pair{"07.5_none.png", Cull::none},
                                   {"07.5_back.png", Cull::back},
                                   {"07.5_front.png", Cull::front}}) {
    PlanetFigure(bowl, {0, 1.4, 2.8}, lighting, 240, cull).expect(file, figures(file), "phong");
  }
}

TEST(stage07_figures, phong_with_the_courses_parameters) {
  const Image<Rgb8> sheet = Figures("07_shaders", "07.6")("07.6_four_shaders.png");
  const Mesh planet = PlanetFigure::in_one_color("uv_sphere:32", {1, 128 / 255.0F, 1});
  Lighting lighting{.light = {0, 0, 1, 0}, .ambient = 0.1, .diffuse = 1, .specular = 0.5};
  lighting.shininess = 10;
  const PlanetFigure plain(planet, {0, 1, 3}, lighting, 240);
  plain.expect("Phong", quarter(sheet, 240, 0, 0), "phong");
  plain.expect("Phong normal", quarter(sheet, 240, 1, 0), "phong_normal");
  lighting.specular = 1;
  const PlanetFigure textured(planet, {0, 1, 3}, lighting, 240);
  textured.expect("Phong texture", quarter(sheet, 240, 0, 1), "phong_texture");
  textured.expect("Phong normal texture", quarter(sheet, 240, 1, 1), "phong_normal_texture");
}

TEST(stage07_figures, every_shader_alone) {
  const Figures figures("07_shaders", "07.7");
  const PlanetFigure figure(PlanetFigure::colored(24), {0, 1, 3}, from_the_left, 240);
  for (const ShaderLook& look : shader_looks()) {
    const std::string file = "07.7_" + look.name + ".png";
    figure.expect(file, figures(file), look.name);
  }
  figure.expect("07.7_lattice.png", figures("07.7_lattice.png"), "lattice");
}

/// One of the pictures of a sheet of six columns, 1 pixel apart.
Image<Rgb8> cell_of(const Image<Rgb8>& sheet, int side, int place) {
  Image<Rgb8> cell(side, side);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      cell(x, y) = sheet(place % 6 * (side + 1) + x, place / 6 * (side + 1) + y);
    }
  }
  return cell;
}

/// "_0018" for frame 18.
std::string frame_number(int frame) {
  return std::string("_00") + (frame < 10 ? "0" : "") + std::to_string(frame);
}

TEST(stage07_figures, the_light_going_round_all_shaders) {
  const Figures figures("07_shaders", "07.7");
  for (const int frame : {3, 14}) {
    const double angle = 2 * std::numbers::pi * frame / 24;
    Lighting lighting = from_the_left;
    const Eigen::AngleAxisd turn(angle, Eigen::Vector3d::UnitY());
    lighting.light.head<3>() = turn * from_the_left.light.head<3>();
    const PlanetFigure figure(PlanetFigure::colored(24), {0, 1, 3}, lighting, 80);
    const Image<Rgb8> sheet = figures("07.7_light" + frame_number(frame) + ".png");
    int place = 0;
    for (const ShaderLook& look : shader_looks()) {
      figure.expect(look.name + frame_number(frame), cell_of(sheet, 80, place++), look.name);
    }
    figure.expect("lattice" + frame_number(frame), cell_of(sheet, 80, place), "lattice");
  }
}

TEST(stage07_figures, phong_at_every_pixel) {
  const Figures figures("07_shaders", "07.8");
  const Lighting lighting{.light = {-1, 0.7, 1, 0}};
  const PlanetFigure knot(PlanetFigure::in_one_color("torus_knot:8", {0.9F, 0.7F, 0.5F}),
                          {0, 1.2, 2.8}, lighting, 360);
  knot.expect("07.8_per_fragment.png", figures("07.8_per_fragment.png"), "phong");
  knot.expect("07.8_per_vertex.png", figures("07.8_per_vertex.png"), "phong at the corners");
  Mesh bunny = read_mesh("/usr/share/glmark2/models/bunny.obj");
  bunny.normals.clear();
  bunny.colors.assign(bunny.positions.size(), {0.9F, 0.7F, 0.5F});
  PlanetFigure(bunny, {0.3, 0.8, 3.4}, lighting, 360)
      .expect("07.8_bunny.png", figures("07.8_bunny.png"), "phong");
}

TEST(stage07_figures, a_planet_with_all_maps_from_all_around) {
  const Figures figures("07_shaders", "07.8");
  const Mesh planet = PlanetFigure::colored(64);
  PlanetFigure(planet, {0, 1, 3}, from_the_left, 360)
      .expect("07.8_planet.png", figures("07.8_planet.png"), "phong_all_maps");
  for (const int frame : {5, 18}) {
    const Eigen::AngleAxisd turn(2 * std::numbers::pi * frame / 24, Eigen::Vector3d::UnitY());
    const std::string file = "07.8_camera" + frame_number(frame) + ".png";
    PlanetFigure(planet, turn * Eigen::Vector3d(0, 1, 3), from_the_left, 160)
        .expect(file, figures(file), "phong_all_maps");
  }
}

}  // namespace
}  // namespace rasterlab::oracle
