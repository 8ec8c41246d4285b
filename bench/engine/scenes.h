// What is drawn: the same meshes, matrices and textures for both sides.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/mesh/mesh.h"

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Dense>

namespace rasterlab::bench {

enum class ShadingKind { depth, flat, phong, textured, normal_mapped };

std::string name_of(ShadingKind kind);

struct Scene {
  std::string name;
  Mesh mesh;
  std::vector<Eigen::Vector3f> tangents;  ///< one per vertex where there are texture coordinates
  Eigen::Matrix4f matrix;
  Eigen::Vector3f eye;
  std::vector<ShadingKind> shadings;
};

/// Of the picture that a scene is made for.
struct PictureSize {
  int width;
  int height;

  float aspect() const { return static_cast<float>(width) / static_cast<float>(height); }
};

/// A scene, made when its turn comes: some are large.
struct SceneEntry {
  std::string name;
  std::function<Scene(PictureSize size)> make;
};

const std::vector<SceneEntry>& scenes();

/// Not one of them: the rings seen from their midst, so that most lie outside the view.
Scene tori_around_the_eye(PictureSize size);

Image<Rgb8> make_texture(int size);
Image<Rgb8> make_normal_map(int size);

}  // namespace rasterlab::bench
