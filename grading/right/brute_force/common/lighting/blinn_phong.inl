// A right answer written differently: component by component, part after part.
#pragma once

namespace rasterlab {

template <class Number>
Reflection<Number> blinn_phong(const Vector3<Number>& normal, const Vector3<Number>& to_light,
                               const Vector3<Number>& to_eye, const Light& light,
                               const Material& material) {
  Vector3<Number> half;
  for (int i = 0; i < 3; ++i) half[i] = (to_light[i] + to_eye[i]) * Number(0.5F);
  half = normalized(half);
  const Number n_l = dot(normal, to_light), n_h = dot(normal, half), none(0);
  Reflection<Number> reflection{none, none, none};
  reflection.ambient = Number(light.ambient_intensity * material.ambient);
  reflection.diffuse = select(n_l > none, Number(light.intensity * material.diffuse) * n_l, none);
  const Number lit = power(select(n_h > none, n_h, none), Number(material.shininess));
  const Number shine = Number(light.intensity * material.specular) * lit;
  reflection.specular = select(minimum(n_l, n_h) > none, shine, none);
  return reflection;
}

}  // namespace rasterlab
