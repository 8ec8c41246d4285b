// A right answer written differently: the mirrored light is a vector, and each case returns by
// itself where a Number allows it.
#pragma once

namespace rasterlab {

template <class Number>
Reflection<Number> phong(const Vector3<Number>& normal, const Vector3<Number>& to_light,
                         const Vector3<Number>& to_eye, const Light& light,
                         const Material& material) {
  Reflection<Number> sum{Number(light.ambient_intensity) * Number(material.ambient), Number(0),
                         Number(0)};
  const Number cosine = dot(normal, to_light);
  const Vector3<Number> mirrored(Number(2) * cosine * normal.x() - to_light.x(),
                                 Number(2) * cosine * normal.y() - to_light.y(),
                                 Number(2) * cosine * normal.z() - to_light.z());
  const Number toward_eye = maximum(dot(mirrored, to_eye), Number(0));
  sum.diffuse = select(cosine > Number(0),
                       Number(material.diffuse) * cosine * Number(light.intensity), Number(0));
  const Number shine = Number(material.specular) * power(toward_eye, Number(material.shininess));
  sum.specular =
      select(cosine > Number(0),
             select(toward_eye > Number(0), shine * Number(light.intensity), Number(0)), Number(0));
  return sum;
}

}  // namespace rasterlab
