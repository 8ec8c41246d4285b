// Exercise 07.5; the contract is in culled.h.
#pragma once

#include "common/image/check.h"

namespace rasterlab {

template <class Number>
Fragment<Number> cull_fragment(const Fragment<Number>& fragment, const Mask<Number>& front_facing,
                               Cull cull) {
  // <solution>
  Fragment<Number> result = fragment;
  if (cull == Cull::front) result.discarded = fragment.discarded || front_facing;
  if (cull == Cull::back) result.discarded = fragment.discarded || !front_facing;
  return result;
  // <starter> throw NotWritten("07.5", fragment, front_facing, cull);
  // </solution>
}

}  // namespace rasterlab
