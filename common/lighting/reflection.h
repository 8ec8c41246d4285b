// What comes back from a lit surface, and where light and eye are: shared by the models of
// reflection.
#pragma once

#include "common/image/number.h"
#include "common/projection/scene.h"

#include <Eigen/Dense>

namespace rasterlab {

/// The light that a point of a surface sends to the eye, for white light on a white surface. A
/// number each because the light and the highlight are white; the surface's own colour comes in
/// lit().
template <class Number>
struct Reflection {
  Number ambient;   ///< of light from everywhere
  Number diffuse;   ///< scattered evenly
  Number specular;  ///< mirrored: the highlight
};

/// The unit vector from a point toward a light or an eye at (x, y, z)/w, or, with w = 0, infinitely
/// far away in direction (x, y, z). The zero vector where the two are the same point.
template <class Number>
Vector3<Number> direction_to(const Eigen::Vector4f& goal, const Vector3<Number>& from) {
  return normalized(Vector3<Number>(Number(goal.x()) - Number(goal.w()) * from.x(),
                                    Number(goal.y()) - Number(goal.w()) * from.y(),
                                    Number(goal.z()) - Number(goal.w()) * from.z()));
}

/// A surface's colour in that light: color · (ambient + diffuse) + specular, for each channel by
/// itself, and at most 1: what is brighter than white is white, it never wraps round.
template <class Number>
Vector3<Number> lit(const Vector3<Number>& color, const Reflection<Number>& reflection) {
  const Number shade = reflection.ambient + reflection.diffuse;
  const auto channel = [&](const Number& value) -> Number {
    return minimum(value * shade + reflection.specular, Number(1));
  };
  return {channel(color.x()), channel(color.y()), channel(color.z())};
}

}  // namespace rasterlab
