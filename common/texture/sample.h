// The filter ladder, and reading a texture by any of its rungs.
#pragma once

#include "common/texture/anisotropic.h"
#include "common/texture/bilinear.h"
#include "common/texture/mip_mapped.h"
#include "common/texture/nearest.h"
#include "common/texture/trilinear.h"

#include <array>
#include <string>
#include <string_view>

namespace rasterlab {

/// How the texels that a pixel sees become one colour: from the cheapest to the best.
enum class Filter { nearest, bilinear, mip_mapped, trilinear, anisotropic };

/// Which levels of a texture it reads: others needn't be made.
constexpr MipLevels levels_for(Filter filter) {
  return filter == Filter::nearest || filter == Filter::bilinear ? MipLevels::none : MipLevels::all;
}

/// A texture and how to read it. The texture must outlive this.
struct Sampler {
  const Texture* texture = nullptr;
  Filter filter = Filter::trilinear;
  Wrap wrap = Wrap::repeat;
};

/// The colour, in [0, 1], that a pixel sees.
template <class Number>
Vector3<Number> sample(const Sampler& sampler, const Footprint<Number>& footprint) {
  const Texture& texture = *sampler.texture;
  switch (sampler.filter) {
    case Filter::nearest:
      return sample_nearest(texture, sampler.wrap, footprint);
    case Filter::bilinear:
      return sample_bilinear(texture, sampler.wrap, footprint);
    case Filter::mip_mapped:
      return sample_mip_mapped(texture, sampler.wrap, footprint);
    case Filter::trilinear:
      return sample_trilinear(texture, sampler.wrap, footprint);
    case Filter::anisotropic:
      break;
  }
  return sample_anisotropic(texture, sampler.wrap, footprint);
}

/// A rung of the ladder, for exercise code, tests and benchmarks.
struct FilterRung {
  Filter filter;
  std::string name;
  std::string known_fault;
};

/// Exercise 06.4's ladder, worst first.
const std::array<FilterRung, 5>& filter_ladder();

struct NamedWrap {
  Wrap wrap;
  std::string name;
  std::string description;
};

const std::array<NamedWrap, 3>& wrap_modes();

/// The filter or the way to wrap of that name. Throws InputError, which lists the names there are.
Filter filter_named(std::string_view name);
Wrap wrap_named(std::string_view name);

}  // namespace rasterlab
