// Where the viewer looks from: as the flags or the scene say, and where they are silent, so that
// the mesh fills the picture.
#pragma once

#include "common/projection/draw_mesh.h"
#include "common/projection/scene.h"
#include "common/stage/run.h"

#include <optional>
#include <span>

#include <Eigen/Dense>

namespace rasterlab {

/// The camera as far as a user has said. Lengths in the world's units.
struct CameraWishes {
  std::optional<Eigen::Vector3f> eye;
  std::optional<Eigen::Vector3f> center;
  std::optional<Eigen::Vector3f> up;
  std::optional<float> fovy;          ///< degrees
  std::optional<float> ortho_height;  ///< given: no perspective
  std::optional<float> near;
  std::optional<float> far;
};

/// What is to be seen: the world's part and the picture's size.
struct Stand {
  Eigen::AlignedBox3f box;                  ///< around all of it; not empty
  std::span<const Eigen::Vector3f> points;  ///< that are to be seen, as the mesh's vertices
  Size size;
};

struct Camera {
  Eigen::Vector3f eye;
  Eigen::Vector3f center;
  Eigen::Vector3f up;
  float fovy;
  std::optional<float> ortho_height;
  std::optional<float> near;  ///< this and the next: not given, they follow from the box
  std::optional<float> far;
};

/// What a scene says of the camera: the field of view that its focal length gives over its height,
/// its image y turned to up.
CameraWishes camera_of(const Scene& scene);

/// `over` where it says something, else `under`.
CameraWishes merged(const CameraWishes& over, const CameraWishes& under);

/// The camera wished for. What was not said: up is y; the centre is the box's; the eye is in front,
/// to the right and above, far enough that all points are seen from each of `turns` places evenly
/// around the centre; perspective of 40°. Throws UsageError for what no camera can be: eye and
/// centre the same, a field of view not between 0 and 180, near planes that are not nearer than far
/// ones.
Camera make_camera(const CameraWishes& wishes, const Stand& stand, int turns);

/// The camera carried round its centre about `up` by an angle in degrees, counter-clockwise seen
/// from above.
Camera turned(const Camera& camera, float angle);

/// The camera raised round its centre toward `up` by an angle in degrees; it stops a degree short
/// of looking along `up`.
Camera raised(const Camera& camera, float angle);

/// The camera `factor` times as far from its centre, or, without perspective, seeing `factor` times
/// as much.
Camera zoomed(const Camera& camera, float factor);

/// View and projection; the model's matrix is the identity.
Transforms transforms_of(const Camera& camera, const Stand& stand);

}  // namespace rasterlab
