#include "common/texture/sample.h"
#include "common/texture/texture_pair.h"

#include "tests/stage06/noise.h"
#include "tests/stage06/quad.h"
#include "tests/support/toy_lanes.h"

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <Eigen/SVD>
#include <gmock/gmock.h>

namespace rasterlab {
namespace {

const std::vector<Wrap> all_wraps = {Wrap::repeat, Wrap::clamp, Wrap::mirror};

Footprint<float> random_footprint(std::mt19937& random, float range, float step) {
  std::uniform_real_distribution<float> place(-range, range);
  std::uniform_real_distribution<float> change(-step, step);
  return {{place(random), place(random)},
          {change(random), change(random)},
          {change(random), change(random)}};
}

int wrapped_index(int index, int size, Wrap wrap) {
  if (wrap == Wrap::repeat) return ((index % size) + size) % size;
  if (wrap == Wrap::clamp) return std::clamp(index, 0, size - 1);
  const int in_period = ((index % (2 * size)) + 2 * size) % (2 * size);
  return in_period < size ? in_period : 2 * size - 1 - in_period;
}

/// The red channel, bilinear, in exact arithmetic over the texture continued without end.
Quad bilinear_red(const Image<Rgb8>& image, float u, float v, Wrap wrap) {
  const Quad x = static_cast<Quad>(u) * image.width() - static_cast<Quad>(0.5);
  const Quad y = static_cast<Quad>(v) * image.height() - static_cast<Quad>(0.5);
  const int column = static_cast<int>(quad_floor(x));
  const int row = static_cast<int>(quad_floor(y));
  const Quad across = x - column;
  const Quad up = y - row;
  const auto red = [&](int i, int j) {
    const int from_top = image.height() - 1 - wrapped_index(j, image.height(), wrap);
    return static_cast<Quad>(image(wrapped_index(i, image.width(), wrap), from_top).r);
  };
  return ((1 - up) * ((1 - across) * red(column, row) + across * red(column + 1, row)) +
          up * ((1 - across) * red(column, row + 1) + across * red(column + 1, row + 1))) /
         255;
}

TEST(stage06_sample_nearest, gives_the_texel_the_point_is_in) {
  const Image<Rgb8> image = noise(7, 5, 3);
  const Texture texture(image);
  std::mt19937 random(4);
  for (const Wrap wrap : all_wraps) {
    for (int i = 0; i < 5000; ++i) {
      const auto footprint = random_footprint(random, 3, 1);
      const Quad x = static_cast<Quad>(footprint.uv.x()) * 7;
      const Quad y = static_cast<Quad>(footprint.uv.y()) * 5;
      const int column = static_cast<int>(quad_floor(x));
      const int row = static_cast<int>(quad_floor(y));
      // A float's rounding may carry a point over an edge that is nearer than this.
      const auto near_edge = [](Quad position, int floor) {
        const Quad part = position - floor;
        return part < 1e-5 || part > 1 - 1e-5;
      };
      if (near_edge(x, column) || near_edge(y, row)) continue;
      EXPECT_EQ(to_rgb8(sample_nearest(texture, wrap, footprint)),
                image(wrapped_index(column, 7, wrap), 4 - wrapped_index(row, 5, wrap)))
          << footprint.uv.transpose();
    }
  }
}

TEST(stage06_sample_nearest, whatever_the_coordinate_some_texel_answers) {
  const Texture texture(noise(3, 4, 1));
  const float values[] = {std::numeric_limits<float>::quiet_NaN(),
                          std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity(),
                          std::numeric_limits<float>::max(),
                          std::numeric_limits<float>::denorm_min(),
                          -std::numeric_limits<float>::denorm_min(),
                          0x1p24F,
                          -0.0F,
                          1.0F,
                          std::nextafter(1.0F, 2.0F)};
  for (const FilterRung& rung : filter_ladder()) {
    for (const Wrap wrap : all_wraps) {
      for (const float u : values) {
        for (const float v : values) {
          for (const float step : values) {
            const auto color = sample(Sampler{&texture, rung.filter, wrap},
                                      Footprint<float>{{u, v}, {step, 0}, {u, step}});
            EXPECT_TRUE((color.array() >= 0).all() && (color.array() <= 1).all())
                << rung.name << " at " << u << ", " << v << " step " << step;
          }
        }
      }
    }
  }
}

TEST(stage06_sample_bilinear, agrees_with_exact_arithmetic) {
  const Image<Rgb8> image = noise(7, 5, 5);
  const Texture texture(image);
  std::mt19937 random(6);
  for (const Wrap wrap : all_wraps) {
    for (int i = 0; i < 20000; ++i) {
      const auto footprint = random_footprint(random, 2, 1);
      EXPECT_LE(difference(sample_bilinear(texture, wrap, footprint).x(),
                           bilinear_red(image, footprint.uv.x(), footprint.uv.y(), wrap)),
                4e-6)
          << footprint.uv.transpose();
    }
  }
}

TEST(stage06_sample_bilinear, gives_back_every_code_and_white_as_1) {
  for (int code = 0; code < 256; ++code) {
    const auto byte = static_cast<std::uint8_t>(code);
    const Texture texture(Image<Rgb8>(2, 2, {byte, byte, byte}));
    const Footprint<float> anywhere = {{0.3F, 0.6F}, {0, 0}, {0, 0}};
    const float value = sample_bilinear(texture, Wrap::repeat, anywhere).x();
    EXPECT_NEAR(value, static_cast<float>(code) / 255, 1.2e-7 * value);
    EXPECT_EQ(to_byte(value), byte);
    EXPECT_EQ(value == 1, code == 255);
  }
}

TEST(stage06_sample_bilinear, at_a_texels_centre_it_is_that_texel) {
  const Image<Rgb8> image = noise(8, 4, 7);
  const Texture texture(image);
  for (const Wrap wrap : all_wraps) {
    for (int y = 0; y < 4; ++y) {
      for (int x = 0; x < 8; ++x) {
        const Vector2<float> uv((static_cast<float>(x) + 0.5F) / 8,
                                (static_cast<float>(3 - y) + 0.5F) / 4);
        EXPECT_EQ(to_rgb8(sample_bilinear(texture, wrap, Footprint<float>{uv, {0, 0}, {0, 0}})),
                  image(x, y));
      }
    }
  }
}

// On the border, half of the colour comes from beyond it.
TEST(stage06_sample_bilinear, at_the_border) {
  Image<Rgb8> image(2, 1);
  image(0, 0) = {0, 0, 0};
  image(1, 0) = {255, 0, 0};
  const Texture texture(image);
  const auto red = [&](float u, Wrap wrap) {
    return sample_bilinear(texture, wrap, Footprint<float>{{u, 0.5F}, {0, 0}, {0, 0}}).x();
  };
  EXPECT_EQ(red(0, Wrap::repeat), 0.5F);
  EXPECT_EQ(red(1, Wrap::repeat), 0.5F);
  EXPECT_EQ(red(0, Wrap::clamp), 0);
  EXPECT_EQ(red(1, Wrap::clamp), 1);
  EXPECT_EQ(red(0, Wrap::mirror), 0);
  EXPECT_EQ(red(1, Wrap::mirror), 1);
  EXPECT_EQ(red(-5, Wrap::clamp), 0);
  EXPECT_EQ(red(7, Wrap::clamp), 1);
}

TEST(stage06_mip_level, follows_from_exact_derivatives) {
  const Texture texture(Image<Rgb8>(256, 64));
  const auto level = [&](const Vector2<float>& dx, const Vector2<float>& dy) {
    return mip_level(texture, Footprint<float>{{0.3F, 0.3F}, dx, dy});
  };
  EXPECT_EQ(level({0, 0}, {0, 0}), 0) << "a constant (u, v)";
  EXPECT_EQ(level({1.0F / 256, 0}, {0, 1.0F / 64}), 0) << "a texel a pixel";
  EXPECT_EQ(level({1.0F / 512, 0}, {0, 1.0F / 128}), 0) << "magnified";
  EXPECT_EQ(level({2.0F / 256, 0}, {0, 2.0F / 64}), 1);
  EXPECT_EQ(level({0, 8.0F / 64}, {0, 0}), 3) << "v has fewer texels";
  EXPECT_EQ(level({0, 0}, {0, 0.125F}), 3) << "the longer step counts";
  EXPECT_NEAR(level({3.0F / 256, 0}, {0, 0}), std::log2(3.0), 1e-6);
  EXPECT_EQ(level({3.0F / 256, 4.0F / 64}, {0, 0}), static_cast<float>(std::log2(5.0)));
  EXPECT_EQ(level({100, 0}, {0, 0}), 8) << "the last level";
  EXPECT_EQ(level({std::numeric_limits<float>::max(), 0}, {0, 0}), 8);
  EXPECT_EQ(level({std::numeric_limits<float>::infinity(), 0}, {0, 0}), 8);
  EXPECT_EQ(level({std::numeric_limits<float>::quiet_NaN(), 0}, {0, 0}), 0);
}

TEST(stage06_sample_mip_mapped, reads_the_nearest_level) {
  Image<Rgb8> image(8, 8);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x)
      image(x, y) = (x + y) % 2 == 0 ? Rgb8{255, 255, 255} : Rgb8{0, 0, 0};
  }
  const Texture texture(image);
  const Vector2<float> center(0.0625F, 0.0625F);  // the lower left texel, which is black
  const auto red = [&](float texels) {
    return sample_mip_mapped(texture, Wrap::repeat,
                             Footprint<float>{center, {texels / 8, 0}, {0, texels / 8}})
        .x();
  };
  EXPECT_EQ(red(1), 0);
  EXPECT_EQ(red(1.41F), 0) << "below the square root of 2 level 0 is nearer";
  EXPECT_NEAR(red(1.42F), 0.5, 0.003) << "above it level 1, where all is grey";
}

