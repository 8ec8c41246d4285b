#include "tests/oracle/ray_caster.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <Eigen/LU>

namespace rasterlab::oracle {

namespace {

constexpr int leaf_size = 4;

/// Where a ray enters and leaves a box: enter ≤ leave when it meets it.
bool meets(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& origin,
           const Eigen::Vector3d& direction, double limit) {
  double enter = 0;
  double leave = limit;
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0) {
      if (origin[axis] < box.min()[axis] || origin[axis] > box.max()[axis]) return false;
      continue;
    }
    double a = (box.min()[axis] - origin[axis]) / direction[axis];
    double b = (box.max()[axis] - origin[axis]) / direction[axis];
    if (a > b) std::swap(a, b);
    // Half a part in 10^12 wider, so that flat boxes are never missed by rounding.
    enter = std::max(enter, a - 5e-13 * std::abs(a));
    leave = std::min(leave, b + 5e-13 * std::abs(b));
  }
  return enter <= leave;
}

}  // namespace

Eigen::Matrix4d look_at(const Eigen::Vector3d& eye, const Eigen::Vector3d& center,
                        const Eigen::Vector3d& up) {
  const Eigen::Vector3d back = (eye - center).normalized();
  const Eigen::Vector3d right = up.cross(back).normalized();
  Eigen::Matrix4d camera =
      Eigen::Matrix4d::Identity();  // camera space to world: its axes and where it stands
  camera.col(0).head<3>() = right;
  camera.col(1).head<3>() = back.cross(right);
  camera.col(2).head<3>() = back;
  camera.col(3).head<3>() = eye;
  return camera.inverse();
}

Eigen::Matrix4d perspective(double fovy, double aspect, double near, double far) {
  const double half_height = std::tan(fovy * std::numbers::pi / 360);
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  matrix(0, 0) = 1 / (half_height * aspect);
  matrix(1, 1) = 1 / half_height;
  // z' = a z + b and w' = −z with z'/w' = −1 at z = −near, +1 at z = −far.
  matrix(2, 2) = std::isinf(far) ? -1 : -(far + near) / (far - near);
  matrix(2, 3) = std::isinf(far) ? -2 * near : -2 * far * near / (far - near);
  matrix(3, 2) = -1;
  return matrix;
}

Eigen::Matrix4d orthographic(double height, double aspect, double near, double far) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix(0, 0) = 2 / (height * aspect);
  matrix(1, 1) = 2 / height;
  matrix(2, 2) = -2 / (far - near);
  matrix(2, 3) = -(far + near) / (far - near);
  return matrix;
}

RayCaster::RayCaster(const Mesh& mesh, const Camera& camera, int width, int height, Cull cull)
    : width_(width),
      height_(height),
      cull_(cull),
      to_clip_(camera.to_clip()),
      from_clip_(to_clip_.inverse()),
      view_axis_(-(camera.view * camera.model).row(2)) {
  faces_.reserve(mesh.triangles.size());
  for (const Mesh::Triangle& triangle : mesh.triangles) {
    std::array<Eigen::Vector3d, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = mesh.positions[triangle[i]].cast<double>();
    faces_.push_back(corners);
    snapped_pieces_.push_back(snapped_pieces(static_cast<int>(faces_.size()) - 1, 0));
  }
  order_.resize(faces_.size());
  std::iota(order_.begin(), order_.end(), 0);
  if (!faces_.empty()) build(0, static_cast<int>(faces_.size()));
}

