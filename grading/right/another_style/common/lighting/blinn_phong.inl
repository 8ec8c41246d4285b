// A right answer written differently: the cosine to the half-way vector by a quotient, the vector
// never made a unit.
#pragma once

namespace rasterlab {

template <class Number>
Reflection<Number> blinn_phong(const Vector3<Number>& normal, const Vector3<Number>& to_light,
                               const Vector3<Number>& to_eye, const Light& light,
                               const Material& material) {
  const Vector3<Number> sum(to_light + to_eye);
  const Number squared = dot(sum, sum);
  const Number length = select(squared > Number(0), square_root(squared), Number(1));
  const Number half_way = dot(normal, sum) / length;
  const Number cosine = dot(normal, to_light);
  const Number shine = power(maximum(half_way, Number(0)), Number(material.shininess));
  const Number seen =
      select(cosine > Number(0), select(half_way > Number(0), shine, Number(0)), Number(0));
  const Number bright(light.intensity);
  return {Number(light.ambient_intensity) * Number(material.ambient),
          bright * Number(material.diffuse) * maximum(cosine, Number(0)),
          bright * Number(material.specular) * seen};
}

}  // namespace rasterlab
