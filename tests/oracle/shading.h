// Light and texture in double precision, from the published formulas: what colour a picture should
// have where the ray caster hits. Shares nothing with the stages.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/mesh/mesh.h"

#include "tests/oracle/picture.h"
#include "tests/oracle/ray_caster.h"

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Dense>

namespace rasterlab::oracle {

/// A colour, and what it jumps with: texel, level or side of the light. Two points of one face with
/// equal keys have no step in colour between them.
struct Shade {
  Eigen::Vector3d color;
  std::vector<long> key = {};
  bool at_jump = false;  ///< the 1/512 px by which snapping moves a corner decides on which side
};

/// The light's and the material's numbers as the flags say them; direction and position in the
/// world.
struct Lighting {
  enum class Model { phong, blinn_phong };

  Eigen::Vector4d light{1, 2, 3, 0};
  double ambient = 0.2;
  double diffuse = 0.8;
  double specular = 0.6;
  double shininess = 128;
  Eigen::Vector4d eye{0, 0, 1, 0};  ///< (x, y, z)/w, or a direction where w is 0
  Model model = Model::phong;

  std::vector<std::string> flags() const;
};

/// Where an orthographic camera's eye is, or a perspective one's.
Eigen::Vector4d eye_of(const Viewpoint& viewpoint);

/// color · (ambient + diffuse) + specular, at most 1 a channel.
Shade light_point(const Lighting& lighting, const Eigen::Vector3d& position,
                  const Eigen::Vector3d& normal, const Eigen::Vector3d& color);

/// A mesh's corner values in double precision, with the normals of the file or, without any, the
/// mean of the unit normals of each vertex's faces.
class Surface {
 public:
  explicit Surface(const Mesh& mesh, const Eigen::Vector3d& color_without = {0.75, 0.75, 0.75});

  Eigen::Vector3d position(const Hit& hit) const { return mix(hit, positions_); }
  Eigen::Vector3d normal(const Hit& hit) const { return mix(hit, normals_).normalized(); }
  Eigen::Vector3d color(const Hit& hit) const { return mix(hit, colors_); }
  Eigen::Vector2d texture_coordinates(const Hit& hit) const {
    return mix(hit, texture_coordinates_).head<2>();
  }
  Eigen::Vector3d face_normal(int face) const;

  /// One corner of the face that was hit, as a hit of its own.
  static Hit corner(const Hit& hit, int corner);

 private:
  Eigen::Vector3d mix(const Hit& hit, const std::vector<Eigen::Vector3d>& values) const;
  void average_face_normals();

  std::vector<Mesh::Triangle> triangles_;
  std::vector<Eigen::Vector3d> positions_;
  std::vector<Eigen::Vector3d> normals_;
  std::vector<Eigen::Vector3d> colors_;
  std::vector<Eigen::Vector3d> texture_coordinates_;  ///< (u, v, 0)
};

/// A colour for what window point (x, y) sees of a face.
using ShadePixel = std::function<Shade(double x, double y, const Hit& hit)>;

/// Lit once a face, once a corner, once a pixel.
Shade shade_flat(const Surface& surface, const Lighting& lighting, const Hit& hit);
Shade shade_gouraud(const Surface& surface, const Lighting& lighting, const Hit& hit);
Shade shade_phong(const Surface& surface, const Lighting& lighting, const Hit& hit);

/// A scene of a figure: its mesh, lit or not, and from where it is seen.
struct FigureScene {
  Mesh mesh;
  Camera camera;
  Cull cull = Cull::none;
};

/// Compares a figure with what the ray caster sees, says on standard output how the two agree, and
/// fails the test where they do not.
void expect_figure(const std::string& name, const Image<Rgb8>& figure, const FigureScene& scene,
                   const std::function<Shade(const Surface& surface, const Hit& hit)>& shade);

/// Compares every pixel's colour, at most `tolerance` code values off in each channel. Beside those
/// within 1/128 px of an edge, pixels within 1/128 px of a jump of the colour are left out and
/// counted as near an edge. Where nothing is hit, black is expected.
///
/// Single precision may snap a corner to the other of two points of the grid (snappings()). Pixels
/// that differ are right where one such snapping of their face lets all of its pixels agree, and
/// counted by themselves.
Agreement compare_colors(const RayCaster& witness, const Image<Rgb8>& picture,
                         const ShadePixel& shade, int tolerance = 1);

}  // namespace rasterlab::oracle