int RayCaster::build(int first, int count) {
  const int index = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  Eigen::AlignedBox3d box;
  Eigen::AlignedBox3d centers;
  const auto center = [this](int face) {
    const auto& corners = faces_[static_cast<std::size_t>(face)];
    return Eigen::Vector3d((corners[0] + corners[1] + corners[2]) / 3);
  };
  const auto begin = order_.begin() + first;
  for (auto face = begin; face != begin + count; ++face) {
    for (const Eigen::Vector3d& corner : faces_[static_cast<std::size_t>(*face)])
      box.extend(corner);
    centers.extend(center(*face));
  }
  Node node{.box = box, .first = first, .count = count};
  if (count > leaf_size) {
    int axis = 0;
    centers.sizes().maxCoeff(&axis);
    std::nth_element(begin, begin + count / 2, begin + count,
                     [&](int a, int b) { return center(a)[axis] < center(b)[axis]; });
    node.left = build(first, count / 2);
    node.right = build(first + count / 2, count - count / 2);
    node.count = 0;
  }
  nodes_[static_cast<std::size_t>(index)] = node;
  return index;
}

RayCaster::Ray RayCaster::ray(double x, double y) const {
  const double ndc_x = 2 * x / width_ - 1;
  const double ndc_y = 1 - 2 * y / height_;
  const Eigen::Vector4d near = from_clip_ * Eigen::Vector4d(ndc_x, ndc_y, -1, 1);
  const Eigen::Vector4d far = from_clip_ * Eigen::Vector4d(ndc_x, ndc_y, 1, 1);
  const Eigen::Vector3d origin = near.head<3>() / near.w();
  // With the far plane at infinity, far.w is 0 up to rounding and far.xyz a direction.
  if (std::abs(far.w()) < 1e-12 * far.head<3>().norm()) {
    return {origin, (far.head<3>() / near.w()).normalized(), Hit::nothing};
  }
  const Eigen::Vector3d way = far.head<3>() / far.w() - origin;
  return {origin, way.normalized(), way.norm()};
}

bool RayCaster::is_culled(bool front) const {
  return (cull_ == Cull::back && !front) || (cull_ == Cull::front && front);
}

double RayCaster::distance_of(const Eigen::Vector3d& point) const {
  return view_axis_ * point.homogeneous();
}

/// Möller and Trumbore, "Fast, minimum storage ray-triangle intersection" (1997), without its tests
/// of the outline.
Hit RayCaster::intersect(const Ray& ray, int face) const {
  const auto& [a, b, c] = faces_[static_cast<std::size_t>(face)];
  const Eigen::Vector3d ab = b - a;
  const Eigen::Vector3d ac = c - a;
  const Eigen::Vector3d p = ray.direction.cross(ac);
  const double determinant = ab.dot(p);
  if (determinant == 0) return {};
  const Eigen::Vector3d s = ray.origin - a;
  const double u = s.dot(p) / determinant;
  const Eigen::Vector3d q = s.cross(ab);
  const double v = ray.direction.dot(q) / determinant;
  const double t = ac.dot(q) / determinant;
  Hit hit;
  hit.face = face;
  hit.weights = Eigen::Vector3d(1 - u - v, u, v);
  hit.distance = distance_of(ray.origin + t * ray.direction);
  hit.front = determinant > 0;
  hit.ray_parameter = t;
  return hit;
}

Hit RayCaster::cast_plane(double x, double y, int face) const {
  return intersect(ray(x, y), face);
}

std::vector<RayCaster::CutCorner> RayCaster::cut(int face) const {
  std::vector<CutCorner> polygon;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d& corner =
        faces_[static_cast<std::size_t>(face)][static_cast<std::size_t>(i)];
    polygon.push_back({to_clip_ * corner.homogeneous(), Eigen::Vector3d::Unit(i)});
  }
  const auto guard = [](int side) { return std::exp2(std::floor(std::log2(32768.0 / side))); };
  const double guard_x = guard(width_);
  const double guard_y = guard(height_);
  for (const Eigen::RowVector4d& plane :
       {Eigen::RowVector4d(0, 0, 1, 1), Eigen::RowVector4d(1, 0, 0, guard_x),
        Eigen::RowVector4d(-1, 0, 0, guard_x), Eigen::RowVector4d(0, 1, 0, guard_y),
        Eigen::RowVector4d(0, -1, 0, guard_y)}) {
    std::vector<CutCorner> kept;  // what has plane · clip ≥ 0
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const CutCorner& a = polygon[i];
      const CutCorner& b = polygon[(i + 1) % polygon.size()];
      const double at_a = plane * a.clip;
      const double at_b = plane * b.clip;
      if (at_a >= 0) kept.push_back(a);
      if ((at_a >= 0) == (at_b >= 0)) continue;
      const double t = at_a / (at_a - at_b);
      kept.push_back({a.clip + t * (b.clip - a.clip), a.weights + t * (b.weights - a.weights)});
    }
    polygon = kept;
  }
  return polygon;
}

