// A right answer written differently: position and normal moved by hand, then lit by the model of
// reflection.
#include "common/lighting/light_vertices.h"

#include "common/image/check.h"
#include "common/lighting/blinn_phong.h"
#include "common/lighting/phong.h"
#include "common/lighting/surface_lighting.h"
#include "common/projection/eye.h"
#include "common/projection/normal_matrix.h"

namespace rasterlab {

std::vector<Color> light_vertices(const LitMesh& lit_mesh) {
  const Mesh& mesh = lit_mesh.mesh;
  if (mesh.normals.size() != mesh.positions.size()) throw CheckError("the mesh has no normals");
  const Eigen::Matrix4f& model = lit_mesh.transforms.model;
  const Eigen::Matrix3f to_world = normal_matrix(model);
  const Eigen::Vector4f eye = eye_of(lit_mesh.transforms);
  std::vector<Color> colors;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Eigen::Vector3f position = (model * mesh.positions[i].homogeneous()).head<3>();
    const Eigen::Vector3f normal = transform_normal(to_world, mesh.normals[i]);
    const Eigen::Vector3f l = direction_to(lit_mesh.light.position, position);
    const Eigen::Vector3f e = direction_to(eye, position);
    const bool is_phong = lit_mesh.model == ReflectionModel::phong;
    const Reflection<float> reflection =
        is_phong ? phong(normal, l, e, lit_mesh.light, lit_mesh.material)
                 : blinn_phong(normal, l, e, lit_mesh.light, lit_mesh.material);
    Color own = mesh.colors.empty() ? Color::Constant(0.75F).eval() : mesh.colors[i];
    if (lit_mesh.color) own = *lit_mesh.color;
    colors.push_back(lit(own, reflection));
  }
  return colors;
}

}  // namespace rasterlab
