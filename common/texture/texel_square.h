// The four texels about a point, found and fetched, which is most of what a blend of them costs:
// wide Numbers have a quicker way where a texture is magnified.
#pragma once

#include "common/texture/texture.h"
#include "common/texture/wrap.h"

namespace rasterlab {

/// Where between the centres of which two texels along one axis a point lies.
template <class Number>
struct TexelPair {
  Number first;  ///< the other is the next one; each may be one beyond an edge
  Number part;   ///< how far it is from the first to the next

  /// Of `size` texels.
  TexelPair(const Number& coordinate, const Number& size) {
    const Number from_center = fused_multiply_add(coordinate, size, Number(-0.5F));
    first = round_down(from_center);
    part = from_center - first;
  }
};

/// The four texels whose centres surround a point, and where between them it lies.
template <class Number>
struct TexelSquare {
  std::array<Vector3<Number>, 4> texels;  ///< 0 to 255: lower left, lower right, upper left, …
  Number right;                           ///< how far the point is from the left to the right ones
  Number up;                              ///< and from the lower to the upper ones
};

/// Calls `visit(place, right, up)` for where they lie about (u, v) in one level, 0 to its last, of
/// all textures of one size (texture.h); beyond an edge there is what `wrap` says.
template <class Number, class Visit>
auto visit_square(const Texture& texture, Wrap wrap, const Vector2<Number>& uv,
                  const Number& level_index, const Visit& visit) {
  if constexpr (!std::is_same_v<Texture::NearSquare<Number>, NoNearSquares>) {
    // Most pixels are answered here; what isn't at an edge needs no wrapping.
    if (!any(level_index > Number(0))) {
      const TexelPair<Number> column(uv.x(), Number(static_cast<float>(texture.width())));
      const TexelPair<Number> row(uv.y(), Number(static_cast<float>(texture.height())));
      const auto place = texture.near_square(column.first, row.first);
      if (place.found) return visit(place, column.part, row.part);
    }
  }
  const auto level = texture.level(level_index);
  const TexelPair<Number> column(wrap_coordinate(uv.x(), wrap), level.width);
  const TexelPair<Number> row(wrap_coordinate(uv.y(), wrap), level.height);
  return texture.place_square(level, column.first, row.first, wrap, [&](const auto& place) {
    return visit(place, column.part, row.part);
  });
}

}  // namespace rasterlab
