// What the probes of stage 07 try the parts of a shader on, each alone: compiling whole shaders
// would take longer than all the rest of a grading.
#pragma once

#include "common/shaders/light_models.h"

#include "grading/probes/probe.h"

#include <vector>

namespace rasterlab::grading {

/// A point of a surface, with the attributes that any part reads.
struct MadeUpPoint {
  using Number = float;

  struct {
    Vector3<float> position;
    Vector3<float> normal;
  } value;
};

/// A colour, normal and light source that say what they were told.
struct MadeUpSource {
  Color color;
  Vector3<float> normal;
  Vector3<float> to_light;

  Vector3<float> color_at(const MadeUpPoint& /*point*/) const { return color; }
  Vector3<float> normal_at(const MadeUpPoint& /*point*/) const { return normal; }
  Shade<float> light_at(const MadeUpPoint& /*point*/, const MadeUpSource& normals) const {
    return {maximum(dot(normals.normal_at({}), to_light), 0.0F)};
  }
};

inline void add(std::vector<double>& numbers, const Vector3<float>& vector) {
  for (const float number : vector) numbers.push_back(double(number));
}

}  // namespace rasterlab::grading
