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

 private:
  const Texture& one_;
  const Texture& other_;
};

/// sample_trilinear() of each. Which levels, which of their texels, and with what weights is found
/// once for both: of what a sample costs, nearly half.
template <class Number>
std::array<Vector3<Number>, 2> sample_trilinear(const TexturePair& textures, Wrap wrap,
                                                const Footprint<Number>& footprint) {
  // <solution>
  using Colors = std::array<Vector3<Number>, 2>;
  const auto bilinear = [&](const Number& level_index) {
    const auto of_square = [&](const auto& square, const Number& right, const Number& up) {
      const auto of = [&](const Texture& texture) {
        const auto texels = texture.texels(square);
        return Vector3<Number>(
            blend(blend(texels[0], texels[1], right), blend(texels[2], texels[3], right), up) *
            Number(1.0F / 255));
      };
      return Colors{of(textures.one()), of(textures.other())};
    };
    return visit_square(textures.one(), wrap, footprint.uv, level_index, of_square);
  };
  const Number level = mip_level(textures.one(), footprint);
  const Number finer = round_down(level);
  const Colors fine = bilinear(finer);
  if (!any(level > finer)) return fine;
  const Number last(static_cast<float>(textures.one().level_count() - 1));
  const Colors coarse = bilinear(minimum(finer + Number(1), last));
  return {blend(fine[0], coarse[0], Number(level - finer)),
          blend(fine[1], coarse[1], Number(level - finer))};
  // <starter> return {sample_trilinear(textures.one(), wrap, footprint),
  // <starter>         sample_trilinear(textures.other(), wrap, footprint)};
  // </solution>
}

}  // namespace rasterlab
