// Light and textures.
#include "common/lighting/blinn_phong.h"
#include "common/lighting/phong.h"
#include "common/texture/sample.h"

#include "tests/stress/family.h"

#include <cmath>
#include <limits>

namespace rasterlab::stress {
namespace {

__extension__ using Float128 = __float128;
using Limits = std::numeric_limits<float>;

/// The exponent, then normal, direction toward the light, direction toward the eye.
Numbers exponents(Random& random) {
  Numbers numbers = {random.chance(0.2) ? random.pick({0, 1, 2, 3, 1e6})
                                        : std::pow(10, random.number(0, 6))};
  for (int i = 0; i < 9; ++i) numbers.push_back(random.number(-1, 1));
  if (random.chance(0.5)) {  // near the highlight: the eye where the light is mirrored to
    const Eigen::Vector3d normal = Eigen::Vector3d(numbers[1], numbers[2], numbers[3]).normalized();
    const Eigen::Vector3d light(numbers[4], numbers[5], numbers[6]);
    const Eigen::Vector3d mirrored = 2 * normal.dot(light) * normal - light;
    for (std::size_t i = 0; i < 3; ++i) {
      numbers[7 + i] = mirrored[static_cast<Eigen::Index>(i)] + random.number(-1e-2, 1e-2);
    }
  }
  return numbers;
}

void check_highlight(const Numbers& n, Verdict& verdict) {
  if (!(n[0] >= 0)) return;
  const auto direction = [&](std::size_t i) -> Eigen::Vector3f {
    return Eigen::Vector3d(n[i], n[i + 1], n[i + 2]).normalized().cast<float>();
  };
  const Eigen::Vector3f normal = direction(1);
  const Eigen::Vector3f light = direction(4);
  const Eigen::Vector3f eye = direction(7);
  if (!normal.allFinite() || !light.allFinite() || !eye.allFinite()) return;
  Material material;
  material.shininess = static_cast<float>(n[0]);
  const auto reflection = phong<float>(normal, light, eye, Light{}, material);
  Float128 toward_light = 0;
  Float128 light_to_eye = 0;
  Float128 normal_to_eye = 0;
  for (int i = 0; i < 3; ++i) {
    toward_light += static_cast<Float128>(normal[i]) * light[i];
    light_to_eye += static_cast<Float128>(light[i]) * eye[i];
    normal_to_eye += static_cast<Float128>(normal[i]) * eye[i];
  }
  const auto base = static_cast<long double>(2 * toward_light * normal_to_eye - light_to_eye);
  const auto facing = static_cast<long double>(toward_light);
  if (std::abs(base) < 1e-6L || std::abs(facing) < 1e-6L) return;  // either side is right
  const long double exponent = material.shininess;
  const bool lit = base > 0 && facing > 0;
  const long double truth = lit ? std::pow(base, exponent) : 0;
  // The cosine is off by 3 · 2⁻²⁴ for each of the two scalar products, the first of them doubled,
  // and by 3 more for the vector between; raised to the exponent, that grows.
  constexpr long double off = 12 * 0x1p-24L;
  const long double steepest = std::pow(base + off, std::max(exponent - 1, 0.0L));
  const auto allowed = static_cast<double>(lit ? off * exponent * steepest + 1e-6L : 1e-30L);
  const long double scale = static_cast<long double>(material.specular) * Light{}.intensity;
  const auto found = static_cast<long double>(reflection.specular) / scale;
  const auto error = static_cast<double>(std::abs(found - truth));
  verdict.expect_error(error, allowed, [&] {
    return "the highlight is " + std::to_string(static_cast<double>(found)) + ", not " +
           std::to_string(static_cast<double>(truth));
  });
  verdict.expect(reflection.specular >= 0 && reflection.diffuse >= 0 && reflection.ambient >= 0,
                 [] { return "a part of the reflection is negative or no number"; });
}

double edge_coordinate(Random& random) {
  const double edge = random.pick(
      {0, -0.0, 1, 2, -1, 0.5, 0x1p23, 0x1p24, -0x1p24, 0x1p60, Limits::max(), Limits::infinity(),
       -Limits::infinity(), Limits::quiet_NaN(), Limits::denorm_min(), -Limits::denorm_min()});
  const auto near = static_cast<float>(edge);
  switch (random.whole(0, 3)) {
    case 0:
      return std::nextafterf(near, Limits::infinity());
    case 1:
      return std::nextafterf(near, -Limits::infinity());
    case 2:
      return random.number(-4, 4);
    default:
      return edge;
  }
}

Numbers wrapped_coordinates(Random& random) {
  Numbers numbers;
  for (int i = 0; i < 64; ++i) numbers.push_back(edge_coordinate(random));
  return numbers;
}

/// What wrap.h says, in extended precision.
long double wrapped(long double u, Wrap wrap) {
  if (u >= 0 && u <= 1) return u;
  if (std::isnan(u)) return 0;
  if (wrap == Wrap::clamp) return u < 0 ? 0 : 1;
  if (std::isinf(u)) return 0;
  if (wrap == Wrap::repeat) return u - std::floor(u);
  const long double in_period = u - 2 * std::floor(u / 2);
  return in_period > 1 ? 2 - in_period : in_period;
}

void check_wrap(const Numbers& numbers, Verdict& verdict) {
  for (const double number : numbers) {
    const auto u = static_cast<float>(number);
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror}) {
      const float found = wrap_coordinate(u, wrap);
      const auto wanted = static_cast<float>(wrapped(u, wrap));
      verdict.expect(std::abs(found - wanted) <= 0x1p-24F, [&] {
        return std::to_string(u) + " wraps to " + std::to_string(found) + ", not " +
               std::to_string(wanted);
      });
    }
  }
}

