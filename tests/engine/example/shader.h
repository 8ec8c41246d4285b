#pragma once

#include "common/mesh/shader_types.h"

/// The normal as a colour.
struct NormalShader {
  template <class Number>
  struct Varyings {
    rasterlab::Vector3<Number> normal;
  };
  Varyings<float> vertex(const rasterlab::Mesh& mesh, std::uint32_t triangle, int corner) const {
    return {mesh.normals[mesh.triangles[triangle][static_cast<std::size_t>(corner)]]};
  }
  template <class Number>
  rasterlab::Vector3<Number> fragment(
      const rasterlab::SurfacePoint<Varyings, Number>& point) const {
    const auto color = [](Number n) { return n * Number(0.5F) + Number(0.5F); };
    return {color(point.value.normal.x()), color(point.value.normal.y()),
            color(point.value.normal.z())};
  }
};
