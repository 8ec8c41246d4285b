#include "bench/texture/filters.h"

#include "common/texture/sample.h"

#include "bench/support/picture_error.h"
#include "bench/support/random_number.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>

namespace rasterlab::bench {
namespace {

constexpr int width = 48;
constexpr int height = 32;
constexpr int texture_size = 256;

/// A chequered floor with dirt on it: sharp edges, and grain as fine as a texel.
Image<Rgb8> chequered() {
  std::mt19937 random(31);
  Image<Rgb8> image(texture_size, texture_size);
  for (int y = 0; y < texture_size; ++y) {
    for (int x = 0; x < texture_size; ++x) {
      const bool light = (x / 12 + y / 12) % 2 == 0;
      const auto dirty = [&](double value) {
        return static_cast<float>(value + random_number(random, -0.15, 0.15));
      };
      image.row(y)[x] = light ? to_rgb8({dirty(0.85), dirty(0.8), dirty(0.65)})
                              : to_rgb8({dirty(0.25), dirty(0.2), dirty(0.3)});
    }
  }
  return image;
}

using Footprints = Image<Footprint<float>>;

/// Of a wall that is seen straight on, turned a little, with so many texels to a pixel.
Footprint<float> on_wall(double texels, int x, int y) {
  const double scale = texels / texture_size;
  const Eigen::Vector2d dx = scale * Eigen::Vector2d(0.94, 0.34);
  const Eigen::Vector2d dy = scale * Eigen::Vector2d(-0.34, 0.94);
  const Eigen::Vector2d uv = dx * (x + 0.5) + dy * (y + 0.5) + Eigen::Vector2d(0.317, 0.211);
  return {uv.cast<float>(), dx.cast<float>(), dy.cast<float>()};
}

/// Of a floor below the eye, up to close below the horizon: (u, v) = (x, 1)/y · scale.
Footprint<float> on_floor(int x, int y) {
  const double scale = 0.6;
  const double right = x + 0.5 - width / 2.0;
  const double down = y + 1.5;
  const Eigen::Vector2d uv(0.05 * scale * right / down, scale / down);
  const Eigen::Vector2d dx(0.05 * scale / down, 0);
  const Eigen::Vector2d dy = -uv / down;
  return {(uv + Eigen::Vector2d(0.5, 0)).cast<float>(), dx.cast<float>(), dy.cast<float>()};
}

Footprints footprints_of(TextureView view) {
  const Footprint<float> none{Eigen::Vector2f::Zero(), Eigen::Vector2f::Zero(),
                              Eigen::Vector2f::Zero()};
  Footprints footprints(width, height, none);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      footprints.row(y)[x] = view == TextureView::grazing
                                 ? on_floor(x, y)
                                 : on_wall(view == TextureView::near_by ? 0.3 : 5.3, x, y);
    }
  }
  return footprints;
}

template <class Number>
Vector2<Number> widened(const Eigen::Vector2f& vector) {
  return {Number(vector.x()), Number(vector.y())};
}

template <class Number>
Vector3<Number> filtered(const Sampler& sampler, const Footprint<float>& footprint) {
  return sample<Number>(sampler, {widened<Number>(footprint.uv), widened<Number>(footprint.dx),
                                  widened<Number>(footprint.dy)});
}

/// The mean of the texture, bilinear between its texels, over the parallelogram that a pixel's
/// derivatives span: of samples half a texel apart or less.
template <class Number>
Vector3<Number> averaged(const Texture& texture, const Footprint<float>& footprint) {
  const auto count = [&](const Eigen::Vector2f& step) {
    const double texels = double{step.norm()} * texture_size;
    return static_cast<int>(std::clamp(std::ceil(2 * texels), 4.0, 96.0));
  };
  const int across = count(footprint.dx);
  const int down = count(footprint.dy);
  const Vector2<Number> uv = widened<Number>(footprint.uv);
  const Vector2<Number> dx = widened<Number>(footprint.dx);
  const Vector2<Number> dy = widened<Number>(footprint.dy);
  const auto part = [](int i, int parts) -> Number {
    return (Number(static_cast<float>(i)) + Number(0.5F)) / Number(static_cast<float>(parts)) -
           Number(0.5F);
  };
  Vector3<Number> sum = broadcast<Number>(Eigen::Vector3f::Zero());
  for (int row = 0; row < down; ++row) {
    for (int column = 0; column < across; ++column) {
      const Vector2<Number> at = uv + dx * part(column, across) + dy * part(row, down);
      sum += bilinear_in_level<Number>(texture, Wrap::repeat, at, Number(0));
    }
  }
  return sum / Number(static_cast<float>(across * down));
}

/// A colour for each footprint, by both oracles.
template <class ColorOf>
Image<TrueColor> picture_of(const Footprints& footprints, ColorOf color_of) {
  Image<TrueColor> picture(width, height, TrueColor::black());
  for (std::size_t i = 0; i < footprints.pixels().size(); ++i) {
    const Footprint<float>& footprint = footprints.pixels()[i];
    picture.pixels()[i] = {color_of.template operator()<OracleNumber<double>>(footprint),
                           color_of.template operator()<OracleNumber<Quad>>(footprint)};
  }
  return picture;
}

void draw(const Sampler& sampler, const Footprints& footprints, Image<Color>& picture) {
  for (std::size_t i = 0; i < footprints.pixels().size(); ++i)
    picture.pixels()[i] = sample(sampler, footprints.pixels()[i]);
}

const char* name_of(TextureView view) {
  switch (view) {
    case TextureView::near_by:
      return "0.3 texels a pixel";
    case TextureView::far_off:
      return "5.3 texels a pixel";
    case TextureView::grazing:
      break;
  }
  return "a floor at a grazing angle";
}

}  // namespace

TimedLadder filter_ladder_of(TextureView view) {
  const auto texture = std::make_shared<Texture>(chequered());
  const auto footprints = std::make_shared<Footprints>(footprints_of(view));
  TimedLadder ladder{.name = std::string("06.4 filters, ") + name_of(view),
                     .stage = "06",
                     .unit = "sample",
                     .units = width * height,
                     .error = "model: RMSE, codes",
                     .rungs = {}};
  const Image<TrueColor> truth =
      picture_of(*footprints, [&]<class Number>(const Footprint<float>& footprint) {
        return averaged<Number>(*texture, footprint);
      });
  for (const FilterRung& rung : filter_ladder()) {
    const Sampler sampler{texture.get(), rung.filter, Wrap::repeat};
    const Image<TrueColor> meant =
        picture_of(*footprints, [&]<class Number>(const Footprint<float>& footprint) {
          return filtered<Number>(sampler, footprint);
        });
    const auto picture = std::make_shared<Image<Color>>(width, height);
    draw(sampler, *footprints, *picture);
    Errors errors = picture_errors("model", meant, truth);
    const Errors implementation = picture_errors("implementation", *picture, meant);
    errors.insert(errors.end(), implementation.begin(), implementation.end());
    ladder.rungs.push_back(
        {.name = rung.name,
         .fault = rung.known_fault,
         .work = [texture, sampler, footprints, picture] { draw(sampler, *footprints, *picture); },
         .errors = errors});
  }
  return ladder;
}

}  // namespace rasterlab::bench