TEST(stage06_sample_trilinear, blends_the_two_levels_about_its_own) {
  const Texture texture(noise(16, 16, 8));
  std::mt19937 random(9);
  for (int i = 0; i < 2000; ++i) {
    const auto footprint = random_footprint(random, 2, 1);
    const float level = mip_level(texture, footprint);
    const float finer = std::floor(level);
    const Eigen::Vector3d fine =
        bilinear_in_level(texture, Wrap::mirror, footprint.uv, finer).cast<double>();
    const Eigen::Vector3d coarse =
        bilinear_in_level(texture, Wrap::mirror, footprint.uv, std::min(finer + 1, 4.0F))
            .cast<double>();
    const double part = level - finer;
    const Eigen::Vector3d expected = (1 - part) * fine + part * coarse;
    EXPECT_LE((sample_trilinear(texture, Wrap::mirror, footprint).cast<double>() - expected).norm(),
              1e-6);
  }
}

TEST(stage06_sample_trilinear, of_a_pair_is_that_of_each) {
  const Texture one(noise(16, 12, 16));
  const Texture other(noise(16, 12, 17));
  const TexturePair pair(one, other);
  std::mt19937 random(18);
  for (const Wrap wrap : all_wraps) {
    for (int i = 0; i < 2000; ++i) {
      // Magnified ones, and minified beyond the last level.
      const auto footprint = random_footprint(random, 2, i % 2 == 0 ? 0.1F : 2.0F);
      const auto colors = sample_trilinear(pair, wrap, footprint);
      ASSERT_LE((colors.one - sample_trilinear(one, wrap, footprint)).norm(), 1e-6F);
      ASSERT_LE((colors.other - sample_trilinear(other, wrap, footprint)).norm(), 1e-6F);
    }
  }
  EXPECT_THROW(TexturePair(one, Texture(noise(12, 16, 17))), CheckError);
  EXPECT_THROW(TexturePair(one, Texture(noise(16, 12, 17), MipLevels::none)), CheckError);
}

