// Exercise 05.2; the contract is in phong.h.
#pragma once

namespace rasterlab {

template <class Number>
Reflection<Number> phong(const Vector3<Number>& normal, const Vector3<Number>& to_light,
                         const Vector3<Number>& to_eye, const Light& light,
                         const Material& material) {
  // <solution>
  const Number zero(0);
  const Number facing = dot(normal, to_light);
  const Number mirrored = Number(2) * facing * dot(normal, to_eye) - dot(to_light, to_eye);  // r·e
  const Number highlight = select(minimum(facing, mirrored) > zero,
                                  power(maximum(mirrored, zero), material.shininess), zero);
  return {Number(light.ambient_intensity * material.ambient),
          Number(light.intensity * material.diffuse) * maximum(facing, zero),
          Number(light.intensity * material.specular) * highlight};
  // <starter> throw NotWritten("05.2", normal, to_light, to_eye, light, material);
  // </solution>
}

}  // namespace rasterlab
