#include "common/viewer/camera.h"

#include "common/projection/look_at.h"
#include "common/projection/orthographic.h"
#include "common/projection/perspective.h"
#include "common/projection/rotation.h"
#include "common/stage/guard.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace rasterlab {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

const Eigen::Vector3f three_quarter_view(0.6F, 0.45F, 1);

std::array<Eigen::Vector3f, 8> corners(const Eigen::AlignedBox3f& box) {
  std::array<Eigen::Vector3f, 8> all;
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] = box.corner(static_cast<Eigen::AlignedBox3f::CornerType>(i));
  }
  return all;
}

// How far from the centre the eye must be for all to be seen, with a little air around.
float fitting_distance(const Camera& camera, const Stand& stand) {
  constexpr float air = 1.05F;
  const float tangent = std::tan(camera.fovy * std::numbers::pi_v<float> / 360);
  const float aspect = static_cast<float>(stand.size.width) / static_cast<float>(stand.size.height);
  const Eigen::Matrix4f view = look_at(camera.eye, camera.center, camera.up);
  float distance = 0;
  for (const Eigen::Vector3f& point : stand.points) {
    const Eigen::Vector3f seen = view.topLeftCorner<3, 3>() * (point - camera.center);
    const float sideways = std::max(std::abs(seen.x()) / aspect, std::abs(seen.y()));
    distance = std::max(distance, seen.z() + air * sideways / tangent);
  }
  return distance > 0 ? distance : 1;
}

// Moves the eye along the line of sight.
void fit(Camera& camera, const Stand& stand, int turns) {
  float distance = 0;
  for (int i = 0; i < turns; ++i) {
    const float angle = 360 * static_cast<float>(i) / static_cast<float>(turns);
    distance = std::max(distance, fitting_distance(turned(camera, angle), stand));
  }
  camera.eye = camera.center + distance * (camera.eye - camera.center).stableNormalized();
}

// Distances of the nearest and the farthest part of the box along the view axis.
std::pair<float, float> depth_range(const Eigen::Matrix4f& view, const Stand& stand) {
  float nearest = infinity;
  float farthest = -infinity;
  for (const Eigen::Vector3f& corner : corners(stand.box)) {
    const float distance = -view.row(2).dot(corner.homogeneous());
    nearest = std::min(nearest, distance);
    farthest = std::max(farthest, distance);
  }
  return {nearest, farthest};
}

void check(const Camera& camera) {
  if (camera.eye == camera.center) {
    throw UsageError("--eye and --center are the same point: expected two to look along");
  }
  if (camera.up.isZero(0)) throw UsageError("--up 0,0,0: expected a direction");
  if (!(camera.fovy > 0 && camera.fovy < 180)) {
    throw UsageError("--fovy: expected an angle above 0 and below 180 degrees");
  }
  if (camera.ortho_height && !(*camera.ortho_height > 0)) {
    throw UsageError("--ortho: expected the height of what is seen, above 0");
  }
  if (camera.ortho_height && camera.far && std::isinf(*camera.far)) {
    throw UsageError("--far inf: expected a finite distance with --ortho");
  }
  if (!camera.ortho_height && camera.near && !(*camera.near > 0)) {
    throw UsageError("--near: expected a distance above 0");
  }
  if (camera.far && !(*camera.far > camera.near.value_or(camera.ortho_height ? -infinity : 0))) {
    throw UsageError("--far: expected a distance beyond the near plane's, or inf");
  }
}

Eigen::Matrix4f orthographic_projection(const Camera& camera, float aspect, float nearest,
                                        float farthest) {
  const float reach = std::max(farthest - nearest, 1e-3F * std::abs(farthest) + 1e-6F);
  const float near = camera.near.value_or(
      std::min(nearest - 0.01F * reach, camera.far.value_or(infinity) - reach));
  const float far = camera.far.value_or(std::max(farthest + 0.01F * reach, near + reach));
  return orthographic(*camera.ortho_height, aspect, near, far);
}

