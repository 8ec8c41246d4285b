#include "common/mesh/shapes.h"

#include "common/image/check.h"

#include <charconv>
#include <cmath>
#include <numbers>
#include <unordered_map>

namespace rasterlab {
namespace {

constexpr double pi = std::numbers::pi;

struct Vertex {
  Eigen::Vector3f position;
  Eigen::Vector3f normal;
  Eigen::Vector2f uv;
};

void reserve(Mesh& mesh, std::size_t vertices, std::size_t triangles) {
  mesh.positions.reserve(vertices);
  mesh.normals.reserve(vertices);
  mesh.texture_coordinates.reserve(vertices);
  mesh.triangles.reserve(triangles);
}

std::uint32_t add_vertex(Mesh& mesh, const Vertex& vertex) {
  mesh.positions.push_back(vertex.position);
  mesh.normals.push_back(vertex.normal);
  mesh.texture_coordinates.push_back(vertex.uv);
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

float ratio(int part, int whole) {
  return static_cast<float>(part) / static_cast<float>(whole);
}

/// cos and sin of part / whole of a turn, for part in 0…whole; the last is exactly the first.
std::vector<Eigen::Vector2f> points_on_circle(int whole) {
  std::vector<Eigen::Vector2f> points;
  points.reserve(static_cast<std::size_t>(whole) + 1);
  for (int part = 0; part < whole; ++part) {
    const double angle = 2 * pi * part / whole;
    points.emplace_back(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)));
  }
  points.push_back(points.front());
  return points;
}

/// Adds columns × rows quads of two triangles each. vertex(column, row) gives their corners, column
/// in 0…columns, row in 0…rows. Seen from outside, columns go right and rows up.
template <class VertexAt>
void add_sheet(Mesh& mesh, int columns, int rows, const VertexAt& vertex) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) add_vertex(mesh, vertex(column, row));
  }
  const auto stride = static_cast<std::uint32_t>(columns) + 1;
  for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(rows); ++row) {
    for (std::uint32_t column = 0; column + 1 < stride; ++column) {
      const std::uint32_t low = first + row * stride + column;
      const std::uint32_t high = low + stride;
      mesh.triangles.push_back({low, low + 1, high + 1});
      mesh.triangles.push_back({low, high + 1, high});
    }
  }
}

// ---- Flat shapes

/// Adds a square of side 2, which reaches one `right` and one `up` to either side of `center`.
void add_square(Mesh& mesh, int subdivision, const Eigen::Vector3f& center,
                const Eigen::Vector3f& right, const Eigen::Vector3f& up) {
  add_sheet(mesh, subdivision, subdivision, [&](int column, int row) {
    // Symmetric about 0, so that the squares of a cube meet exactly.
    const float x = ratio(2 * column - subdivision, subdivision);
    const float y = ratio(2 * row - subdivision, subdivision);
    return Vertex{center + x * right + y * up,
                  right.cross(up),
                  {ratio(column, subdivision), ratio(row, subdivision)}};
  });
}

void reserve_squares(Mesh& mesh, int subdivision, std::size_t count) {
  const auto n = static_cast<std::size_t>(subdivision);
  reserve(mesh, count * (n + 1) * (n + 1), 2 * count * n * n);
}

Mesh make_wall(int subdivision) {
  Mesh mesh;
  reserve_squares(mesh, subdivision, 1);
  add_square(mesh, subdivision, Eigen::Vector3f::Zero(), Eigen::Vector3f::UnitX(),
             Eigen::Vector3f::UnitY());
  return mesh;
}

Mesh make_grid(int subdivision) {
  Mesh mesh;
  reserve_squares(mesh, subdivision, 1);
  add_square(mesh, subdivision, Eigen::Vector3f::Zero(), Eigen::Vector3f::UnitX(),
             -Eigen::Vector3f::UnitZ());
  return mesh;
}

Mesh make_cube(int subdivision) {
  const Eigen::Vector3f x = Eigen::Vector3f::UnitX();
  const Eigen::Vector3f y = Eigen::Vector3f::UnitY();
  const Eigen::Vector3f z = Eigen::Vector3f::UnitZ();
  Mesh mesh;
  reserve_squares(mesh, subdivision, 6);
  add_square(mesh, subdivision, z, x, y);
  add_square(mesh, subdivision, x, -z, y);
  add_square(mesh, subdivision, -z, -x, y);
  add_square(mesh, subdivision, -x, z, y);
  add_square(mesh, subdivision, y, x, -z);
  add_square(mesh, subdivision, -y, x, z);
  mesh.colors.reserve(mesh.positions.size());
  for (const Eigen::Vector3f& position : mesh.positions) {
    mesh.colors.emplace_back((position + Eigen::Vector3f::Ones()) / 2);
  }
  return mesh;
}

