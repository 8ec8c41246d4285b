// A right answer written differently: what is hidden is said first.
#pragma once

namespace rasterlab {

template <class Number>
Fragment<Number> cull_fragment(const Fragment<Number>& fragment, const Mask<Number>& front_facing,
                               Cull cull) {
  if (cull == Cull::none) return fragment;
  const Mask<Number> hidden = cull == Cull::front ? front_facing : Mask<Number>(!front_facing);
  Fragment<Number> result = fragment;
  result.discarded = hidden || result.discarded;
  return result;
}

}  // namespace rasterlab