Eigen::Matrix4f perspective_projection(const Camera& camera, float aspect, float nearest,
                                       float farthest) {
  // As far out as the mesh allows, for the sake of depth; a thousandth of the way when inside it.
  const float fitting = farthest > 0 ? std::max(0.9F * nearest, 0.001F * farthest) : 1.0F;
  const float far = camera.far.value_or(infinity);
  const float near = camera.near.value_or(std::min(fitting, 0.5F * far));
  return perspective(camera.fovy, aspect, near, far);
}

template <class Value>
void prefer(std::optional<Value>& value, const std::optional<Value>& other) {
  if (!value) value = other;
}

}  // namespace

CameraWishes camera_of(const Scene& scene) {
  const double half_height = scene.height / 2.0;
  const double half_angle = std::atan(half_height / static_cast<double>(scene.focal_length));
  CameraWishes wishes;
  wishes.eye = scene.eye;
  wishes.center = scene.look_at;
  wishes.up = -scene.up;
  wishes.fovy = static_cast<float>(half_angle * 360 / std::numbers::pi);
  return wishes;
}

CameraWishes merged(const CameraWishes& over, const CameraWishes& under) {
  CameraWishes result = over;
  prefer(result.eye, under.eye);
  prefer(result.center, under.center);
  prefer(result.up, under.up);
  prefer(result.fovy, under.fovy);
  prefer(result.ortho_height, under.ortho_height);
  prefer(result.near, under.near);
  prefer(result.far, under.far);
  return result;
}

Camera make_camera(const CameraWishes& wishes, const Stand& stand, int turns) {
  const Eigen::Vector3f center = wishes.center.value_or(stand.box.center());
  Camera camera{.eye = wishes.eye.value_or(center + three_quarter_view),
                .center = center,
                .up = wishes.up.value_or(Eigen::Vector3f::UnitY()),
                .fovy = wishes.fovy.value_or(40),
                .ortho_height = wishes.ortho_height,
                .near = wishes.near,
                .far = wishes.far};
  check(camera);
  if (!wishes.eye) fit(camera, stand, turns);
  return camera;
}

Camera turned(const Camera& camera, float angle) {
  Camera result = camera;
  const Eigen::Vector3f offset = camera.eye - camera.center;
  result.eye = camera.center + rotation(angle, camera.up).topLeftCorner<3, 3>() * offset;
  return result;
}

Camera raised(const Camera& camera, float angle) {
  const Eigen::Vector3f offset = camera.eye - camera.center;
  const Eigen::Vector3f up = camera.up.stableNormalized();
  const Eigen::Vector3f axis = offset.cross(up);
  const float from_up = std::atan2(axis.norm(), offset.dot(up)) * 180 / std::numbers::pi_v<float>;
  const float allowed = from_up - std::clamp(from_up - angle, 1.0F, 179.0F);
  Camera result = camera;
  result.eye = camera.center + rotation(allowed, axis).topLeftCorner<3, 3>() * offset;
  return result;
}

Camera zoomed(const Camera& camera, float factor) {
  Camera result = camera;
  if (camera.ortho_height) {
    result.ortho_height = *camera.ortho_height * factor;
  } else {
    result.eye = camera.center + factor * (camera.eye - camera.center);
  }
  return result;
}

Transforms transforms_of(const Camera& camera, const Stand& stand) {
  const float aspect = static_cast<float>(stand.size.width) / static_cast<float>(stand.size.height);
  Transforms transforms;
  transforms.view = look_at(camera.eye, camera.center, camera.up);
  const auto [nearest, farthest] = depth_range(transforms.view, stand);
  transforms.projection = camera.ortho_height
                              ? orthographic_projection(camera, aspect, nearest, farthest)
                              : perspective_projection(camera, aspect, nearest, farthest);
  return transforms;
}

}  // namespace rasterlab
