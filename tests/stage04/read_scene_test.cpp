#include "common/image/bytes.h"
#include "common/image/check.h"
#include "common/projection/scene.h"

#include "tests/support/scratch.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

using testing::HasSubstr;

// A scene's nine records, each to be replaced.
struct Records {
  std::string mesh = "mesh.off";
  std::string eye = "1 2 3";
  std::string look_at = "0 0.5 -1e-1";
  std::string up = "0 -1 0";
  std::string focal_length = "300";
  std::string size = "320 200";
  std::string ambient = "0.6";
  std::string light = "4 5 6 0.9";
  std::string material = "0.2 0.7 0.5 30";

  std::string text(const std::string& line_end = "\n") const {
    std::string all;
    for (const std::string& record :
         {mesh, eye, look_at, up, focal_length, size, ambient, light, material}) {
      all += record + line_end;
    }
    return all;
  }
};

class stage04_read_scene : public testing::Test {
 protected:
  stage04_read_scene() { write_file(folder_ / "mesh.off", "OFF\n0 0 0\n"); }

  Scene read(const std::string& text) const {
    write_file(folder_ / "a.scene", text);
    return read_scene(folder_ / "a.scene");
  }

  std::string error_of(const std::string& text) const {
    try {
      read(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  ScratchFolder folder_;
};

void expect_as_written(const Scene& scene) {
  EXPECT_EQ(scene.mesh.filename(), "mesh.off");
  EXPECT_EQ(scene.eye, Eigen::Vector3f(1, 2, 3));
  EXPECT_EQ(scene.look_at, Eigen::Vector3f(0, 0.5F, -0.1F));
  EXPECT_EQ(scene.up, Eigen::Vector3f(0, -1, 0));
  EXPECT_EQ(scene.focal_length, 300);
  EXPECT_EQ(scene.width, 320);
  EXPECT_EQ(scene.height, 200);
  EXPECT_EQ(scene.light.ambient_intensity, 0.6F);
  EXPECT_EQ(scene.light.position, Eigen::Vector4f(4, 5, 6, 1));
  EXPECT_EQ(scene.light.intensity, 0.9F);
  EXPECT_EQ(scene.material.ambient, 0.2F);
  EXPECT_EQ(scene.material.diffuse, 0.7F);
  EXPECT_EQ(scene.material.specular, 0.5F);
  EXPECT_EQ(scene.material.shininess, 30);
}

TEST_F(stage04_read_scene, nine_records_a_line_each) {
  expect_as_written(read(Records().text()));
}

TEST_F(stage04_read_scene, lines_may_end_in_cr_lf) {
  expect_as_written(read(Records().text("\r\n")));
}

TEST_F(stage04_read_scene, the_last_line_need_not_end) {
  std::string text = Records().text();
  text.pop_back();
  expect_as_written(read(text));
}

TEST_F(stage04_read_scene, blank_lines_and_comments_are_skipped) {
  std::string text = "# a scene\n\n   \n";
  for (const char letter : Records().text()) {
    text += letter;
    if (letter == '\n') text += "  # a comment, indented\n\t\n";
  }
  expect_as_written(read(text));
}

TEST_F(stage04_read_scene, tabs_and_many_spaces_separate_and_more_fields_are_ignored) {
  Records records;
  records.eye = "\t1 \t 2   3 and more";
  records.size = "320 200 # width, height";
  records.light = "4 5 6 0.9 # without w";
  records.material += " 7 8 9";
  expect_as_written(read(records.text()));
}

TEST_F(stage04_read_scene, numbers_may_have_a_sign_and_an_exponent) {
  Records records;
  records.eye = "+1 2.0e0 .3E+1";
  expect_as_written(read(records.text()));
}

TEST_F(stage04_read_scene, a_light_of_five_numbers_is_homogeneous) {
  Records records;
  records.light = "4 5 6 0 0.8";
  const Scene scene = read(records.text());
  EXPECT_EQ(scene.light.position, Eigen::Vector4f(4, 5, 6, 0));
  EXPECT_EQ(scene.light.intensity, 0.8F);
}

TEST_F(stage04_read_scene, the_mesh_may_be_beside_the_scene_or_built_in) {
  EXPECT_EQ(read(Records().text()).mesh, folder_ / "mesh.off");
  Records records;
  records.mesh = "builtin:cube";
  EXPECT_EQ(read(records.text()).mesh, "builtin:cube");
  records.mesh = (folder_ / "mesh.off").string();
  EXPECT_EQ(read(records.text()).mesh, folder_ / "mesh.off") << "an absolute path";
}

TEST_F(stage04_read_scene, the_working_directory_comes_before_the_scenes_own) {
  std::filesystem::create_directory(folder_ / "elsewhere");
  write_file(folder_ / "elsewhere" / "mesh.off", "OFF\n0 0 0\n");
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder_ / "elsewhere");
  const Scene scene = read(Records().text());
  std::filesystem::current_path(before);
  EXPECT_EQ(scene.mesh, "mesh.off");
}

TEST_F(stage04_read_scene, a_mesh_that_is_not_there_is_named) {
  Records records;
  records.mesh = "missing.off";
  EXPECT_THAT(error_of(records.text()), HasSubstr("a.scene:1: expected the file of a mesh"));
  EXPECT_THAT(error_of(records.text()), HasSubstr("missing.off"));
}

TEST_F(stage04_read_scene, errors_name_the_line_and_what_was_expected) {
  struct Case {
    std::string Records::*record;
    std::string text;
    std::string line;
    std::string expected;
  };
  const std::vector<Case> cases = {
      {&Records::eye, "1 2", ":2:", "three numbers"},
      {&Records::eye, "1 2 three", ":2:", "three numbers"},
      {&Records::eye, "1 2 nan", ":2:", "three numbers"},
      {&Records::look_at, "0 0 inf", ":3:", "three numbers"},
      {&Records::up, "x", ":4:", "three numbers"},
      {&Records::focal_length, "0", ":5:", "focal length"},
      {&Records::focal_length, "-300", ":5:", "above 0"},
      {&Records::size, "320", ":6:", "width and height"},
      {&Records::size, "320 0", ":6:", "whole numbers"},
      {&Records::size, "320.5 200", ":6:", "whole numbers"},
      {&Records::size, "99999 200", ":6:", "32767"},
      {&Records::ambient, "bright", ":7:", "ambient"},
      {&Records::light, "1 2 3", ":8:", "four or five numbers"},
      {&Records::material, "1 2 3", ":9:", "Ka Kd Ks"},
      {&Records::material, "1 2 3 -4", ":9:", "not below 0"},
  };
  for (const Case& wrong : cases) {
    Records records;
    records.*wrong.record = wrong.text;
    const std::string message = error_of(records.text());
    EXPECT_THAT(message, HasSubstr("a.scene" + wrong.line)) << wrong.text;
    EXPECT_THAT(message, HasSubstr(wrong.expected)) << wrong.text;
    EXPECT_THAT(message, HasSubstr("found: " + wrong.text));
  }
}

TEST_F(stage04_read_scene, a_file_that_ends_too_early_says_what_is_missing) {
  EXPECT_THAT(error_of(""), HasSubstr("mesh"));
  EXPECT_THAT(error_of("mesh.off\n1 2 3\n"),
              HasSubstr("ends after line 2, expected the point looked at"));
}

TEST_F(stage04_read_scene, a_file_that_is_not_there_is_named) {
  EXPECT_THROW(read_scene(folder_ / "none.scene"), InputError);
  EXPECT_THROW(read_scene(folder_.path()), InputError);
}

TEST_F(stage04_read_scene, binary_noise_is_one_error) {
  std::string noise;
  for (int i = 0; i < 5000; ++i) noise += static_cast<char>(i * 7919 % 256);
  EXPECT_NE(error_of(noise), "no error");
}

}  // namespace
}  // namespace rasterlab
