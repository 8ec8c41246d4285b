#include "bench/support/picture_error.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rasterlab::bench {
namespace {

/// A number per pixel.
using Plane = Image<double>;

/// As ITU-R BT.601 weighs the channels, in codes of 255.
double luma(double red, double green, double blue) {
  return 255 * (0.299 * red + 0.587 * green + 0.114 * blue);
}

constexpr int reach = 5;

std::array<double, 2 * reach + 1> gaussian() {
  std::array<double, 2 * reach + 1> weights{};
  double sum = 0;
  int offset = -reach;
  for (double& weight : weights) {
    weight = std::exp(-offset * offset / (2 * 1.5 * 1.5));
    sum += weight;
    ++offset;
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

/// `value(x, y)` averaged about each pixel; beyond the edges, the edge again.
template <class Value>
Plane smoothed(int width, int height, Value value) {
  static const std::array<double, 2 * reach + 1> weights = gaussian();
  Plane rows(width, height);
  Plane result(width, height);
  for (int pass = 0; pass < 2; ++pass) {
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        double sum = 0;
        int offset = -reach;
        for (const double weight : weights) {
          sum += weight * (pass == 0 ? value(std::clamp(x + offset, 0, width - 1), y)
                                     : rows.row(std::clamp(y + offset, 0, height - 1))[x]);
          ++offset;
        }
        (pass == 0 ? rows : result).row(y)[x] = sum;
      }
    }
  }
  return result;
}

/// The structural similarity of two planes in codes of 255, averaged over all pixels.
double similarity(const Plane& a, const Plane& b) {
  const int width = a.width();
  const int height = a.height();
  const auto mean_of = [&](const Plane& p, const Plane& q) {
    return smoothed(width, height, [&](int x, int y) { return p.row(y)[x] * q.row(y)[x]; });
  };
  const Plane ones(width, height, 1);
  const Plane mean_a = mean_of(a, ones);
  const Plane mean_b = mean_of(b, ones);
  const Plane aa = mean_of(a, a);
  const Plane bb = mean_of(b, b);
  const Plane ab = mean_of(a, b);
  constexpr double c1 = 0.01 * 255 * 0.01 * 255;
  constexpr double c2 = 0.03 * 255 * 0.03 * 255;
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const double ma = mean_a.pixels()[i];
    const double mb = mean_b.pixels()[i];
    const double variance = aa.pixels()[i] - ma * ma + bb.pixels()[i] - mb * mb;
    const double covariance = ab.pixels()[i] - ma * mb;
    sum +=
        (2 * ma * mb + c1) * (2 * covariance + c2) / ((ma * ma + mb * mb + c1) * (variance + c2));
  }
  return sum / static_cast<double>(a.pixels().size());
}

template <class Pixel, class LumaOf>
Plane luma_plane(const Image<Pixel>& picture, LumaOf luma_of) {
  Plane plane(picture.width(), picture.height());
  std::transform(picture.pixels().begin(), picture.pixels().end(), plane.pixels().begin(), luma_of);
  return plane;
}

template <class Scalar>
double true_luma(const Vector3<OracleNumber<Scalar>>& color) {
  return luma(static_cast<double>(color.x().value), static_cast<double>(color.y().value),
              static_cast<double>(color.z().value));
}

/// Both oracles' picture of what floats say.
Image<TrueColor> widened(const Image<Color>& picture) {
  Image<TrueColor> colors(picture.width(), picture.height(), TrueColor::black());
  std::transform(
      picture.pixels().begin(), picture.pixels().end(), colors.pixels().begin(),
      [](const Color& color) -> TrueColor {
        return {broadcast<OracleNumber<double>>(color), broadcast<OracleNumber<Quad>>(color)};
      });
  return colors;
}

}  // namespace

Errors picture_errors(const std::string& kind, const Image<TrueColor>& shown,
                      const Image<TrueColor>& truth) {
  MeasuredError codes;
  MeasuredError over;
  for (std::size_t i = 0; i < shown.pixels().size(); ++i) {
    const TrueColor& seen = shown.pixels()[i];
    const TrueColor& meant = truth.pixels()[i];
    double largest_double = 0;
    Quad largest_quad = 0;
    for (Eigen::Index c = 0; c < 3; ++c) {
      const double by_double = 255 * (seen.by_double[c].value - meant.by_double[c].value);
      const Quad by_quad = 255 * (seen.by_quad[c].value - meant.by_quad[c].value);
      codes.add(by_double, by_quad);
      largest_double = std::max(largest_double, std::abs(by_double));
      largest_quad = std::max(largest_quad, quad_abs(by_quad));
    }
    over.add(largest_double > 1 ? 100 : 0, largest_quad > 1 ? 100 : 0);
  }
  const auto similarity_by = [&](auto TrueColor::*oracle) {
    const auto luma_of = [oracle](const TrueColor& color) { return true_luma(color.*oracle); };
    return similarity(luma_plane(shown, luma_of), luma_plane(truth, luma_of));
  };
  const double rms = codes.root_mean_square();
  return {{kind + ": RMSE, codes", rms},
          {kind + ": largest, codes", codes.largest()},
          {kind + ": % of pixels over 1 code", over.mean()},
          {kind + ": PSNR, dB", 20 * std::log10(255 / rms)},
          {kind + ": SSIM",
           agreed(similarity_by(&TrueColor::by_double), Quad{similarity_by(&TrueColor::by_quad)})}};
}

Errors picture_errors(const std::string& kind, const Image<Color>& shown,
                      const Image<TrueColor>& truth) {
  return picture_errors(kind, widened(shown), truth);
}

Errors picture_errors(const std::string& kind, const Image<Rgb8>& shown, const Image<Rgb8>& truth) {
  return picture_errors(kind, widened(to_colors(shown)), widened(to_colors(truth)));
}

Image<Color> to_colors(const Image<Rgb8>& picture) {
  Image<Color> colors(picture.width(), picture.height());
  std::transform(picture.pixels().begin(), picture.pixels().end(), colors.pixels().begin(),
                 &to_color);
  return colors;
}

}  // namespace rasterlab::bench