namespace {

/// Rounds window coordinates to 1/256 px, those in doubt as the bits of a snapping say.
class Snapper {
 public:
  explicit Snapper(int snapping) : snapping_(snapping) {}

  double operator()(double pixels) {
    const double units = pixels * 256;
    const double nearest = std::nearbyint(units);
    const bool in_doubt = 0.5 - std::abs(units - nearest) < 256 * 0x1p-14;
    if (!in_doubt) return nearest / 256;
    const bool other = ((snapping_ >> in_doubt_++) & 1) != 0;
    return (other ? nearest + (units > nearest ? 1 : -1) : nearest) / 256;
  }

  int in_doubt() const { return in_doubt_; }

 private:
  int snapping_;
  int in_doubt_ = 0;
};

}  // namespace

Eigen::Vector2d RayCaster::in_window(const Eigen::Vector4d& clip) const {
  return {(clip.x() / clip.w() + 1) * width_ / 2, (1 - clip.y() / clip.w()) * height_ / 2};
}

int RayCaster::snappings(int face) const {
  Snapper snapper(0);
  for (const CutCorner& corner : cut(face)) {
    for (const double coordinate : in_window(corner.clip)) snapper(coordinate);
  }
  return 1 << snapper.in_doubt();
}

RayCaster::SnappedPieces RayCaster::snapped_pieces(int face, int snapping) const {
  const std::vector<CutCorner> polygon = cut(face);
  std::vector<Eigen::Vector3d> snapped;  // x, y, 1
  Snapper snapper(snapping);
  for (const CutCorner& corner : polygon) {
    const Eigen::Vector2d window = in_window(corner.clip);
    const double x = snapper(window.x());
    snapped.emplace_back(x, snapper(window.y()), 1);
  }
  SnappedPieces pieces;
  for (std::size_t last = 2; last < polygon.size(); ++last) {
    Eigen::Matrix3d window;  // a column a corner
    Eigen::Matrix3d weights;
    int column = 0;
    for (const std::size_t i : {std::size_t{0}, last - 1, last}) {
      window.col(column) = snapped[i];
      weights.col(column++) = polygon[i].weights / polygon[i].clip.w();
    }
    if (std::abs(window.determinant()) > 0) pieces.push_back({window.inverse(), weights});
  }
  return pieces;
}

RayCaster::PlaceInPiece RayCaster::place_in(const SnappedPieces& pieces, double x, double y) {
  PlaceInPiece place;
  double best = -Hit::nothing;
  for (const SnappedPiece& piece : pieces) {
    const Eigen::Vector3d in_window = piece.in_window * Eigen::Vector3d(x, y, 1);
    if (in_window.minCoeff() <= best) continue;
    best = in_window.minCoeff();
    place = {&piece, in_window};
  }
  return place;
}

Hit RayCaster::drawn_plane(double x, double y, int face, int snapping) const {
  Hit hit = cast_plane(x, y, face);
  hit.snapping = snapping;
  const SnappedPieces otherwise = snapping == 0 ? SnappedPieces() : snapped_pieces(face, snapping);
  const PlaceInPiece place =
      place_in(snapping == 0 ? snapped_pieces_[static_cast<std::size_t>(face)] : otherwise, x, y);
  if (place.piece == nullptr) return hit;
  const Eigen::Vector3d weights = place.piece->in_space * place.in_window;
  hit.weights = weights / weights.sum();
  return hit;
}