// ---- Spheres

Vertex on_unit_sphere(const Eigen::Vector3f& position, float u, float v) {
  return {position, position, {u, v}};
}

/// The triangles that join the first or last ring of a UV sphere to its pole. Each has a vertex of
/// its own at the pole, whose u is the middle of its column.
void add_polar_cap(Mesh& mesh, int columns, std::uint32_t ring, float pole_y) {
  for (int column = 0; column < columns; ++column) {
    const float u = ratio(2 * column + 1, 2 * columns);
    const std::uint32_t pole =
        add_vertex(mesh, on_unit_sphere(pole_y * Eigen::Vector3f::UnitY(), u, (1 + pole_y) / 2));
    const std::uint32_t west = ring + static_cast<std::uint32_t>(column);
    const std::uint32_t east = west + 1;
    if (pole_y > 0) {
      mesh.triangles.push_back({west, east, pole});
    } else {
      mesh.triangles.push_back({east, west, pole});
    }
  }
}

Mesh make_uv_sphere(int rings) {
  const int columns = 2 * rings;
  const auto circle = points_on_circle(columns);
  Mesh mesh;
  const auto n = static_cast<std::size_t>(rings);
  reserve(mesh, (2 * n + 1) * (n + 1), 4 * n * (n - 1));
  add_sheet(mesh, columns, rings - 2, [&](int column, int row) {
    const Eigen::Vector2f& meridian = circle[static_cast<std::size_t>(column)];
    const Eigen::Vector2f& latitude = circle[static_cast<std::size_t>(row) + 1];  // from -y
    return on_unit_sphere(
        {-latitude.y() * meridian.y(), -latitude.x(), -latitude.y() * meridian.x()},
        ratio(column, columns), ratio(row + 1, rings));
  });
  const auto ring_size = static_cast<std::uint32_t>(columns) + 1;
  const std::uint32_t last_ring = static_cast<std::uint32_t>(rings - 2) * ring_size;
  add_polar_cap(mesh, columns, 0, -1);
  add_polar_cap(mesh, columns, last_ring, 1);
  return mesh;
}

/// Positions and triangles of an icosahedron with a vertex at either pole, the first and the last.
Mesh make_icosahedron() {
  Mesh mesh;
  mesh.positions.push_back(-Eigen::Vector3f::UnitY());
  for (int ring = 0; ring < 2; ++ring) {  // 5 vertices at latitude -atan(1/2), 5 at +atan(1/2)
    for (int i = 0; i < 5; ++i) {
      const double longitude = 2 * pi * (i + 0.5 * ring) / 5;
      const Eigen::Vector3d position(2 * std::sin(longitude), 2 * ring - 1,
                                     2 * std::cos(longitude));
      mesh.positions.emplace_back(position.normalized().cast<float>());
    }
  }
  mesh.positions.push_back(Eigen::Vector3f::UnitY());
  for (std::uint32_t i = 0; i < 5; ++i) {
    const std::uint32_t south = 1 + i;
    const std::uint32_t south_east = 1 + (i + 1) % 5;
    const std::uint32_t north = south + 5;
    const std::uint32_t north_east = south_east + 5;
    mesh.triangles.push_back({0, south_east, south});
    mesh.triangles.push_back({south, south_east, north});
    mesh.triangles.push_back({north, south_east, north_east});
    mesh.triangles.push_back({north, north_east, 11});
  }
  return mesh;
}

