// A right answer written differently: both levels are always read, and mixed channel by channel.
#pragma once

namespace rasterlab {

template <class Number>
Vector3<Number> trilinear_at(const Texture& texture, Wrap wrap, const Vector2<Number>& uv,
                             const Number& level) {
  const Number last(static_cast<float>(texture.level_count() - 1));
  const Number below = minimum(round_down(level), last);
  const Number above = minimum(below + Number(1), last);
  const Number weight = level - below;
  const Vector3<Number> fine = bilinear_in_level(texture, wrap, uv, below);
  const Vector3<Number> coarse = bilinear_in_level(texture, wrap, uv, above);
  const auto mixed = [&](const Number& a, const Number& b) {
    return a * (Number(1) - weight) + b * weight;
  };
  return Vector3<Number>(mixed(fine.x(), coarse.x()), mixed(fine.y(), coarse.y()),
                         mixed(fine.z(), coarse.z()));
}

}  // namespace rasterlab
