// Exercise 05.2: the reflection model everyone starts with: a bit of light from everywhere, more
// where the surface faces the light, and a highlight where it mirrors the light into the eye.
#pragma once

#include "common/image/check.h"
#include "common/image/number.h"
#include "common/lighting/reflection.h"
#include "common/projection/scene.h"

namespace rasterlab {

/// Phong's reflection at a point whose unit normal is n, whose unit directions toward light and eye
/// are l and e, all in one frame of any kind. With i the light's intensity, iₐ that of the ambient
/// light, and r = 2 (n·l) n − l the mirrored direction toward the light:
///
///   ambient = iₐ · ka,   diffuse = i · kd · max(n·l, 0),   specular = i · ks · (r·e)^shininess
///
/// The specular part is 0 where n·l ≤ 0, a back-lit surface mirrors nothing, and where r·e ≤ 0: an
/// even power would make a highlight of a negative cosine. This holds for shininess 0 too, which
/// otherwise gives 1. A zero normal (a surface without one) gets ambient light alone. All parts are
/// clamped below by 0 before anything is added up; none is clamped above. Cost: two
/// scalar products and one power.
///
/// Source: A.Q31, with ka 0.2, kd 0.8, ks 0.6, shininess 128; B. T. Phong, "Illumination for
/// Computer Generated Pictures", CACM 18(6), 1975.
template <class Number>
Reflection<Number> phong(const Vector3<Number>& normal, const Vector3<Number>& to_light,
                         const Vector3<Number>& to_eye, const Light& light,
                         const Material& material);

}  // namespace rasterlab

#include "common/lighting/phong.inl"
