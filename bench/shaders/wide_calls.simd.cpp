#include "bench/shaders/wide_calls.h"

#include "common/engine/number_pair.h"

namespace rasterlab::bench::RASTERLAB_SIMD {
namespace {

using namespace rasterlab::RASTERLAB_SIMD;  // Number, NumberPair, load(), store()

/// One vector, or two side by side.
template <class Wide>
struct Vectors {
  static constexpr int count = lanes;
  static Number load_from(const float* from) { return load(from); }
  static void store_to(Number number, float* to) { store(number, to); }
};
template <>
struct Vectors<NumberPair> {
  static constexpr int count = 2 * lanes;
  static NumberPair load_from(const float* from) { return {load(from), load(from + lanes)}; }
  static void store_to(const NumberPair& pair, float* to) {
    store(pair.low, to);
    store(pair.high, to + lanes);
  }
};

template <class Wide, class Shader>
void shade(const Shader& shader, ShadedPoints& points) {
  constexpr auto varying_count =
      static_cast<std::size_t>(number_count<Shader::template Varyings>());
  for (int i = 0; i < ShadedPoints::count; i += Vectors<Wide>::count) {
    SurfacePoint<Shader::template Varyings, Wide> point;
    for (std::size_t n = 0; n < varying_count; ++n) {
      numbers<Shader::template Varyings, Wide>(point.value)[n] =
          Vectors<Wide>::load_from(points.varyings[n].data() + i);
    }
    const Vector3<Wide> color = shader.fragment(point);
    for (std::size_t c = 0; c < 3; ++c) {
      Vectors<Wide>::store_to(color[static_cast<Eigen::Index>(c)], points.color[c].data() + i);
    }
  }
}

}  // namespace

void shade_wide(const FlatShader& shader, ShadedPoints& points) {
  shade<Number>(shader, points);
}
void shade_wide(const PhongShader& shader, ShadedPoints& points) {
  shade<Number>(shader, points);
}
void shade_in_pairs(const FlatShader& shader, ShadedPoints& points) {
  shade<NumberPair>(shader, points);
}
void shade_in_pairs(const PhongShader& shader, ShadedPoints& points) {
  shade<NumberPair>(shader, points);
}

}  // namespace rasterlab::bench::RASTERLAB_SIMD