/// The texture's sides and its seed, then footprints: u, v, and the exponents and signs of the four
/// derivatives.
Numbers footprints(Random& random) {
  Numbers numbers = {random.pick({1, 1, 2, 3, 7, 64, 8192}), random.pick({1, 1, 2, 5, 16}),
                     static_cast<double>(random.whole(0, 1000)), random.chance(0.5) ? 1.0 : 0.0};
  for (int i = 0; i < 24; ++i) {
    numbers.push_back(edge_coordinate(random));
    numbers.push_back(edge_coordinate(random));
    const double whole = random.pick({0, 0x1p-100, 0x1p100, 1e-3, 1e-2, 1});
    for (int k = 0; k < 4; ++k) {
      numbers.push_back(random.chance(0.3)
                            ? random.pick({0, 0x1p-100, -0x1p100, Limits::quiet_NaN()})
                            : whole * random.number(-1, 1));
    }
  }
  return numbers;
}

Image<Rgb8> noise(int width, int height, std::uint64_t seed) {
  Random random({seed});
  Image<Rgb8> image(width, height);
  for (Rgb8& pixel : image.pixels()) {
    const auto grey = static_cast<std::uint8_t>(random.whole(60, 180));
    pixel = {grey, static_cast<std::uint8_t>(255 - grey), 100};
  }
  return image;
}

void check_samples(const Numbers& n, Verdict& verdict) {
  if (n.size() < 4) return;
  const auto side = [](double number) { return static_cast<int>(std::clamp(number, 1.0, 8192.0)); };
  const int width = side(n[3] != 0 ? n[0] : n[1]);
  const int height = side(n[3] != 0 ? n[1] : n[0]);
  const Texture texture(noise(width, height, static_cast<std::uint64_t>(std::abs(n[2]))));
  for (std::size_t i = 4; i + 6 <= n.size(); i += 6) {
    const auto number = [&](std::size_t k) { return static_cast<float>(n[i + k]); };
    const Footprint<float> footprint = {
        {number(0), number(1)}, {number(2), number(3)}, {number(4), number(5)}};
    const float level = mip_level(texture, footprint);
    verdict.expect(level >= 0 && level <= static_cast<float>(texture.level_count() - 1),
                   [&] { return "mip level " + std::to_string(level); });
    for (const Filter filter : {Filter::nearest, Filter::bilinear, Filter::mip_mapped,
                                Filter::trilinear, Filter::anisotropic}) {
      for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror}) {
        const Vector3<float> color = sample<float>({&texture, filter, wrap}, footprint);
        // A mean of texels lies between them; levels are rounded to 8 bits.
        const bool between = color.x() * 255 >= 59.4F && color.x() * 255 <= 180.6F &&
                             color.y() * 255 >= 74.4F && color.y() * 255 <= 195.6F &&
                             std::abs(color.z() * 255 - 100) <= 0.01F;
        verdict.expect(between, [&] {
          return "filter " + std::to_string(static_cast<int>(filter)) + " gives (" +
                 std::to_string(color.x() * 255) + ", " + std::to_string(color.y() * 255) + ", " +
                 std::to_string(color.z() * 255) + "), which lies between no texels";
        });
      }
    }
  }
}

/// A footprint without anything odd: u, v and derivatives.
Numbers mip_levels(Random& random) {
  Numbers numbers;
  for (int i = 0; i < 64; ++i) {
    const double size = std::pow(2, random.number(-12, 3));
    for (int k = 0; k < 4; ++k) numbers.push_back(size * random.number(-1, 1));
  }
  return numbers;
}

void check_levels(const Numbers& numbers, Verdict& verdict) {
  static const Texture texture(noise(512, 64, 1));
  for (std::size_t i = 0; i + 4 <= numbers.size(); i += 4) {
    const auto number = [&](std::size_t k) { return static_cast<float>(numbers[i + k]); };
    const Footprint<float> footprint = {
        {0.5F, 0.5F}, {number(0), number(1)}, {number(2), number(3)}};
    const auto squared = [&](std::size_t k) {
      const Float128 u = static_cast<Float128>(number(k)) * texture.width();
      const Float128 v = static_cast<Float128>(number(k + 1)) * texture.height();
      return static_cast<long double>(u * u + v * v);
    };
    const long double longer = std::max(squared(0), squared(2));
    const long double truth = std::clamp(std::log2(longer) / 2, 0.0L,
                                         static_cast<long double>(texture.level_count() - 1));
    const auto error = static_cast<double>(std::abs(mip_level(texture, footprint) - truth));
    verdict.expect_error(error, 2e-6, [&] { return "a level is off by " + std::to_string(error); });
  }
}

}  // namespace

std::vector<Family> shading_families() {
  return {
      many_at_once("exponents",
                   "highlights with exponents 0 … 1e6 are what the rounding of one cosine allows, "
                   "never negative and never behind",
                   10, 128, exponents, check_highlight),
      {"wrapping", "u at every edge and special float wraps to what wrap.h says, within 2⁻²⁴", 1, 0,
       wrapped_coordinates, check_wrap},
      {"footprints",
       "whatever the footprint and the texture's sides, 1 × 1 to 1 × 8192, each filter gives a "
       "mean "
       "of texels",
       6, 4, footprints, check_samples},
      {"mip_levels", "a level follows from the exact derivatives, within 2e-6", 4, 0, mip_levels,
       check_levels},
  };
}

}  // namespace rasterlab::stress
