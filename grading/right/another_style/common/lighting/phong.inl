// A right answer written differently: the mirrored eye instead of the mirrored light, which makes
// the same angle.
#pragma once

namespace rasterlab {

template <class Number>
Reflection<Number> phong(const Vector3<Number>& normal, const Vector3<Number>& to_light,
                         const Vector3<Number>& to_eye, const Light& light,
                         const Material& material) {
  const Number cosine = dot(normal, to_light);
  const Number twice = Number(2) * dot(normal, to_eye);
  const Vector3<Number> mirrored_eye(twice * normal.x() - to_eye.x(),
                                     twice * normal.y() - to_eye.y(),
                                     twice * normal.z() - to_eye.z());
  const Number angle = dot(mirrored_eye, to_light);
  const Number bright = Number(light.intensity);
  Number specular = power(maximum(angle, Number(0)), Number(material.shininess));
  specular = select(angle > Number(0), specular, Number(0));
  specular = select(cosine > Number(0), specular, Number(0));
  return {Number(material.ambient) * Number(light.ambient_intensity),
          bright * Number(material.diffuse) * maximum(cosine, Number(0)),
          bright * Number(material.specular) * specular};
}

}  // namespace rasterlab
