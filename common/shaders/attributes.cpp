#include "common/shaders/attributes.h"

#include "common/mesh/normals.h"
#include "common/projection/normal_matrix.h"
#include "common/shaders/face_tangent.h"

namespace rasterlab {

VertexColors::VertexColors(const ShaderInputs& inputs) {
  if (inputs.mesh.colors.empty()) throw InputError("this shader needs a mesh with colours");
}

VertexNormals::VertexNormals(const ShaderInputs& inputs)
    : to_world(normal_matrix(inputs.transforms.model)) {
  if (inputs.mesh.normals.empty()) throw InputError("this shader needs a mesh with normals");
}

VertexNormals::Varying<float> VertexNormals::at(const Mesh& mesh, std::uint32_t triangle,
                                                int corner) const {
  return {transform_normal(to_world, mesh.normals[vertex_of(mesh, triangle, corner)])};
}

FaceNormals::FaceNormals(const ShaderInputs& inputs)
    : to_world(normal_matrix(inputs.transforms.model)) {}

FaceNormals::Varying<float> FaceNormals::at(const Mesh& mesh, std::uint32_t triangle,
                                            int /*corner*/) const {
  return {transform_normal(to_world, face_normal(mesh, triangle))};
}

Tangents::Tangents(const ShaderInputs& inputs)
    : to_world(inputs.transforms.model.topLeftCorner<3, 3>()),
      handedness(to_world.cast<double>().determinant() < 0 ? -1.0F : 1.0F) {
  require_texture_coordinates(inputs.mesh);
}

Tangents::Varying<float> Tangents::at(const Mesh& mesh, std::uint32_t triangle,
                                      int /*corner*/) const {
  const auto& [a, b, c] = mesh.triangles[triangle];
  const FaceTangent face = face_tangent(
      {mesh.positions[a], mesh.positions[b], mesh.positions[c]},
      {mesh.texture_coordinates[a], mesh.texture_coordinates[b], mesh.texture_coordinates[c]});
  return {(to_world * face.tangent).stableNormalized(), handedness * face.handedness};
}

}  // namespace rasterlab
