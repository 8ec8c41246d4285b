// A right answer written differently: Lambert's part first, each factor by its name in textbooks.
#pragma once

namespace rasterlab {

template <class Number>
Reflection<Number> blinn_phong(const Vector3<Number>& n, const Vector3<Number>& l,
                               const Vector3<Number>& v, const Light& light,
                               const Material& material) {
  const Number n_dot_l = maximum(dot(n, l), Number(0));
  const Vector3<Number> sum = l + v;
  const Vector3<Number> h = normalized(sum);
  const Number n_dot_h = maximum(dot(n, h), Number(0));
  const auto shines = n_dot_l > Number(0) && n_dot_h > Number(0);
  Reflection<Number> reflected{};
  reflected.ambient = Number(material.ambient * light.ambient_intensity);
  reflected.diffuse = n_dot_l * Number(material.diffuse * light.intensity);
  reflected.specular = select(shines, power(n_dot_h, Number(material.shininess)), Number(0)) *
                       Number(material.specular * light.intensity);
  return reflected;
}

}  // namespace rasterlab
