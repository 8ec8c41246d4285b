// Exercise 07.1: the rendering loop, written once for every shader there is or will be.
#pragma once

#include "common/mesh/shader_types.h"
#include "common/projection/draw_mesh.h"

#include <array>
#include <cstdint>

namespace rasterlab {

/// The point of a triangle that a pixel sees, given the shader's varyings at its corners.
template <template <class> class Varyings>
SurfacePoint<Varyings, float> surface_point(const std::array<Varyings<float>, 3>& corners,
                                            const TrianglePixel& pixel) {
  return {interpolate<Varyings>(corners, pixel.weights),
          interpolate_differences<Varyings>(corners, pixel.weights_dx),
          interpolate_differences<Varyings>(corners, pixel.weights_dy), pixel.front_facing};
}

/// Draws every triangle of the mesh, in order, into `frame` by a shader (shader_types.h): its
/// vertex() once for each corner of each triangle of which a pixel is nearer than what was there,
/// its fragment() for each such pixel. A discarded pixel keeps its colour and its depth, and so
/// does every pixel of a face on the side that `cull` names.
///
/// `transforms` take the mesh's positions to clip space; colours are clamped to [0, 1] and rounded.
/// Returns what became of triangles and pixels. An empty mesh and triangles without area draw
/// nothing. Throws what the shader throws; cost: one test of depth for each covered pixel, one
/// fragment() for each that passes.
///
/// The shader's type is a template parameter: one loop in the source, one compiled for each shader,
/// with no virtual call per pixel. Source: B.shaders.
template <ShaderType Shader>
DrawCounts draw_shaded(const Mesh& mesh, const Transforms& transforms, Cull cull,
                       const Shader& shader, Frame& frame);

}  // namespace rasterlab

#include "common/shaders/draw_shaded.inl"
