// A `.scene` file of course C: a mesh, a camera, a light and a material (exercise 04.6).
#pragma once

#include <filesystem>

#include <Eigen/Dense>

namespace rasterlab {

/// How a surface answers light: the share of the ambient, the diffuse and the specular, and the
/// exponent of the highlight. The defaults are A.Q31's.
struct Material {
  float ambient = 0.2F;
  float diffuse = 0.8F;
  float specular = 0.6F;
  float shininess = 128;
};

/// A light at (x, y, z)/w in the world, or, with w = 0, infinitely far away in direction (x, y, z).
struct Light {
  Eigen::Vector4f position = {0, 0, 1, 0};
  float intensity = 1;
  float ambient_intensity = 1;  ///< of the light that comes from everywhere
};

/// What a `.scene` file says, in the course's own terms: see pinhole.h for its camera.
struct Scene {
  std::filesystem::path mesh;  ///< an existing file
  Eigen::Vector3f eye;
  Eigen::Vector3f look_at;
  Eigen::Vector3f up;      ///< where image y goes: down in the picture
  float focal_length = 1;  ///< in pixels
  int width = 0;           ///< of the picture, in pixels
  int height = 0;
  Light light;
  Material material;
};

/// Reads a scene: one record a line, in the order mesh, eye, look-at, up, focal length, width and
/// height, ambient intensity, light (x y z [w] and its intensity), Ka Kd Ks shininess. Blank lines
/// and lines that start with # are skipped, what follows on a line is ignored; lines may end in CR
/// LF. The mesh is looked for from the working directory, then beside the scene. Throws InputError
/// naming the file, the line and what was expected.
Scene read_scene(const std::filesystem::path& path);

}  // namespace rasterlab
