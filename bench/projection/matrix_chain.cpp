#include "bench/projection/matrix_chain.h"

#include "bench/support/quad.h"
#include "bench/support/random_number.h"

#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include <Eigen/Dense>

namespace rasterlab::bench {
namespace {

constexpr double width = 1920;
constexpr double height = 1080;
constexpr double focal = 1.5;  // cotangent of half the vertical field of view
constexpr double near = 0.1;

using Vertices = std::vector<Eigen::Vector3f>;
using Window = std::vector<Eigen::Vector2d>;

/// A camera far out, and a model before it. Positions in the world are doubles: what they are.
struct Setting {
  Eigen::Matrix3d orientation;  ///< rows: the camera's right, up and back in the world
  Eigen::Vector3d eye;
  Eigen::Vector3d place;  ///< of the model
  Vertices vertices;      ///< of the model, about its place
};

Setting make_setting(double distance) {
  std::mt19937 random(11);
  const Eigen::Vector3d direction = Eigen::Vector3d(2, 1, 3).normalized();
  const Eigen::Matrix3d turned = (Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitY()) *
                                  Eigen::AngleAxisd(-0.3, Eigen::Vector3d::UnitX()))
                                     .toRotationMatrix();
  const Eigen::Vector3d eye = distance * direction;
  Setting setting{turned.transpose(), eye, eye - 6 * turned.col(2), Vertices(4096)};
  for (Eigen::Vector3f& vertex : setting.vertices) {
    for (float& coordinate : vertex) coordinate = static_cast<float>(random_number(random, -2, 2));
  }
  return setting;
}

template <class Number>
using Matrix = Eigen::Matrix<Number, 4, 4>;

template <class Number>
Matrix<Number> translation(const Eigen::Vector3d& by) {
  Matrix<Number> matrix = Matrix<Number>::Identity();
  matrix.template topRightCorner<3, 1>() = by.cast<Number>();
  return matrix;
}

template <class Number>
Matrix<Number> rotation(const Eigen::Matrix3d& orientation) {
  Matrix<Number> matrix = Matrix<Number>::Identity();
  matrix.template topLeftCorner<3, 3>() = orientation.cast<Number>();
  return matrix;
}

/// To clip space, the far plane at infinity.
template <class Number>
Matrix<Number> projection() {
  Matrix<Number> matrix = Matrix<Number>::Zero();
  matrix(0, 0) = static_cast<Number>(focal * height / width);
  matrix(1, 1) = static_cast<Number>(focal);
  matrix(2, 2) = Number(-1);
  matrix(2, 3) = static_cast<Number>(-2 * near);
  matrix(3, 2) = Number(-1);
  return matrix;
}

template <class Number>
Eigen::Vector2d to_window(const Eigen::Matrix<Number, 4, 1>& clip) {
  const Number x = (clip.x() / clip.w() + 1) * static_cast<Number>(width / 2);
  const Number y = (1 - clip.y() / clip.w()) * static_cast<Number>(height / 2);
  return {static_cast<double>(x), static_cast<double>(y)};
}

template <class Number>
Eigen::Matrix<Number, 4, 1> homogeneous(const Eigen::Vector3f& vertex) {
  return vertex.cast<Number>().homogeneous();
}

/// The truth, each step in quads.
std::array<Quad, 2> exactly(const Setting& setting, const Eigen::Vector3f& vertex) {
  std::array<Quad, 3> view{};
  for (int row = 0; row < 3; ++row) {
    for (int i = 0; i < 3; ++i) {
      const Quad before_eye = Quad{setting.place[i]} + Quad{vertex[i]} - Quad{setting.eye[i]};
      view[static_cast<std::size_t>(row)] += Quad{setting.orientation(row, i)} * before_eye;
    }
  }
  const Quad w = -view[2];
  return {(Quad{focal * height / width} * view[0] / w + 1) * Quad{width / 2},
          (1 - Quad{focal} * view[1] / w) * Quad{height / 2}};
}

/// The same in doubles, camera first: with nothing large to lose digits to.
Eigen::Vector2d nearly_exactly(const Setting& setting, const Eigen::Vector3f& vertex) {
  const Eigen::Vector3d view =
      setting.orientation * ((setting.place - setting.eye) + vertex.cast<double>());
  const Eigen::Vector4d clip = projection<double>() * view.homogeneous();
  return to_window<double>(clip);
}

template <class Transform>
void add(TimedLadder& ladder, const Setting& setting, const char* name, const char* fault,
         Transform transform) {
  MeasuredError pixels;
  for (const Eigen::Vector3f& vertex : setting.vertices) {
    const Eigen::Vector2d computed = transform(vertex);
    const Eigen::Vector2d by_double = nearly_exactly(setting, vertex);
    const std::array<Quad, 2> by_quad = exactly(setting, vertex);
    for (int i = 0; i < 2; ++i) {
      pixels.add(computed[i] - by_double[i], computed[i] - by_quad[static_cast<std::size_t>(i)]);
    }
  }
  const auto results = std::make_shared<Window>(setting.vertices.size());
  ladder.rungs.push_back({.name = name,
                          .fault = fault,
                          .work =
                              [vertices = setting.vertices, results, transform] {
                                for (std::size_t i = 0; i < vertices.size(); ++i)
                                  (*results)[i] = transform(vertices[i]);
                              },
                          .errors = {{"largest error in pixels", pixels.largest()},
                                     {"RMS in pixels", pixels.root_mean_square()}}});
}

/// Model, view and projection one after the other, or as one matrix, in one kind of number.
template <class Number>
auto step_by_step(const Setting& setting) {
  return [model = translation<Number>(setting.place),
          view = Matrix<Number>(rotation<Number>(setting.orientation) *
                                translation<Number>(-setting.eye)),
          project = projection<Number>()](const Eigen::Vector3f& vertex) {
    const Eigen::Matrix<Number, 4, 1> world = model * homogeneous<Number>(vertex);
    const Eigen::Matrix<Number, 4, 1> clip = project * (view * world);
    return to_window<Number>(clip);
  };
}

template <class Number>
auto at_once(const Matrix<Number>& matrix) {
  return [matrix](const Eigen::Vector3f& vertex) {
    const Eigen::Matrix<Number, 4, 1> clip = matrix * homogeneous<Number>(vertex);
    return to_window<Number>(clip);
  };
}

template <class Number>
Matrix<Number> product(const Setting& setting) {
  return projection<Number>() *
         (rotation<Number>(setting.orientation) * translation<Number>(-setting.eye)) *
         translation<Number>(setting.place);
}

}  // namespace

TimedLadder matrix_chain_ladder(double distance) {
  const Setting setting = make_setting(distance);
  char name[80];
  std::snprintf(name, sizeof name, "matrices, camera %.0e from the origin", distance);
  TimedLadder ladder{.name = name,
                     .stage = "04",
                     .unit = "vertex",
                     .units = static_cast<double>(setting.vertices.size()),
                     .error = "largest error in pixels",
                     .rungs = {}};
  add(ladder, setting, "float, one by one", "the world's coordinates take the digits",
      step_by_step<float>(setting));
  add(ladder, setting, "float product", "the same, once for all vertices",
      at_once<float>(product<float>(setting)));
  add(ladder, setting, "camera-relative float", "rounds after the large parts have cancelled",
      at_once<float>(projection<float>() * rotation<float>(setting.orientation) *
                     translation<float>(setting.place - setting.eye)));
  add(ladder, setting, "double product, to float", "rounded once it is small",
      at_once<float>(product<double>(setting).cast<float>()));
  add(ladder, setting, "double product", "loses what doubles lose",
      at_once<double>(product<double>(setting)));
  add(ladder, setting, "double, one by one", "loses what doubles lose",
      step_by_step<double>(setting));
  return ladder;
}

}  // namespace rasterlab::bench
