#include "tests/oracle/texturing.h"

#include <algorithm>
#include <cmath>

namespace rasterlab::oracle {

namespace {

using Level = DeepTexture::Level;

const Eigen::Vector3d& texel(const Level& level, int column, int row) {
  return level.texels[static_cast<std::size_t>(row * level.width + column)];
}

/// How much of [cell, cell + 1] lies in [from, to].
double overlap(int cell, double from, double to) {
  return std::max(0.0, std::min(cell + 1.0, to) - std::max<double>(cell, from));
}

/// The mean of a level over a rectangle, in texels.
Eigen::Vector3d mean(const Level& level, double left, double right, double bottom, double top) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int row = static_cast<int>(bottom); row < std::min<double>(level.height, std::ceil(top));
       ++row) {
    for (int column = static_cast<int>(left);
         column < std::min<double>(level.width, std::ceil(right)); ++column) {
      sum += overlap(column, left, right) * overlap(row, bottom, top) * texel(level, column, row);
    }
  }
  return sum / ((right - left) * (top - bottom));
}

Level half_of(const Level& level) {
  Level half{std::max(1, level.width / 2), std::max(1, level.height / 2), {}};
  const double x = static_cast<double>(level.width) / half.width;
  const double y = static_cast<double>(level.height) / half.height;
  for (int row = 0; row < half.height; ++row) {
    for (int column = 0; column < half.width; ++column) {
      half.texels.push_back(mean(level, column * x, (column + 1) * x, row * y, (row + 1) * y));
    }
  }
  return half;
}

/// [0, 1] is the texture; outside, OpenGL's modes.
double wrapped(double coordinate, const std::string& wrap) {
  if (coordinate >= 0 && coordinate <= 1) return coordinate;
  if (wrap == "clamp") return std::clamp(coordinate, 0.0, 1.0);
  if (wrap == "repeat") return coordinate - std::floor(coordinate);
  const double in_period = coordinate - 2 * std::floor(coordinate / 2);
  return in_period <= 1 ? in_period : 2 - in_period;
}

int neighbor(int index, int size, const std::string& wrap) {
  if (wrap == "repeat") return (index + size) % size;
  return std::clamp(index, 0, size - 1);
}

Shade nearest(const DeepTexture& texture, const std::string& wrap, const Eigen::Vector2d& uv) {
  const Level& level = texture.levels().front();
  const int column =
      std::min(static_cast<int>(wrapped(uv.x(), wrap) * level.width), level.width - 1);
  const int row =
      std::min(static_cast<int>(wrapped(uv.y(), wrap) * level.height), level.height - 1);
  return {texel(level, column, row), {column, row}};
}

Eigen::Vector3d bilinear(const Level& level, const std::string& wrap, const Eigen::Vector2d& uv) {
  const double x = wrapped(uv.x(), wrap) * level.width - 0.5;
  const double y = wrapped(uv.y(), wrap) * level.height - 0.5;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int right : {0, 1}) {
    for (const int up : {0, 1}) {
      const int column = static_cast<int>(std::floor(x)) + right;
      const int row = static_cast<int>(std::floor(y)) + up;
      const double weight = (1 - std::abs(x - column)) * (1 - std::abs(y - row));
      sum += weight *
             texel(level, neighbor(column, level.width, wrap), neighbor(row, level.height, wrap));
    }
  }
  return sum;
}

Eigen::Vector3d trilinear(const DeepTexture& texture, const std::string& wrap,
                          const Eigen::Vector2d& uv, double level) {
  const int last = static_cast<int>(texture.levels().size()) - 1;
  const double clamped = std::clamp<double>(level, 0, last);
  const int fine = static_cast<int>(clamped);
  const int coarse = std::min(fine + 1, last);
  const double part = clamped - fine;
  const auto read = [&](int index) {
    return bilinear(texture.levels()[static_cast<std::size_t>(index)], wrap, uv);
  };
  return (1 - part) * read(fine) + part * read(coarse);
}

