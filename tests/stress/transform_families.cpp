// Cameras, models and normals.
#include "common/lighting/vertex_normals.h"
#include "common/mesh/normals.h"
#include "common/projection/look_at.h"
#include "common/projection/normal_matrix.h"

#include "tests/stress/family.h"

#include <cmath>

namespace rasterlab::stress {
namespace {

__extension__ using Float128 = __float128;
using Vector = std::array<Float128, 3>;

Eigen::Vector3f vector_at(const Numbers& n, std::size_t i) {
  return {static_cast<float>(n[i]), static_cast<float>(n[i + 1]), static_cast<float>(n[i + 2])};
}

Vector exact(const Eigen::Vector3f& v) {
  return {v.x(), v.y(), v.z()};
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Float128 dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

long double length(const Vector& v) {
  return std::sqrt(static_cast<long double>(dot(v, v)));
}

/// Eye, centre, up.
Numbers any_camera(Random& random) {
  const double reach = random.pick({1, 100, 1e4, 1e7});
  Numbers numbers;
  for (int i = 0; i < 6; ++i) numbers.push_back(random.number(-reach, reach));
  for (int i = 0; i < 3; ++i) numbers.push_back(random.number(-1, 1));
  return numbers;
}

Numbers parallel_up(Random& random) {
  Numbers numbers = any_camera(random);
  const double angle = std::pow(10, -random.number(0, 12));
  const double sign = random.pick({-1, 1});
  for (std::size_t i = 0; i < 3; ++i) {
    numbers[6 + i] = sign * (numbers[i] - numbers[3 + i]) + angle * random.number(-1, 1);
  }
  return numbers;
}

void check_camera(const Numbers& n, Verdict& verdict) {
  const Eigen::Vector3f eye = vector_at(n, 0);
  const Eigen::Vector3f center = vector_at(n, 3);
  const Eigen::Matrix4f view = look_at(eye, center, vector_at(n, 6));
  std::array<Vector, 3> axis;
  for (std::size_t i = 0; i < 3; ++i) {
    axis[i] = exact(view.row(static_cast<Eigen::Index>(i)).head<3>().transpose());
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      const auto error = static_cast<double>(dot(axis[i], axis[j]) - (i == j ? 1 : 0));
      verdict.expect_error(std::abs(error), 1e-6, [&] {
        return "axes " + std::to_string(i) + " and " + std::to_string(j) +
               " are not orthonormal: off by " + std::to_string(error);
      });
    }
  }
  const auto determinant = static_cast<double>(dot(cross(axis[0], axis[1]), axis[2]));
  verdict.expect_error(std::abs(determinant - 1), 2e-6,
                       [&] { return "the determinant is " + std::to_string(determinant); });
  // The eye lands on the origin, up to the rounding of its coordinates.
  for (int row = 0; row < 3; ++row) {
    Float128 at = view(row, 3);
    for (int i = 0; i < 3; ++i) at += static_cast<Float128>(view(row, i)) * eye[i];
    const double allowed = 1e-6 * (1 + static_cast<double>(eye.cast<double>().norm()));
    verdict.expect_error(std::abs(static_cast<double>(at)), allowed,
                         [&] { return "the eye does not land on the origin"; });
  }
}

/// A matrix row by row, then a normal.
Numbers models(Random& random) {
  Numbers numbers;
  for (int i = 0; i < 9; ++i) {
    numbers.push_back(random.number(-1, 1) * std::pow(10, random.number(-3, 3)));
  }
  switch (random.whole(0, 4)) {
    case 0:  // mirrored
      for (std::size_t i = 0; i < 3; ++i) numbers[i] = -numbers[i];
      break;
    case 1:  // pressed flat
      for (std::size_t i = 0; i < 3; ++i) numbers[6 + i] = 0;
      break;
    case 2:  // singular, not along an axis
      for (std::size_t i = 0; i < 3; ++i) numbers[6 + i] = numbers[i] - 2 * numbers[3 + i];
      break;
    case 3:  // pressed to a line
      for (std::size_t i = 0; i < 3; ++i) numbers[3 + i] = numbers[6 + i] = 0;
      break;
    default:
      break;
  }
  for (int i = 0; i < 3; ++i) numbers.push_back(random.number(-1, 1));
  return numbers;
}

void check_model(const Numbers& n, Verdict& verdict) {
  Eigen::Matrix4f model = Eigen::Matrix4f::Identity();
  Float128 scale = 0;
  for (std::size_t i = 0; i < 9; ++i) {
    const auto row = static_cast<Eigen::Index>(i / 3);
    model(row, static_cast<Eigen::Index>(i % 3)) = static_cast<float>(n[i]);
    scale += static_cast<Float128>(static_cast<float>(n[i])) * static_cast<float>(n[i]);
  }
  const Eigen::Vector3f normal = vector_at(n, 9).normalized();
  const Eigen::Vector3f moved = transform_normal(normal_matrix(model), normal);
  verdict.expect(moved.allFinite(), [] { return "a normal is not finite"; });
  std::array<Vector, 3> column;
  for (std::size_t i = 0; i < 3; ++i) {
    column[i] = exact(model.col(static_cast<Eigen::Index>(i)).head<3>());
  }
  // The cofactors' columns are the cross products of the matrix's.
  const Float128 determinant = dot(cross(column[0], column[1]), column[2]);
  Vector truth = {0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector cofactors = cross(column[(i + 1) % 3], column[(i + 2) % 3]);
    for (std::size_t k = 0; k < 3; ++k) {
      truth[k] += cofactors[k] * normal[static_cast<Eigen::Index>(i)];
    }
  }
  const long double size = length(truth);
  const auto rounding = static_cast<long double>(scale) * 1e-6L;
  if (!(size > 100 * rounding)) return;  // the sum cancels: single precision has no direction left
  const bool flipped = determinant < 0;
  const bool either_sign = std::abs(static_cast<long double>(determinant)) <
                           rounding * std::sqrt(static_cast<long double>(scale));
  double error = 0;
  double error_of_opposite = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const long double wanted = static_cast<long double>(truth[k]) / size * (flipped ? -1 : 1);
    const long double found = moved[static_cast<Eigen::Index>(k)];
    error = std::max(error, static_cast<double>(std::abs(found - wanted)));
    error_of_opposite = std::max(error_of_opposite, static_cast<double>(std::abs(found + wanted)));
  }
  if (either_sign) error = std::min(error, error_of_opposite);
  verdict.expect_error(error, 1e-6 + static_cast<double>(rounding / size),
                       [&] { return "a normal is off by " + std::to_string(error); });
}

/// A sheet with two sides: a triangle's corners, then how far the second side's are moved.
Numbers opposite_normals(Random& random) {
  Numbers numbers;
  const double reach = random.pick({1e-3, 1, 1e3});
  for (int i = 0; i < 9; ++i) numbers.push_back(random.number(-reach, reach));
  numbers.push_back(random.chance(0.5) ? 0 : reach * std::pow(10, -random.number(0, 9)));
  return numbers;
}

void check_sheet(const Numbers& n, Verdict& verdict) {
  Mesh mesh;
  for (std::size_t i = 0; i < 3; ++i) mesh.positions.push_back(vector_at(n, 3 * i));
  mesh.positions.emplace_back(vector_at(n, 6) +
                              Eigen::Vector3f::Constant(static_cast<float>(n[9])));
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
  for (const auto& normals : {vertex_normals(mesh), angle_weighted_normals(mesh)}) {
    for (const Eigen::Vector3f& normal : normals) {
      const double error = std::abs(static_cast<double>(length(exact(normal))) - 1);
      verdict.expect_error(error, 1e-6, [&] {
        return "a vertex normal's length is off by " + std::to_string(error);
      });
    }
  }
}

}  // namespace

std::vector<Family> transform_families() {
  const std::string camera =
      "the camera's axes are orthonormal to 1e-6, right-handed, and the eye lands on the origin";
  return {
      many_at_once("cameras", camera, 9, 32, any_camera, check_camera),
      many_at_once("parallel_up", camera + ", with up 10⁰ … 10⁻¹² from the line of sight", 9, 32,
                   parallel_up, check_camera),
      many_at_once("models",
                   "under uneven, mirrored and singular matrices normals are those of the moved "
                   "surface, as far as single precision determines them",
                   12, 128, models, check_model),
      many_at_once("opposite_normals",
                   "where faces' normals cancel, a vertex still has one of unit length", 10, 32,
                   opposite_normals, check_sheet),
  };
}

}  // namespace rasterlab::stress