Hit RayCaster::affine_plane(double x, double y, int face) const {
  Hit hit = cast_plane(x, y, face);
  const PlaceInPiece place = place_in(snapped_pieces_[static_cast<std::size_t>(face)], x, y);
  if (place.piece == nullptr) return hit;
  // A column sums to 1/w of its corner.
  const Eigen::Vector3d w = place.piece->in_space.colwise().sum().cwiseInverse().transpose();
  hit.weights = place.piece->in_space * place.in_window.cwiseProduct(w);
  return hit;
}

bool RayCaster::covers(double x, double y, int face) const {
  const Ray line = ray(x, y);
  const Hit hit = intersect(line, face);
  return hit.face >= 0 && hit.weights.minCoeff() >= 0 && hit.ray_parameter >= 0 &&
         hit.ray_parameter <= line.end && !is_culled(hit.front);
}

double RayCaster::plane_depth(double x, double y, int face) const {
  const Ray line = ray(x, y);
  const Hit hit = intersect(line, face);
  if (hit.face < 0) return Hit::nothing;
  const Eigen::Vector4d clip =
      to_clip_ * (line.origin + hit.ray_parameter * line.direction).homogeneous();
  return clip.z() / clip.w();
}

/// Calls visit(hit) for every face the ray meets up to `limit`, which visit() may lower.
template <class Visit>
void RayCaster::traverse(const Ray& ray, const double& limit, Visit&& visit) const {
  std::vector<int> open;
  if (!nodes_.empty()) open.push_back(0);
  while (!open.empty()) {
    const Node& node = nodes_[static_cast<std::size_t>(open.back())];
    open.pop_back();
    if (!meets(node.box, ray.origin, ray.direction, limit)) continue;
    if (node.count == 0) open.insert(open.end(), {node.left, node.right});
    for (int i = node.first; i < node.first + node.count; ++i) {
      const Hit hit = intersect(ray, order_[static_cast<std::size_t>(i)]);
      const bool inside = hit.face >= 0 && hit.weights.minCoeff() >= 0;
      const bool between = hit.ray_parameter >= 0 && hit.ray_parameter <= ray.end;
      if (inside && between && !is_culled(hit.front)) visit(hit);
    }
  }
}

Hit RayCaster::cast(double x, double y) const {
  Hit nearest;
  traverse(ray(x, y), nearest.ray_parameter, [&](const Hit& hit) {
    const bool as_near = hit.ray_parameter == nearest.ray_parameter;
    if (hit.ray_parameter < nearest.ray_parameter || (as_near && hit.face < nearest.face)) {
      nearest = hit;
    }
  });
  return nearest;
}

std::vector<Hit> RayCaster::cast_through(double x, double y) const {
  std::vector<Hit> hits;
  traverse(ray(x, y), Hit::nothing, [&](const Hit& hit) { hits.push_back(hit); });
  std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
    return std::pair(a.ray_parameter, a.face) < std::pair(b.ray_parameter, b.face);
  });
  return hits;
}

bool RayCaster::is_near_crossing(double x, double y, const Hit& seen, double pixels) const {
  bool found = false;
  traverse(ray(x, y), Hit::nothing, [&](const Hit& hit) {
    if (hit.face == seen.face) return;
    found = found || crossing_distance(x, y, seen.face, hit.face) <= pixels;
  });
  return found;
}

double RayCaster::crossing_distance(double x, double y, int face, int other) const {
  // Four steps of a float just below 1, what a vertex's depth can be off by after transformation
  // and division.
  constexpr double float_resolution = 0x1p-22;
  const auto gap = [&](double at_x, double at_y) {
    return plane_depth(at_x, at_y, face) - plane_depth(at_x, at_y, other);
  };
  const double here = gap(x, y);
  if (std::abs(here) <= float_resolution) return 0;
  const Eigen::Vector2d slope((gap(x + 0.25, y) - gap(x - 0.25, y)) / 0.5,
                              (gap(x, y + 0.25) - gap(x, y - 0.25)) / 0.5);
  return std::abs(here) / slope.norm();
}

