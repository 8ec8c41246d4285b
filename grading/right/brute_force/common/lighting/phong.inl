// A right answer written differently: every scalar product written out.
#pragma once

namespace rasterlab {

template <class Number>
Reflection<Number> phong(const Vector3<Number>& normal, const Vector3<Number>& to_light,
                         const Vector3<Number>& to_eye, const Light& light,
                         const Material& material) {
  const Number n_l =
      normal.x() * to_light.x() + normal.y() * to_light.y() + normal.z() * to_light.z();
  Number r_e(0);
  for (int i = 0; i < 3; ++i) {
    r_e = r_e + (Number(2) * n_l * normal[i] - to_light[i]) * to_eye[i];
  }
  const Number none(0);
  Reflection<Number> seen{none, none, none};
  seen.ambient = Number(light.ambient_intensity * material.ambient);
  seen.diffuse = Number(light.intensity * material.diffuse) * select(n_l > none, n_l, none);
  const Number base = select(r_e > none, r_e, none);
  const Number shine =
      Number(light.intensity * material.specular) * power(base, Number(material.shininess));
  seen.specular = select(n_l > none, select(r_e > none, shine, none), none);
  return seen;
}

}  // namespace rasterlab
