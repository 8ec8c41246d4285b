#include "bench/projection/normals.h"

#include "common/projection/normal_matrix.h"

#include "bench/support/quad.h"
#include "bench/support/random_number.h"

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Dense>

namespace rasterlab::bench {
namespace {

constexpr std::size_t normals_a_matrix = 16;

struct Case {
  Eigen::Matrix4f matrix;
  std::array<Eigen::Vector3f, normals_a_matrix> normals;
};

std::vector<Case> make_cases(double unevenness) {
  std::mt19937 random(13);
  const auto any_rotation = [&random]() -> Eigen::Matrix3d {
    return Eigen::Quaterniond(random_number(random, -1, 1), random_number(random, -1, 1),
                              random_number(random, -1, 1), random_number(random, -1, 1))
        .normalized()
        .toRotationMatrix();
  };
  std::vector<Case> cases(256);
  for (Case& one : cases) {
    const Eigen::Vector3d scales(1, std::pow(unevenness, random_number(random, 0, 1)), unevenness);
    const Eigen::Matrix3d block = any_rotation() * scales.asDiagonal() * any_rotation();
    one.matrix.setIdentity();
    one.matrix.topLeftCorner<3, 3>() = block.cast<float>();
    for (Eigen::Vector3f& normal : one.normals) {
      normal = Eigen::Vector3d(random_number(random, -1, 1), random_number(random, -1, 1),
                               random_number(random, -1, 1))
                   .normalized()
                   .cast<float>();
    }
  }
  return cases;
}

template <class Number>
using Direction = std::array<Number, 3>;

/// Cofactors times normal: up to length, where the normal goes.
template <class Number>
Direction<Number> moved(const Eigen::Matrix4f& m, const Eigen::Vector3f& normal) {
  Direction<Number> result{};
  Number determinant = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const auto at = [&m](int row, int column) { return Number{m(row % 3, column % 3)}; };
      const Number cofactor =
          at(i + 1, j + 1) * at(i + 2, j + 2) - at(i + 1, j + 2) * at(i + 2, j + 1);
      result[static_cast<std::size_t>(i)] += cofactor * Number{normal[j]};
      if (i == 0) determinant += cofactor * at(0, j);
    }
  }
  for (Number& coordinate : result) coordinate *= determinant < 0 ? -1 : 1;
  return result;
}

/// The sine of the angle between two directions; 1 where it is more than a right one.
template <class Number>
Number sine_between(const Direction<Number>& a, const Eigen::Vector3f& b, Number (*root)(Number)) {
  const Number x = b.x();
  const Number y = b.y();
  const Number z = b.z();
  const Direction<Number> cross = {a[1] * z - a[2] * y, a[2] * x - a[0] * z, a[0] * y - a[1] * x};
  const auto square = [](const Direction<Number>& v) {
    return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  };
  if (a[0] * x + a[1] * y + a[2] * z < 0) return 1;
  return root(square(cross) / (square(a) * (x * x + y * y + z * z)));
}

template <class MatrixOf>
void add(TimedLadder& ladder, const std::vector<Case>& cases, const char* name, const char* fault,
         MatrixOf matrix_of) {
  MeasuredError degrees;
  for (const Case& one : cases) {
    const Eigen::Matrix3f matrix = matrix_of(one.matrix);
    for (const Eigen::Vector3f& normal : one.normals) {
      const Eigen::Vector3f computed = matrix * normal;
      const double by_double = sine_between<double>(moved<double>(one.matrix, normal), computed,
                                                    [](double x) { return std::sqrt(x); });
      const Quad by_quad =
          sine_between<Quad>(moved<Quad>(one.matrix, normal), computed, &quad_sqrt);
      const auto in_degrees = [](double sine) {
        return std::asin(std::min(sine, 1.0)) * 180 / std::numbers::pi;
      };
      degrees.add(in_degrees(by_double), Quad{in_degrees(static_cast<double>(by_quad))});
    }
  }
  const auto results = std::make_shared<std::vector<Eigen::Vector3f>>(normals_a_matrix);
  ladder.rungs.push_back({.name = name,
                          .fault = fault,
                          .work =
                              [cases, results, matrix_of] {
                                for (const Case& one : cases) {
                                  const Eigen::Matrix3f matrix = matrix_of(one.matrix);
                                  for (std::size_t i = 0; i < normals_a_matrix; ++i)
                                    (*results)[i] = (matrix * one.normals[i]).normalized();
                                }
                              },
                          .errors = {{"largest angle in degrees", degrees.largest()},
                                     {"RMS in degrees", degrees.root_mean_square()}}});
}

}  // namespace

TimedLadder normal_ladder(double unevenness) {
  const std::vector<Case> cases = make_cases(unevenness);
  TimedLadder ladder{
      .name = "normals, scales up to 1:" + std::to_string(static_cast<int>(unevenness)),
      .stage = "04",
      .unit = "normal",
      .units = static_cast<double>(cases.size() * normals_a_matrix),
      .error = "largest angle in degrees",
      .rungs = {}};
  using Block = Eigen::Matrix3f;
  add(ladder, cases, "the surface's matrix", "right for even scales only",
      [](const Eigen::Matrix4f& m) -> Block { return m.topLeftCorner<3, 3>(); });
  add(ladder, cases, "inverse transpose, float", "none where there is an inverse",
      [](const Eigen::Matrix4f& m) -> Block {
        return m.topLeftCorner<3, 3>().inverse().transpose();
      });
  add(ladder, cases, "inverse transpose, double", "none where there is an inverse",
      [](const Eigen::Matrix4f& m) -> Block {
        return m.topLeftCorner<3, 3>().cast<double>().inverse().transpose().cast<float>();
      });
  add(ladder, cases, "cofactors (04.10)", "none", &normal_matrix);
  return ladder;
}

}  // namespace rasterlab::bench