TEST(stage06_sample_anisotropic, the_ellipse_has_the_singular_values_of_the_derivatives) {
  const Texture texture(Image<Rgb8>(64, 16));
  std::mt19937 random(10);
  for (int i = 0; i < 5000; ++i) {
    const auto footprint = random_footprint(random, 1, i % 2 == 0 ? 1.0F : 1e-3F);
    Eigen::Matrix2d jacobian;
    jacobian << footprint.dx.x() * 64.0, footprint.dy.x() * 64.0, footprint.dx.y() * 16.0,
        footprint.dy.y() * 16.0;
    const Eigen::JacobiSVD<Eigen::Matrix2d> svd(jacobian, Eigen::ComputeFullU);
    const auto ellipse = footprint_ellipse(texture, footprint);
    const double longer = svd.singularValues()[0];
    EXPECT_NEAR(ellipse.longer, longer, 2e-6 * longer);
    EXPECT_NEAR(ellipse.shorter, svd.singularValues()[1], 2e-6 * longer);
    const Eigen::Vector2d axis(ellipse.axis.x() * 64.0, ellipse.axis.y() * 16.0);
    const double away = std::fabs(axis.dot(svd.matrixU().col(1)));
    EXPECT_LE(away * (longer - svd.singularValues()[1]), 1e-5 * longer * longer);
  }
}

