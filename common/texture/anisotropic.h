// Exercise 06.4, fifth rung: as many samples as the footprint is long.
#pragma once

#include "common/texture/footprint.h"
#include "common/texture/trilinear.h"

namespace rasterlab {

/// A footprint as the ellipse into which its derivatives take the unit circle: the longer axis, and
/// the length of both, in texels of level 0.
template <class Number>
struct FootprintEllipse {
  Vector2<Number> axis;  ///< the longer one, in (u, v)
  Number longer;
  Number shorter;
};

/// The axes from the derivatives' Jacobian J: the longer one's square is the larger eigenvalue of
/// J·Jᵀ, and longer · shorter = |det J|. Source: Heckbert, "Fundamentals of Texture Mapping and
/// Image Warping", 1989, 3.5.
template <class Number>
FootprintEllipse<Number> footprint_ellipse(const Texture& texture,
                                           const Footprint<Number>& footprint) {
  const Vector2<Number> dx = to_texels(texture, footprint.dx);
  const Vector2<Number> dy = to_texels(texture, footprint.dy);
  // J is dx and dy side by side; Jᵀ·J = [a b; b c] has the same eigenvalues and its eigenvector
  // (s, t) says which mixture s·dx + t·dy of the two steps is the longer axis.
  const Number a = squared_length(dx);
  const Number c = squared_length(dy);
  const Number b = dx.x() * dy.x() + dx.y() * dy.y();
  const Number half_difference = Number(0.5F) * (a - c);
  const Number root = square_root(half_difference * half_difference + b * b);
  // (root + |d|, b) or (b, root + |d|): of the two forms of the eigenvector, the one that does not
  // cancel.
  const Number along = root + magnitude(half_difference);
  const auto dx_is_longer = half_difference >= Number(0);
  const Number s = select(dx_is_longer, along, b);
  const Number t = select(dx_is_longer, b, along);
  const Number length = square_root(s * s + t * t);
  const auto is_ellipse = length > Number(0);  // A circle has no longer axis: dx will do.
  const Number unit_s = select(is_ellipse, Number(s / length), Number(1));
  const Number unit_t = select(is_ellipse, Number(t / length), Number(0));
  const Vector2<Number> axis(unit_s * footprint.dx.x() + unit_t * footprint.dy.x(),
                             unit_s * footprint.dx.y() + unit_t * footprint.dy.y());
  const Number longer = square_root(squared_length(to_texels(texture, axis)));
  const Number area = magnitude(dx.x() * dy.y() - dx.y() * dy.x());
  const Number shorter = select(longer > Number(0), Number(area / longer), Number(0));
  return {axis, longer, shorter};
}

/// Trilinear samples evenly along the longer axis of the footprint, and their mean. There are as
/// many as the longer axis has the shorter one, or texels if they are larger: that ratio less 1/64,
/// rounded up, at least 1, at most 16. (Without the 1/64, what rounding adds to a ratio of 1 would
/// take a second sample.) Each is taken at the level of the shorter axis, or, where 16 don't reach,
/// of the distance between samples. Cost: up to 128 texels.
///
/// Source: EXT_texture_filter_anisotropic, with the ellipse's true axes in place of its two steps,
/// and with a level that doesn't jump where the number of samples does.
template <class Number>
Vector3<Number> sample_anisotropic(const Texture& texture, Wrap wrap,
                                   const Footprint<Number>& footprint);

}  // namespace rasterlab

#include "common/texture/anisotropic.inl"
