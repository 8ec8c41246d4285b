// Exercise 05.3: Blinn's highlight, measured between the normal and the direction half way between
// light and eye.
#pragma once

#include "common/image/check.h"
#include "common/image/number.h"
#include "common/lighting/reflection.h"
#include "common/projection/scene.h"

namespace rasterlab {

/// Reflection at a point as phong() has it, but for the highlight: with h = (l + e) / ‖l + e‖,
///
///   specular = i · ks · (n·h)^shininess
///
/// which is 0 where n·l ≤ 0 or n·h ≤ 0, and where light and eye are in opposite directions (l + e =
/// 0). The same shininess gives a wider highlight than Phong's: the angle between n and h is about
/// half of that between r and e. Light and eye may be near or at infinity: direction_to() of
/// reflection.h gives l and e for either. Cost: one square root and one power.
///
/// Source: C.4; J. F. Blinn, "Models of Light Reflection for Computer Synthesized Pictures",
/// SIGGRAPH 1977. In C.4 the light is a point (w = 1) or at infinity (w = 0), and every channel is
/// lit by itself: lit() of reflection.h.
template <class Number>
Reflection<Number> blinn_phong(const Vector3<Number>& normal, const Vector3<Number>& to_light,
                               const Vector3<Number>& to_eye, const Light& light,
                               const Material& material);

}  // namespace rasterlab

#include "common/lighting/blinn_phong.inl"
