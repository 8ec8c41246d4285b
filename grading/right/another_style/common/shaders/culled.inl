// A right answer written differently: which pixels stay, then what is not among them.
#pragma once

namespace rasterlab {

template <class Number>
Fragment<Number> cull_fragment(const Fragment<Number>& fragment, const Mask<Number>& front_facing,
                               Cull cull) {
  if (cull == Cull::none) return fragment;
  const Mask<Number> stays = cull == Cull::back ? front_facing : !front_facing;
  return {fragment.color, fragment.discarded || !stays};
}

}  // namespace rasterlab