/// Splits every triangle into four; the new vertices lie on the unit sphere over the middles of
/// edges.
void split_triangles(Mesh& mesh) {
  std::unordered_map<std::uint64_t, std::uint32_t> middles;
  middles.reserve(mesh.triangles.size() * 3 / 2);
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const std::uint64_t edge = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
    const auto [found, is_new] =
        middles.try_emplace(edge, static_cast<std::uint32_t>(mesh.positions.size()));
    if (is_new) {
      const Eigen::Vector3f sum = mesh.positions[a] + mesh.positions[b];
      mesh.positions.emplace_back(sum.normalized());
    }
    return found->second;
  };
  std::vector<Mesh::Triangle> smaller;
  smaller.reserve(4 * mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::uint32_t ab = middle(a, b);
    const std::uint32_t bc = middle(b, c);
    const std::uint32_t ca = middle(c, a);
    smaller.push_back({a, ab, ca});
    smaller.push_back({ab, b, bc});
    smaller.push_back({ca, bc, c});
    smaller.push_back({ab, bc, ca});
  }
  mesh.triangles = std::move(smaller);
}

bool is_pole(const Eigen::Vector3f& position) {
  return position.x() == 0 && position.z() == 0;
}

/// Longitude and latitude as texture coordinates, u in [0, 1).
Eigen::Vector2f world_map(const Eigen::Vector3f& position) {
  const Eigen::Vector3d p = position.cast<double>();
  const double u = 0.5 + std::atan2(p.x(), p.z()) / (2 * pi);
  const double v = 0.5 + std::asin(std::clamp(p.y(), -1.0, 1.0)) / pi;
  return {u < 1 ? static_cast<float>(u) : 0.0F, static_cast<float>(v)};
}

std::uint32_t add_copy(Mesh& mesh, std::uint32_t vertex, float u) {
  mesh.positions.push_back(Eigen::Vector3f(mesh.positions[vertex]));
  mesh.texture_coordinates.emplace_back(u, mesh.texture_coordinates[vertex].y());
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

/// Where a triangle crosses the seam, its corners east of it get twins whose u is greater by 1.
void split_seam(Mesh& mesh) {
  std::unordered_map<std::uint32_t, std::uint32_t> twins;
  const auto u_of = [&](std::uint32_t vertex) { return mesh.texture_coordinates[vertex].x(); };
  for (Mesh::Triangle& triangle : mesh.triangles) {
    float greatest = 0;
    for (const auto vertex : triangle) {
      if (!is_pole(mesh.positions[vertex])) greatest = std::max(greatest, u_of(vertex));
    }
    for (auto& vertex : triangle) {
      if (is_pole(mesh.positions[vertex]) || greatest - u_of(vertex) <= 0.5F) continue;
      const auto [twin, is_new] = twins.try_emplace(vertex, 0);
      if (is_new) twin->second = add_copy(mesh, vertex, u_of(vertex) + 1);
      vertex = twin->second;
    }
  }
}

/// Gives each triangle at a pole a corner of its own there, its u between those of the two others.
void split_poles(Mesh& mesh) {
  std::vector<bool> taken(mesh.positions.size(), false);
  for (Mesh::Triangle& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t pole = triangle[i];
      if (!is_pole(mesh.positions[pole])) continue;
      const float u = (mesh.texture_coordinates[triangle[(i + 1) % 3]].x() +
                       mesh.texture_coordinates[triangle[(i + 2) % 3]].x()) /
                      2;
      if (taken[pole]) {
        triangle[i] = add_copy(mesh, pole, u);
      } else {
        mesh.texture_coordinates[pole].x() = u;
        taken[pole] = true;
      }
    }
  }
}

Mesh make_icosphere(int subdivision) {
  Mesh mesh = make_icosahedron();
  for (int i = 0; i < subdivision; ++i) split_triangles(mesh);
  mesh.texture_coordinates.reserve(mesh.positions.size());
  for (const auto& position : mesh.positions) {
    mesh.texture_coordinates.push_back(world_map(position));
  }
  split_seam(mesh);
  split_poles(mesh);
  mesh.normals = mesh.positions;
  return mesh;
}

// ---- Tubes

/// A point of the curve that a tube follows, and two unit vectors across it: seen along the curve,
/// `side` turned by a quarter against the clock is `up`.
struct TubeSection {
  Eigen::Vector3f center;
  Eigen::Vector3f side;
  Eigen::Vector3f up;
};

