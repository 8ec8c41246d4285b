// Every shader of the stage gives a wide Number's lanes the bits that it gives one float: what
// runs in the engine is what runs here.
#include "common/shaders/culled.h"
#include "common/shaders/lattice.h"
#include "common/shaders/shaders.h"

#include "tests/stage07/scene.h"
#include "tests/support/toy_lanes.h"

#include <random>

#include <gtest/gtest.h>

namespace rasterlab {
namespace {

constexpr std::size_t lanes = 4;
using Wide = ToyLanes<lanes>;

template <class Shader>
class stage07_lanes : public testing::Test {};

using Shaders = testing::Types<Plain<VertexColor>, Flat<TextureColor>, GouraudSurface<TextureColor>,
                               QuantizedGouraud<VertexColor>, BumpedInObjectSpace<ConstantColor>,
                               Bumped<TextureColor>, PhongSurface<ConstantColor>,
                               BlinnPhongSurface<VertexColor>, GouraudHighlight<TextureColor>,
                               BumpedShinyPhong<TextureColor>, Lattice>;
TYPED_TEST_SUITE(stage07_lanes, Shaders);

template <template <class> class Varyings>
void fill(Varyings<Wide>& varyings, std::mt19937& random, float extent) {
  std::uniform_real_distribution<float> value(-extent, extent);
  for (int i = 0; i < number_count<Varyings>(); ++i) {
    for (float& lane : numbers(varyings)[i].lane) lane = value(random);
  }
}

template <template <class> class Varyings>
Varyings<float> lane_of(const Varyings<Wide>& wide, std::size_t lane) {
  Varyings<float> one;
  for (int i = 0; i < number_count<Varyings>(); ++i) numbers(one)[i] = numbers(wide)[i].lane[lane];
  return one;
}

TYPED_TEST(stage07_lanes, equal_one_float) {
  const TestScene scene("uv_sphere:4");
  ShaderInputs inputs = scene.inputs();
  inputs.light = {.position = {0.3F, 0.5F, 0.2F, 1}};
  inputs.material.shininess = 3;
  const TypeParam shader(inputs);
  std::mt19937 random(11);
  for (int i = 0; i < 200; ++i) {
    SurfacePoint<TypeParam::template Varyings, Wide> wide;
    fill<TypeParam::template Varyings>(wide.value, random, 1.5F);
    fill<TypeParam::template Varyings>(wide.dx, random, 0.3F);
    fill<TypeParam::template Varyings>(wide.dy, random, 0.3F);
    for (bool& front : wide.front_facing.lane) front = random() % 2 == 0;
    const Fragment<Wide> shaded = to_fragment(shader.fragment(wide));
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const SurfacePoint<TypeParam::template Varyings, float> point{
          lane_of<TypeParam::template Varyings>(wide.value, lane),
          lane_of<TypeParam::template Varyings>(wide.dx, lane),
          lane_of<TypeParam::template Varyings>(wide.dy, lane), wide.front_facing.lane[lane]};
      const Fragment<float> one = to_fragment(shader.fragment(point));
      EXPECT_EQ(shaded.discarded.lane[lane], one.discarded);
      for (int channel = 0; channel < 3; ++channel) {
        EXPECT_EQ(shaded.color[channel].lane[lane], one.color[channel])
            << "channel " << channel << " of lane " << lane;
      }
    }
  }
}

}  // namespace
}  // namespace rasterlab
