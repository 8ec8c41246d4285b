// Exercise 06.4, second rung: four texels, blended.
#pragma once

#include "common/texture/footprint.h"
#include "common/texture/texture.h"
#include "common/texture/wrap.h"

namespace rasterlab {

/// Where between the centres of which two texels along one axis a point lies.
template <class Number>
struct TexelPair {
  Number first;  ///< the other is the next one; each may be one beyond an edge
  Number part;   ///< how far it is from the first to the next
};

template <class Number>
TexelPair<Number> texel_pair(const Number& coordinate, const Number& size, Wrap wrap) {
  const Number from_center = wrap_coordinate(coordinate, wrap) * size - Number(0.5F);
  const Number first = round_down(from_center);
  return {first, from_center - first};
}

/// The four texels whose centres surround a point, and where between them it lies.
template <class Number>
struct TexelSquare {
  std::array<Vector3<Number>, 4> texels;  ///< 0 to 255: lower left, lower right, upper left, …
  Number right;                           ///< how far the point is from the left to the right ones
  Number up;                              ///< and from the lower to the upper ones
};

/// Of (u, v) in one level; beyond an edge there is what `wrap` says.
template <class Number>
TexelSquare<Number> texel_square(const Texture& texture, Wrap wrap, const Vector2<Number>& uv,
                                 const Number& level_index) {
  if constexpr (Texture::finds_near_texels<Number>) {
    // Where a texture is magnified, most pixels are answered here; what isn't at an edge needs no
    // wrapping.
    if (!any(level_index > Number(0))) {
      const auto from_center = [](const Number& coordinate, int size) {
        return coordinate * Number(static_cast<float>(size)) - Number(0.5F);
      };
      const Number x = from_center(uv.x(), texture.width());
      const Number y = from_center(uv.y(), texture.height());
      const Number left = round_down(x);
      const Number low = round_down(y);
      std::array<Vector3<Number>, 4> texels;
      if (texture.find_near_texels(left, low, texels)) return {texels, x - left, y - low};
    }
  }
  const auto level = texture.level(level_index);
  const auto column = texel_pair(uv.x(), level.width, wrap);
  const auto row = texel_pair(uv.y(), level.height, wrap);
  return {texture.texels(level, column.first, row.first, wrap), column.part, row.part};
}

/// a + part · (b − a): where a and b are equal, exactly that.
template <class Number>
Vector3<Number> blend(const Vector3<Number>& a, const Vector3<Number>& b, const Number& part) {
  return {a.x() + part * (b.x() - a.x()), a.y() + part * (b.y() - a.y()),
          a.z() + part * (b.z() - a.z())};
}

/// The colour, in [0, 1], at (u, v) of one level, linear in u and in v between the centres of
/// texels. At the edges the neighbour is what `wrap` says: repeat blends with the opposite edge,
/// clamp and mirror keep the edge's own colour. Cost: four texels.
template <class Number>
Vector3<Number> bilinear_in_level(const Texture& texture, Wrap wrap, const Vector2<Number>& uv,
                                  const Number& level_index);

/// bilinear_in_level() of level 0: smooth near by. The footprint's size still counts for nothing:
/// far off, a pixel blends four of the many texels it sees, which sparkles.
template <class Number>
Vector3<Number> sample_bilinear(const Texture& texture, Wrap wrap,
                                const Footprint<Number>& footprint) {
  return bilinear_in_level(texture, wrap, footprint.uv, Number(0));
}

}  // namespace rasterlab

#include "common/texture/bilinear.inl"
