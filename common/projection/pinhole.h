// Exercise 04.6: the camera as photogrammetry has it: a point of the world to a pixel and a depth,
// by K [I|0] [R|t].
//
// This is course C's frame: the camera looks along +z, x is right and y is down, in the camera as
// in the picture. Pictures are in pixels, the origin at their top left corner.
#pragma once

#include <vector>

#include <Eigen/Dense>

namespace rasterlab {

/// From world to camera, [R|t; 0 0 0 1]: R's rows are the camera's axes in the world: x = `up` × z,
/// y = z × x, z from `eye` to `look_at`; t = −R·eye. So `up` is where image y goes, down: (0, −1,
/// 0) for a world whose y is up. Where up or look_at say nothing, as look_at() of look_at.h has it.
///
/// Source: C.1; Hartley and Zisserman, "Multiple View Geometry", section 6.1.
Eigen::Matrix4f world_to_camera(const Eigen::Vector3f& eye, const Eigen::Vector3f& look_at,
                                const Eigen::Vector3f& up);

/// [I|0]: forgets the fourth coordinate.
Eigen::Matrix<float, 3, 4> canonical_projection();

/// K = [f 0 w/2; 0 f h/2; 0 0 1]: from camera space to pixels times depth. The focal length is in
/// pixels, too; what lies on the axis lands on the middle of the picture.
Eigen::Matrix3f calibration(float focal_length, int width, int height);

/// Each point as (u, v, depth): u = f·x/z + w/2 and v = f·y/z + h/2 in pixels, and depth = z in
/// camera space, kept for the depth buffer. What is not in front of the camera (depth ≤ 0) has no
/// place in the picture: its u and v are NaN. Cost: two divisions a point.
std::vector<Eigen::Vector3f> project_points(const std::vector<Eigen::Vector3f>& points,
                                            const Eigen::Matrix4f& world_to_camera,
                                            const Eigen::Matrix3f& calibration);

}  // namespace rasterlab
