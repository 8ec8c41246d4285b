// Exercise 07.5: a culler any shader can take.
#pragma once

#include "common/mesh/shader_types.h"
#include "common/projection/triangle_pixels.h"

namespace rasterlab {

/// A pixel's fragment, discarded also where it shows the side that `cull` names, Cull::none naming
/// neither. Front and back are as the camera sees them, in any projection, under a model that
/// mirrors too, and wherever the light is: `front_facing` of the pixel's SurfacePoint says which.
/// The fragment's colour stays as it is. Cost: one comparison.
///
/// Source: B.culler.
template <class Number>
Fragment<Number> cull_fragment(const Fragment<Number>& fragment, const Mask<Number>& front_facing,
                               Cull cull);

/// Any shader, that draws one side of its faces only. The picture is the same as with a draw call's
/// own culling, which is faster: there a face is refused once, here pixel by pixel.
template <ShaderType Shader>
struct Culled : Shader {
  Cull cull;

  template <class Number>
  Fragment<Number> fragment(const SurfacePoint<Shader::template Varyings, Number>& point) const {
    return cull_fragment(to_fragment(Shader::fragment(point)), point.front_facing, cull);
  }
};

}  // namespace rasterlab

#include "common/shaders/culled.inl"