/// A closed tube; section(angle) for angles in [0, 2π) describes the curve.
template <class SectionAt>
Mesh make_tube(int sections, int sides, float radius, const SectionAt& section_at) {
  std::vector<TubeSection> curve;
  for (int i = 0; i < sections; ++i) curve.push_back(section_at(2 * pi * i / sections));
  curve.push_back(curve.front());
  const auto circle = points_on_circle(sides);
  Mesh mesh;
  reserve(mesh, curve.size() * circle.size(),
          2 * static_cast<std::size_t>(sections) * static_cast<std::size_t>(sides));
  add_sheet(mesh, sections, sides, [&](int column, int row) {
    const TubeSection& section = curve[static_cast<std::size_t>(column)];
    const Eigen::Vector2f& direction = circle[static_cast<std::size_t>(row)];
    const Eigen::Vector3f normal =
        (direction.x() * section.side + direction.y() * section.up).normalized();
    return Vertex{
        section.center + radius * normal, normal, {ratio(column, sections), ratio(row, sides)}};
  });
  return mesh;
}

Mesh make_torus(int subdivision) {
  return make_tube(2 * subdivision, subdivision, 0.3F, [](double angle) {
    const Eigen::Vector3d side(std::cos(angle), 0, -std::sin(angle));
    return TubeSection{(0.7 * side).cast<float>(), side.cast<float>(), Eigen::Vector3f::UnitY()};
  });
}

/// The knot lies on a torus of radii 0.6 and 0.25, whose normal is always at right angles to it: a
/// frame that closes.
TubeSection trefoil(double t) {
  const double ring = 0.6;
  const double tube = 0.25;
  const Eigen::Vector3d outward(std::cos(2 * t), 0, -std::sin(2 * t));
  const Eigen::Vector3d forward(-std::sin(2 * t), 0, -std::cos(2 * t));
  const Eigen::Vector3d normal =
      std::cos(3 * t) * outward + std::sin(3 * t) * Eigen::Vector3d::UnitY();
  const Eigen::Vector3d along_tube =
      -std::sin(3 * t) * outward + std::cos(3 * t) * Eigen::Vector3d::UnitY();
  const Eigen::Vector3d center = ring * outward + tube * normal;
  const Eigen::Vector3d tangent =
      2 * (ring + tube * std::cos(3 * t)) * forward + 3 * tube * along_tube;
  return {center.cast<float>(), tangent.normalized().cross(normal).cast<float>(),
          normal.cast<float>()};
}

Mesh make_torus_knot(int subdivision) {
  return make_tube(8 * subdivision, subdivision, 0.15F, trefoil);
}

const Shape& find_shape(std::string_view name) {
  std::string known;
  for (const Shape& shape : shapes()) {
    if (shape.name == name) return shape;
    known += (known.empty() ? "" : ", ") + shape.name;
  }
  throw InputError("there is no built-in mesh '" + std::string(name) + "'; there are " + known);
}

}  // namespace

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all = {
      {"cube", "cube with coloured corners", 1, 1, 2364, &make_cube},
      {"wall", "upright square, textured", 1, 1, 5792, &make_wall},
      {"grid", "level square, textured", 16, 1, 5792, &make_grid},
      {"uv_sphere", "sphere of rings and columns, textured as a globe", 32, 2, 4096,
       &make_uv_sphere},
      {"icosphere", "sphere of equal triangles, textured as a globe", 4, 0, 10, &make_icosphere},
      {"torus", "ring", 32, 3, 4096, &make_torus},
      {"torus_knot", "trefoil knot", 24, 3, 2048, &make_torus_knot},
  };
  return all;
}

Mesh make_shape(std::string_view name, int subdivision) {
  const Shape& shape = find_shape(name);
  if (subdivision < shape.minimum_subdivision || subdivision > shape.maximum_subdivision) {
    throw InputError("the subdivision of '" + shape.name + "' is " +
                     std::to_string(shape.minimum_subdivision) + " to " +
                     std::to_string(shape.maximum_subdivision) + ", not " +
                     std::to_string(subdivision));
  }
  return shape.make(subdivision);
}

Mesh make_shape(std::string_view name_and_subdivision) {
  const std::size_t colon = name_and_subdivision.find(':');
  const std::string_view name = name_and_subdivision.substr(0, colon);
  if (colon == std::string_view::npos) return make_shape(name, find_shape(name).subdivision);
  const std::string_view digits = name_and_subdivision.substr(colon + 1);
  int subdivision = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), subdivision);
  if (error != std::errc() || end != digits.data() + digits.size()) {
    throw InputError("'" + std::string(digits) + "' in '" + std::string(name_and_subdivision) +
                     "' is no subdivision: a whole number was expected");
  }
  return make_shape(name, subdivision);
}

}  // namespace rasterlab