/// The footprint's Jacobian in texels of level 0.
Eigen::Matrix2d jacobian(const DeepTexture& texture, const Steps& steps) {
  const Level& level = texture.levels().front();
  Eigen::Matrix2d matrix;
  matrix << steps.dx, steps.dy;
  return Eigen::Vector2d(level.width, level.height).asDiagonal() * matrix;
}

/// Snapping moves a triangle's corners by up to 1/512 px, which changes the derivatives of one that
/// is a few pixels large by so much of themselves.
constexpr double derivative_doubt = 0.01;

/// Samples along the ellipse's longer axis; its axes are the Jacobian's singular vectors.
Shade anisotropic(const DeepTexture& texture, const std::string& wrap, const Steps& steps) {
  const Level& base = texture.levels().front();
  const Eigen::JacobiSVD<Eigen::Matrix2d> svd(jacobian(texture, steps), Eigen::ComputeFullU);
  const double longer = svd.singularValues()[0];
  const double shorter = svd.singularValues()[1];
  const double wanted = longer / std::max(shorter, 1.0);
  const auto count_of = [](double ratio) {
    return static_cast<int>(std::clamp(std::ceil(ratio - 1.0 / 64), 1.0, 16.0));
  };
  const int count = count_of(wanted);
  const Eigen::Vector2d axis =
      (svd.matrixU().col(0) * longer).cwiseQuotient(Eigen::Vector2d(base.width, base.height));
  const double level = std::log2(std::max({shorter, longer / 16, 1.0}));
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < count; ++i) {
    sum += trilinear(texture, wrap, steps.uv + ((i + 0.5) / count - 0.5) * axis, level);
  }
  const bool at_jump =
      count_of(wanted * (1 - derivative_doubt)) != count_of(wanted * (1 + derivative_doubt));
  return {sum / count, {count}, at_jump};
}

}  // namespace

DeepTexture::DeepTexture(const Image<Rgb8>& image) {
  Level base{image.width(), image.height(), {}};
  for (int y = image.height() - 1; y >= 0; --y) {
    for (int x = 0; x < image.width(); ++x) {
      const Rgb8 pixel = image(x, y);
      base.texels.emplace_back(Eigen::Vector3d(pixel.r, pixel.g, pixel.b) / 255);
    }
  }
  levels_.push_back(base);
  Level exact = base;
  while (exact.width > 1 || exact.height > 1) {
    exact = half_of(exact);
    levels_.push_back(exact);
    for (Eigen::Vector3d& texel : levels_.back().texels) {
      // A trifle for sums that are not quite the half they stand for.
      texel = (texel.array() * 255 + (0.5 + 1e-9)).floor() / 255;
    }
  }
}

Shade sample(const DeepTexture& texture, const std::string& filter, const std::string& wrap,
             const Steps& steps) {
  if (filter == "nearest") return nearest(texture, wrap, steps.uv);
  if (filter == "bilinear") return {bilinear(texture.levels().front(), wrap, steps.uv)};
  if (filter == "anisotropic") return anisotropic(texture, wrap, steps);
  const Eigen::Matrix2d footprint = jacobian(texture, steps);
  const double level = std::log2(std::max(footprint.colwise().norm().maxCoeff(), 1.0));
  if (filter == "trilinear") return {trilinear(texture, wrap, steps.uv, level)};
  const auto nearest_level = [&](double fractional) {
    return std::min(std::lround(fractional), static_cast<long>(texture.levels().size()) - 1);
  };
  const long whole = nearest_level(level);
  const bool at_jump =
      nearest_level(level - derivative_doubt) != nearest_level(level + derivative_doubt);
  return {bilinear(texture.levels()[static_cast<std::size_t>(whole)], wrap, steps.uv),
          {whole},
          at_jump};
}

Steps steps_at(const RayCaster& witness, const Surface& surface, double x, double y,
               const Hit& hit) {
  constexpr double step = 1e-4;
  const auto uv = [&](double at_x, double at_y) {
    return surface.texture_coordinates(witness.drawn_plane(at_x, at_y, hit.face, hit.snapping));
  };
  return {uv(x, y), (uv(x + step, y) - uv(x - step, y)) / (2 * step),
          (uv(x, y + step) - uv(x, y - step)) / (2 * step)};
}

}  // namespace rasterlab::oracle