/// The face's outline in the window: its corners, cut at the near plane.
std::vector<RayCaster::WindowPoint> RayCaster::outline(int face) const {
  std::array<Eigen::Vector4d, 3> clip;
  const auto& corners = faces_[static_cast<std::size_t>(face)];
  for (std::size_t i = 0; i < 3; ++i) clip[i] = to_clip_ * corners[i].homogeneous();
  std::vector<WindowPoint> points;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    const double inside = clip[i].z() + clip[i].w();
    const double next_inside = clip[next].z() + clip[next].w();
    const auto add = [&](const Eigen::Vector4d& p, const Eigen::Vector3d& in_space) {
      points.push_back({in_window(p), distance_of(in_space)});
    };
    if (inside >= 0) add(clip[i], corners[i]);
    if ((inside >= 0) != (next_inside >= 0)) {
      const double t = inside / (inside - next_inside);
      add(clip[i] + t * (clip[next] - clip[i]), corners[i] + t * (corners[next] - corners[i]));
    }
  }
  return points;
}

/// Lowers the distances of the pixels within one pixel of the segment a–b.
void RayCaster::splat_edge(const WindowPoint& a, const WindowPoint& b, const std::vector<Hit>& hits,
                           std::vector<double>& distances) const {
  const Eigen::Vector2d along = b.position - a.position;
  const double top = std::min(a.position.y(), b.position.y());
  const double bottom = std::max(a.position.y(), b.position.y());
  const int first_row = static_cast<int>(std::clamp(std::floor(top - 1.5), 0.0, height_ - 1.0));
  const int last_row = static_cast<int>(std::clamp(std::ceil(bottom + 0.5), 0.0, height_ - 1.0));
  for (int y = first_row; y <= last_row; ++y) {
    // The part of the segment between one pixel above and one below the row's centres.
    double from = 0;
    double to = 1;
    if (along.y() != 0) {
      const double t0 = (y + 0.5 - 1 - a.position.y()) / along.y();
      const double t1 = (y + 0.5 + 1 - a.position.y()) / along.y();
      from = std::clamp(std::min(t0, t1), 0.0, 1.0);
      to = std::clamp(std::max(t0, t1), 0.0, 1.0);
    }
    const double x0 = a.position.x() + from * along.x();
    const double x1 = a.position.x() + to * along.x();
    const int left =
        static_cast<int>(std::clamp(std::floor(std::min(x0, x1) - 1.5), 0.0, width_ - 1.0));
    const int right =
        static_cast<int>(std::clamp(std::ceil(std::max(x0, x1) + 0.5), 0.0, width_ - 1.0));
    for (int x = left; x <= right; ++x) {
      const Eigen::Vector2d center(x + 0.5, y + 0.5);
      const double length = along.squaredNorm();
      const double t =
          length == 0 ? 0 : std::clamp((center - a.position).dot(along) / length, 0.0, 1.0);
      const double distance = (center - (a.position + t * along)).norm();
      const std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                static_cast<std::size_t>(x);
      if (distance > 1 || distance >= distances[pixel]) continue;
      // Hidden: even the edge's nearer end is well behind what is seen here.
      const bool hidden = std::min(a.distance, b.distance) > hits[pixel].distance * 1.001;
      if (!hidden) distances[pixel] = distance;
    }
  }
}

std::vector<double> RayCaster::edge_distances() const {
  std::vector<Hit> hits;
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) hits.push_back(cast(x + 0.5, y + 0.5));
  }
  std::vector<double> distances(hits.size(), Hit::nothing);
  for (std::size_t face = 0; face < faces_.size(); ++face) {
    const std::vector<WindowPoint> points = outline(static_cast<int>(face));
    for (std::size_t i = 0; i < points.size(); ++i) {
      splat_edge(points[i], points[(i + 1) % points.size()], hits, distances);
    }
  }
  return distances;
}

}  // namespace rasterlab::oracle
