// What a shader and whoever calls it, a rendering loop or the engine, agree on.
//
// A shader is a struct. Its members are its uniforms; it declares its varyings once, typed, and has
// two functions:
//
//   struct FacingRatio {
//     Eigen::Vector3f toward_eye;
//
//     template <class Number>
//     struct Varyings {  // Numbers, Vector2 and Vector3 of Number: nothing else
//       Vector3<Number> normal;
//     };
//
//     Varyings<float> vertex(const Mesh& mesh, std::uint32_t triangle, int corner) const {
//       return {mesh.normals[mesh.triangles[triangle][corner]]};
//     }
//
//     template <class Number>
//     Vector3<Number> fragment(const SurfacePoint<Varyings, Number>& point) const {
//       return Vector3<Number>::Constant(dot(point.value.normal, broadcast<Number>(toward_eye)));
//     }
//   };
//
// vertex() is called for the three corners of a triangle, at least once when one of its pixels is
// shaded; fragment() once for a visible pixel, or for as many as a Number has lanes. Both are const
// and depend on their arguments and the uniforms alone, so that calls may come in any order, from
// any thread, and not at all where nothing is seen. Where a corner lands on the screen is not the
// shader's to say but the draw call's, whose one matrix takes positions to clip space: what cannot
// be seen is skipped without asking the shader.
//
// A shader whose fragment() reads no derivatives may say so, by
// `static constexpr bool reads_derivatives = false;`: then nobody need work them out. So may the
// parts that a shader is put together from.
//
// fragment() returns the colour, or, if it may refuse to draw, a Fragment: the type tells the
// caller which, and a caller may shade only the nearest surface of a shader that never refuses. A
// shader that isn't written for every Number takes `SurfacePoint<Varyings, float>` and is called a
// lane at a time.
#pragma once

#include "common/image/number.h"
#include "common/mesh/mesh.h"

#include <array>
#include <concepts>
#include <cstdint>
#include <type_traits>

namespace rasterlab {

/// The point of a triangle that a pixel's centre sees; with a wide Number, one per lane.
template <template <class> class Varyings, class NumberType>
struct SurfacePoint {
  using Number = NumberType;

  Varyings<Number> value;  ///< interpolated perspective-correctly
  Varyings<Number>
      dx;  ///< ∂value/∂x, per pixel to the right: the exact derivative, no difference of neighbours
  Varyings<Number> dy;        ///< ∂value/∂y, per pixel down
  Mask<Number> front_facing;  ///< whether the triangle's front, counter-clockwise, is what is seen
};

/// What a shader that may discard makes of a pixel. A discarded pixel stays as it was, its depth
/// included.
template <class Number>
struct Fragment {
  Vector3<Number> color;   ///< red, green, blue, nominally in [0, 1]
  Mask<Number> discarded;  ///< whether not to draw
};

/// What either kind of shader returns, as a Fragment.
template <class Number>
Fragment<Number> to_fragment(const Fragment<Number>& fragment) {
  return fragment;
}
template <class Number>
Fragment<Number> to_fragment(const Vector3<Number>& color) {
  return {color, Number(1) < Number(0)};
}

/// Whether `Shader` can shade as many pixels at once as a `Number` has lanes.
template <class Shader, class Number>
concept ShadesNumbers = requires(const Shader& shader,
                                 const SurfacePoint<Shader::template Varyings, Number>& point) {
  shader.fragment(point);
};

/// What every shader offers at the least.
template <class Shader>
concept ShaderType = ShadesNumbers<Shader, float> &&
    requires(const Shader& shader, const Mesh& mesh) {
  {
    shader.vertex(mesh, std::uint32_t{0}, 0)
    } -> std::same_as<typename Shader::template Varyings<float>>;
};

/// Whether a shader's fragment() may discard: it returns a Fragment and not just a colour.
template <ShaderType Shader>
inline constexpr bool may_discard =
    std::same_as<decltype(std::declval<const Shader&>().fragment(
                     std::declval<const SurfacePoint<Shader::template Varyings, float>&>())),
                 Fragment<float>>;

/// Whether a shader, or a part of one, may read dx and dy of a SurfacePoint: unless it says that it
/// doesn't. What a shader says it doesn't read means nothing.
template <class Reader>
constexpr bool reads_derivatives() {
  if constexpr (requires { Reader::reads_derivatives; }) {
    return Reader::reads_derivatives;
  } else {
    return true;
  }
}

/// How many Numbers a Varyings holds.
template <template <class> class Varyings>
constexpr int number_count() {
  if constexpr (std::is_empty_v<Varyings<float>>) {
    return 0;
  } else {
    static_assert(alignof(Varyings<float>) == alignof(float),
                  "a Varyings holds Numbers, Vector2 and Vector3 only");
    return static_cast<int>(sizeof(Varyings<float>) / sizeof(float));
  }
}

/// A Varyings as the array of its `number_count` Numbers, in the order they are declared.
template <template <class> class Varyings, class Number>
const Number* numbers(const Varyings<Number>& varyings) {
  static_assert(std::is_empty_v<Varyings<float>> ||
                    sizeof(Varyings<Number>) == number_count<Varyings>() * sizeof(Number),
                "a Varyings holds Numbers, Vector2 and Vector3 only");
  return reinterpret_cast<const Number*>(&varyings);
}
template <template <class> class Varyings, class Number>
Number* numbers(Varyings<Number>& varyings) {
  return const_cast<Number*>(numbers(static_cast<const Varyings<Number>&>(varyings)));
}

/// Weights of a triangle's corners 1 and 2; corner 0 has what is left to 1. For a value they are
/// perspective-corrected barycentric weights, for a derivative those weights' derivatives.
template <class Number>
struct CornerWeights {
  Number b1;
  Number b2;
};

/// b1·(a1 − a0) + b2·(a2 − a0) for each Number of a Varyings: the derivative, given derivatives of
/// the weights.
template <template <class> class Varyings, class Number>
Varyings<Number> interpolate_differences(const std::array<Varyings<float>, 3>& corners,
                                         const CornerWeights<Number>& weights) {
  Varyings<Number> result;
  for (int i = 0; i < number_count<Varyings>(); ++i) {
    const float a0 = numbers(corners[0])[i];
    const Number to_1 = numbers(corners[1])[i] - a0;
    const Number to_2 = numbers(corners[2])[i] - a0;
    numbers(result)[i] = weights.b1 * to_1 + weights.b2 * to_2;
  }
  return result;
}

/// a0 + (b1·(a1 − a0) + b2·(a2 − a0)) for each Number of a Varyings: where the corners are equal,
/// exactly their value.
template <template <class> class Varyings, class Number>
Varyings<Number> interpolate(const std::array<Varyings<float>, 3>& corners,
                             const CornerWeights<Number>& weights) {
  Varyings<Number> result = interpolate_differences(corners, weights);
  for (int i = 0; i < number_count<Varyings>(); ++i) {
    numbers(result)[i] = Number(numbers(corners[0])[i]) + numbers(result)[i];
  }
  return result;
}

}  // namespace rasterlab
