// Two pictures on one surface, read at the same places.
#pragma once

#include "common/image/check.h"
#include "common/texture/trilinear.h"

namespace rasterlab {

/// Two textures of one size, as a surface's colours and its normal map often are. They must outlive
/// this, which can be copied but not assigned.
class TexturePair {
 public:
  /// Throws CheckError when their sizes, or the numbers of their levels, differ.
  TexturePair(const Texture& one, const Texture& other) : one_(one), other_(other) {
    if (one.width() != other.width() || one.height() != other.height() ||
        one.level_count() != other.level_count()) {
      throw CheckError("a pair of textures needs two of one size");
    }
  }

  const Texture& one() const { return one_; }
  const Texture& other() const { return other_; }
  int level_count() const { return one_.level_count(); }

 private:
  const Texture& one_;
  const Texture& other_;
};

/// What each has at a place.
template <class Number>
struct ColorPair {
  Vector3<Number> one, other;
};

template <class Number>
ColorPair<Number> blend(const ColorPair<Number>& a, const ColorPair<Number>& b,
                        const Number& part) {
  return {blend(a.one, b.one, part), blend(a.other, b.other, part)};
}

/// bilinear_in_level() of each. Where the texels lie is found once for both: of what a sample
/// costs, nearly half.
template <class Number>
ColorPair<Number> bilinear_in_level(const TexturePair& textures, Wrap wrap,
                                    const Vector2<Number>& uv, const Number& level_index) {
  return visit_square(textures.one(), wrap, uv, level_index,
                      [&](const auto& place, const Number& right, const Number& up) {
                        const auto of = [&](const Texture& texture) {
                          return bilinear(TexelSquare<Number>{texture.texels(place), right, up});
                        };
                        return ColorPair<Number>{of(textures.one()), of(textures.other())};
                      });
}

/// sample_trilinear() of each, whose level is found once as well.
template <class Number>
ColorPair<Number> sample_trilinear(const TexturePair& textures, Wrap wrap,
                                   const Footprint<Number>& footprint) {
  // <solution>
  return blend_levels(textures, wrap, footprint.uv, mip_level(textures.one(), footprint));
  // <starter> return {sample_trilinear(textures.one(), wrap, footprint),
  // <starter>         sample_trilinear(textures.other(), wrap, footprint)};
  // </solution>
}

}  // namespace rasterlab
