// Exercise 05.3; the contract is in blinn_phong.h.
#pragma once

namespace rasterlab {

template <class Number>
Reflection<Number> blinn_phong(const Vector3<Number>& normal, const Vector3<Number>& to_light,
                               const Vector3<Number>& to_eye, const Light& light,
                               const Material& material) {
  // <solution>
  const Number zero(0);
  const Number facing = dot(normal, to_light);
  const Vector3<Number> half = normalized(Vector3<Number>(
      to_light.x() + to_eye.x(), to_light.y() + to_eye.y(), to_light.z() + to_eye.z()));
  const Number half_way = dot(normal, half);
  const Number highlight = select(minimum(facing, half_way) > zero,
                                  power(maximum(half_way, zero), material.shininess), zero);
  return {Number(light.ambient_intensity * material.ambient),
          Number(light.intensity * material.diffuse) * maximum(facing, zero),
          Number(light.intensity * material.specular) * highlight};
  // <starter> throw NotWritten("05.3", normal, to_light, to_eye, light, material);
  // </solution>
}

}  // namespace rasterlab
