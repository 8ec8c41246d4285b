#include "common/engine/renderer.h"

#include "tests/stage06/noise.h"
#include "tests/stage06/texture_pair_shader.h"

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

class stage06_texture_pair : public testing::Test {
 protected:
  stage06_texture_pair() {
    mesh_.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh_.triangles = {{0, 1, 2}, {0, 2, 3}};
  }

  Image<Rgb8> picture(const Eigen::Matrix4f& matrix, SimdTarget target, bool at_once) const {
    const PreparedMesh prepared(mesh_);
    const TexturePairShader shader = {{one_, other_}, at_once};
    Framebuffer frame(200, 150);
    Renderer({.threads = 1, .simd = target, .skip = {}})
        .draw({.mesh = &prepared, .matrix = matrix, .shading = shading(shader)}, frame);
    return frame.color();
  }

 private:
  Mesh mesh_;
  Texture one_ = Texture(noise(64, 32, 16));
  Texture other_ = Texture(noise(64, 32, 17));
};

/// Seen from just above it: of its texels, the nearest are 30 pixels wide, of the farthest a pixel
/// sees 60. w is the distance, 0.02 to 2.02.
Eigen::Matrix4f floor() {
  Eigen::Matrix4f matrix;
  matrix << 1, 0, 0, 0, 0, 0, 0, -0.05F, 0, 0, 0, 0.01F, 0, 1, 0, 1.02F;
  return matrix;
}

/// Seen from the front, a little tilted: texels are one to three pixels wide.
Eigen::Matrix4f wall() {
  Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
  matrix.row(3) << 0, 0.3F, 0, 1;
  return matrix;
}

TEST_F(stage06_texture_pair, same_bytes_at_once_or_one_by_one_on_every_instruction_set) {
  for (const Eigen::Matrix4f& matrix : {floor(), wall()}) {
    const Image<Rgb8> expected = picture(matrix, SimdTarget::scalar, false);
    for (const SimdTarget target : supported_simd_targets()) {
      EXPECT_EQ(picture(matrix, target, false), expected) << name_of(target) << ", one by one";
      EXPECT_EQ(picture(matrix, target, true), expected) << name_of(target) << ", at once";
    }
  }
}

}  // namespace
}  // namespace rasterlab