TEST(stage06_sample_anisotropic, degenerate_footprints) {
  const Texture texture(noise(16, 16, 2));
  const Vector2<float> uv(0.3F, 0.7F);
  const auto color = [&](const Vector2<float>& dx, const Vector2<float>& dy) {
    return sample_anisotropic(texture, Wrap::repeat, Footprint<float>{uv, dx, dy});
  };
  const auto point = sample_bilinear(texture, Wrap::repeat, Footprint<float>{uv, {0, 0}, {0, 0}});
  EXPECT_EQ(color({0, 0}, {0, 0}), point) << "a constant (u, v)";
  EXPECT_EQ(color({1 / 16.0F, 0}, {0, 1 / 16.0F}), point) << "a texel a pixel";
  const float quarter = 0.25F;
  const auto round = color({quarter, 0}, {0, quarter});
  const auto trilinear =
      sample_trilinear(texture, Wrap::repeat, Footprint<float>{uv, {quarter, 0}, {0, quarter}});
  EXPECT_EQ(round, trilinear) << "a circle needs one sample";
  const auto line = color({0.5F, 0}, {0, 0});
  const auto line_down = color({0, 0}, {0.5F, 0});
  EXPECT_EQ(line, line_down) << "either step may be the longer";
}

// A nearly round footprint must be read at its own level, not a finer one.
TEST(stage06_sample_anisotropic, does_not_jump_where_a_sample_is_added) {
  const Texture texture(noise(64, 64, 2));
  const Vector2<float> uv(0.31F, 0.7F);
  const auto color = [&](float ratio) {
    return sample_anisotropic(texture, Wrap::repeat,
                              Footprint<float>{uv, {ratio / 16, 0}, {0, 1.0F / 16}});
  };
  for (const float whole : {1.0F, 2.0F, 3.0F}) {
    const float ratio = whole + 1.0F / 64;
    // A sample more moves the samples by at most a quarter of a texel of the level they are in.
    EXPECT_LE((color(ratio * 0.9999F) - color(ratio * 1.0001F)).norm(), 0.1F) << ratio;
  }
}

// However it is turned, a square of 5.3 texels is round: rounding must not make it take two.
TEST(stage06_sample_anisotropic, a_turned_square_takes_one_sample) {
  const Texture texture(noise(64, 64, 5));
  constexpr float side = 5.3F / 64;
  for (int i = 0; i < 2000; ++i) {
    const float angle = static_cast<float>(i) * 0.01F;
    const Vector2<float> dx(side * std::cos(angle), side * std::sin(angle));
    const Footprint<float> footprint{{0.31F, 0.7F}, dx, {-dx.y(), dx.x()}};
    const float difference = (sample_anisotropic(texture, Wrap::repeat, footprint) -
                              sample_trilinear(texture, Wrap::repeat, footprint))
                                 .norm();
    ASSERT_LE(difference, 1e-5F) << "turned by " << angle;
  }
}

TEST(stage06_sample_anisotropic, is_nearer_to_the_mean_over_a_long_footprint) {
  const Texture texture(noise(256, 256, 3));
  std::mt19937 random(4);
  double anisotropic_error = 0;
  double trilinear_error = 0;
  for (int i = 0; i < 200; ++i) {
    Footprint<float> footprint = random_footprint(random, 1, 1);
    const float angle = static_cast<float>(i) * 0.1F;
    footprint.dx = Vector2<float>(std::cos(angle), std::sin(angle)) * (12.0F / 256);
    footprint.dy = Vector2<float>(-std::sin(angle), std::cos(angle)) * (1.0F / 256);
    Eigen::Vector3f mean = Eigen::Vector3f::Zero();
    constexpr int steps = 64;
    for (int s = 0; s < steps; ++s) {
      for (int t = 0; t < steps; ++t) {
        const auto offset = [](int k) {
          return (static_cast<float>(k) + 0.5F) / static_cast<float>(steps) - 0.5F;
        };
        mean += sample_nearest(
            texture, Wrap::repeat,
            Footprint<float>{footprint.uv + footprint.dx * offset(s) + footprint.dy * offset(t),
                             {0, 0},
                             {0, 0}});
      }
    }
    mean /= steps * steps;
    anisotropic_error += (sample_anisotropic(texture, Wrap::repeat, footprint) - mean).norm();
    trilinear_error += (sample_trilinear(texture, Wrap::repeat, footprint) - mean).norm();
  }
  EXPECT_LT(anisotropic_error, 0.5 * trilinear_error);
}

