// An independent witness of what a picture should show: rays through pixel centres, in double
// precision, against every triangle. It shares nothing with what it checks but Mesh; matrices,
// intersection and clipping are its own.
//
// Rays are cast in the mesh's own space: through the inverse of projection · view · model, from the
// near plane to the far plane, so that near-plane clipping and the far plane are simply the ends of
// the ray. Window coordinates are pixels, origin at the top left corner of the picture, y down;
// pixel (x, y) has its centre at (x + ½, y + ½).
#pragma once

#include "common/mesh/cull.h"
#include "common/mesh/mesh.h"

#include <array>
#include <limits>
#include <vector>

#include <Eigen/Dense>

namespace rasterlab::oracle {

/// From the mesh's space to clip space (visible means −w ≤ x, y, z ≤ w) in three steps.
struct Camera {
  Eigen::Matrix4d model = Eigen::Matrix4d::Identity();
  Eigen::Matrix4d view = Eigen::Matrix4d::Identity();  ///< to camera space: looking along −z, y up
  Eigen::Matrix4d projection = Eigen::Matrix4d::Identity();

  Eigen::Matrix4d to_clip() const { return projection * view * model; }
};

/// Camera space from where the camera stands and what it looks at.
Eigen::Matrix4d look_at(const Eigen::Vector3d& eye, const Eigen::Vector3d& center,
                        const Eigen::Vector3d& up);

/// Vertical field of view in degrees, aspect = width / height; `far` may be infinite.
Eigen::Matrix4d perspective(double fovy, double aspect, double near, double far);

/// A box `height` high around the view axis.
Eigen::Matrix4d orthographic(double height, double aspect, double near, double far);

/// What a ray meets first.
struct Hit {
  static constexpr double nothing = std::numeric_limits<double>::infinity();

  int face = -1;              ///< index of the triangle, −1 for none
  double distance = nothing;  ///< along the view axis
  Eigen::Vector3d weights =
      Eigen::Vector3d::Zero();  ///< barycentric in space, hence perspective-correct
  bool front =
      true;  ///< seen from outside, where its corners go counter-clockwise in the mesh's space
  double ray_parameter = nothing;  ///< grows away from the eye; for comparing hits of one ray
  int snapping = 0;                ///< how its corners are snapped, one of RayCaster::snappings()
};

class RayCaster {
 public:
  RayCaster(const Mesh& mesh, const Camera& camera, int width, int height, Cull cull = Cull::none);

  int width() const { return width_; }
  int height() const { return height_; }

  /// The nearest hit of the ray through window point (x, y).
  Hit cast(double x, double y) const;

  /// All hits of that ray, the nearest first: what one sees through a face that refuses a pixel.
  std::vector<Hit> cast_through(double x, double y) const;

  /// Where the ray meets the plane of one face, inside its outline or not: the attributes of that
  /// face continued.
  Hit cast_plane(double x, double y, int face) const;

  /// The same as a picture shows it: cut at the near plane and the guard band, corners snapped to
  /// 1/256 px, and attributes interpolated perspective-correctly from the snapped corners
  /// (docs/conventions.md).
  Hit drawn_plane(double x, double y, int face, int snapping = 0) const;

  /// The same with the weights in the window taken for those in space.
  Hit affine_plane(double x, double y, int face) const;

  /// In how many ways the face's corners may be snapped. A corner within 2⁻¹⁴ px of the middle
  /// between two points of the grid is snapped to either in single precision: each bit of a
  /// snapping stands for one such coordinate, 0 for what double precision does.
  int snappings(int face) const;

  /// Whether window point (x, y) lies in the face's outline, on the visible side of the near plane
  /// and not culled.
  bool covers(double x, double y, int face) const;

  /// NDC depth, affine in the window, of the plane of a face.
  double plane_depth(double x, double y, int face) const;

  /// For every pixel, row by row: how far its centre is from the nearest outline, in pixels, of any
  /// triangle that is not hidden behind the hit there. More than 1 is given as infinity.
  std::vector<double> edge_distances() const;

  /// How far, in pixels, the point is from the line in which the planes of two faces cross in the
  /// window, or 0 where they are closer in NDC depth than single precision tells apart. Which of
  /// the two is seen changes there.
  double crossing_distance(double x, double y, int face, int other) const;

  /// Whether another face that the ray meets crosses the one that is seen within so many pixels.
  bool is_near_crossing(double x, double y, const Hit& seen, double pixels) const;

 private:
  struct Ray {
    Eigen::Vector3d origin;
    Eigen::Vector3d direction;
    double end;
  };
  struct Node {
    Eigen::AlignedBox3d box;
    int left = -1;  ///< inner node: its children are left and right
    int right = -1;
    int first = 0;  ///< leaf: its faces are order_[first … first + count)
    int count = 0;
  };
  struct WindowPoint {
    Eigen::Vector2d position;
    double distance;
  };

  /// A corner of what cutting leaves: in clip space, and which part of each corner of the face it
  /// has.
  struct CutCorner {
    Eigen::Vector4d clip;
    Eigen::Vector3d weights;
  };

  /// A triangle of what cutting has left of a face.
  struct SnappedPiece {
    Eigen::Matrix3d in_window;  ///< takes (x, y, 1) to weights of the piece's corners in the window
    Eigen::Matrix3d in_space;   ///< takes those to the face's, not yet divided by their sum
  };
  using SnappedPieces = std::vector<SnappedPiece>;

  /// The piece that window point (x, y) lies in, or nearly, and where in it.
  struct PlaceInPiece {
    const SnappedPiece* piece = nullptr;
    Eigen::Vector3d in_window = Eigen::Vector3d::Zero();
  };

  Ray ray(double x, double y) const;
  template <class Visit>
  void traverse(const Ray& ray, const double& limit, Visit&& visit) const;
  Hit intersect(const Ray& ray, int face) const;
  bool is_culled(bool front) const;
  Eigen::Vector2d in_window(const Eigen::Vector4d& clip) const;
  std::vector<CutCorner> cut(int face) const;
  SnappedPieces snapped_pieces(int face, int snapping) const;
  static PlaceInPiece place_in(const SnappedPieces& pieces, double x, double y);
  int build(int first, int count);
  double distance_of(const Eigen::Vector3d& point) const;
  std::vector<WindowPoint> outline(int face) const;
  void splat_edge(const WindowPoint& a, const WindowPoint& b, const std::vector<Hit>& hits,
                  std::vector<double>& distances) const;

  int width_;
  int height_;
  Cull cull_;
  Eigen::Matrix4d to_clip_;
  Eigen::Matrix4d from_clip_;
  Eigen::RowVector4d view_axis_;  ///< distance along the view axis = view_axis_ · (p, 1)
  std::vector<std::array<Eigen::Vector3d, 3>> faces_;
  std::vector<SnappedPieces> snapped_pieces_;  ///< of each face, as double precision snaps
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}  // namespace rasterlab::oracle
