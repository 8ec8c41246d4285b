// A right answer written differently: which of the two sides is named, then whether it is this one.
#pragma once

#include "common/image/check.h"

namespace rasterlab {

template <class Number>
Fragment<Number> cull_fragment(const Fragment<Number>& fragment, const Mask<Number>& front_facing,
                               Cull cull) {
  if (cull == Cull::none) return fragment;
  Fragment<Number> seen = fragment;
  const Mask<Number> is_named = cull == Cull::front ? front_facing : !front_facing;
  seen.discarded = is_named || seen.discarded;
  return seen;
}

}  // namespace rasterlab