TEST(stage06_filter_ladder, a_texture_of_one_colour_stays_that_colour) {
  const Rgb8 colour{37, 201, 118};
  const Texture texture(Image<Rgb8>(13, 6, colour));
  std::mt19937 random(11);
  for (const FilterRung& rung : filter_ladder()) {
    for (const Wrap wrap : all_wraps) {
      for (int i = 0; i < 1000; ++i) {
        const Color sampled =
            sample(Sampler{&texture, rung.filter, wrap}, random_footprint(random, 3, 2));
        EXPECT_EQ(to_rgb8(sampled), colour) << rung.name;
        EXPECT_LE((sampled - to_color(colour)).norm(), 2e-7F) << rung.name;
      }
    }
  }
}

TEST(stage06_filter_ladder, rungs_read_as_many_texels_as_they_say) {
  const Texture texture(noise(64, 64, 12));
  std::mt19937 random(13);
  const std::vector<int> most = {1, 4, 4, 8, 128};
  for (std::size_t rung = 0; rung < filter_ladder().size(); ++rung) {
    int highest = 0;
    for (int i = 0; i < 2000; ++i) {
      const auto plain = random_footprint(random, 1, 1);
      const Footprint<ToyLanes<1>> footprint{{plain.uv.x(), plain.uv.y()},
                                             {plain.dx.x(), plain.dx.y()},
                                             {plain.dy.x() * 1e-3F, plain.dy.y() * 1e-3F}};
      toy_texel_reads = 0;
      sample(Sampler{&texture, filter_ladder()[rung].filter, Wrap::repeat}, footprint);
      highest = std::max(highest, toy_texel_reads);
    }
    EXPECT_EQ(highest, most[rung]) << filter_ladder()[rung].name;
  }
}

TEST(stage06_filter_ladder, lanes_equal_one_float) {
  const Texture texture(noise(37, 20, 14));
  std::mt19937 random(15);
  for (const FilterRung& rung : filter_ladder()) {
    for (const Wrap wrap : all_wraps) {
      const Sampler sampler{&texture, rung.filter, wrap};
      for (int i = 0; i < 500; ++i) {
        std::array<Footprint<float>, 4> plain;
        Footprint<ToyLanes<4>> wide;
        for (std::size_t lane = 0; lane < 4; ++lane) {
          // Lanes with near and far footprints side by side.
          plain[lane] = random_footprint(random, 2, lane % 2 == 0 ? 0.5F : 0.01F);
          for (int axis = 0; axis < 2; ++axis) {
            wide.uv[axis].lane[lane] = plain[lane].uv[axis];
            wide.dx[axis].lane[lane] = plain[lane].dx[axis];
            wide.dy[axis].lane[lane] = plain[lane].dy[axis];
          }
        }
        const auto colors = sample(sampler, wide);
        for (std::size_t lane = 0; lane < 4; ++lane) {
          const Color one = sample(sampler, plain[lane]);
          for (int channel = 0; channel < 3; ++channel) {
            ASSERT_EQ(colors[channel].lane[lane], one[channel]) << rung.name << " lane " << lane;
          }
        }
      }
    }
  }
}

TEST(stage06_filter_ladder, names) {
  EXPECT_EQ(filter_named("nearest"), Filter::nearest);
  EXPECT_EQ(filter_named("anisotropic"), Filter::anisotropic);
  EXPECT_EQ(wrap_named("mirror"), Wrap::mirror);
  try {
    filter_named("linear");
    FAIL() << "no such filter";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "no filter is called 'linear': expected one of nearest, bilinear, mip-mapped, "
                 "trilinear, anisotropic");
  }
}

}  // namespace
}  // namespace rasterlab
