// A mesh in a light, as the probes of stages 05 to 07 draw it.
#pragma once

#include "common/lighting/lit_mesh.h"
#include "common/projection/look_at.h"
#include "common/projection/perspective.h"

#include "grading/probes/probe.h"

namespace rasterlab::grading {

/// The mesh turned, moved and unevenly scaled, in a light near by, before an eye near by.
inline LitMesh lit_mesh(SceneInputs& scene, const Mesh& mesh) {
  Transforms way;
  const Eigen::AngleAxisf turn{scene.real(0, 3), scene.direction()};
  way.model.topLeftCorner<3, 3>() =
      turn.toRotationMatrix() * Eigen::Vector3f(0.6F, 1, 0.8F).asDiagonal();
  way.model.topRightCorner<3, 1>() = scene.vector(-0.2F, 0.2F);
  way.view = look_at(scene.vector(1, 2), {0, 0, 0}, {0, 1, 0});
  way.projection = perspective(50, 1.2F, 0.1F, 20);
  LitMesh lit{.mesh = mesh, .transforms = way, .light = {}, .material = {}};
  lit.light.position = scene.vector(1, 3).homogeneous();
  lit.material.shininess = 8;
  lit.color = scene.color();
  return lit;
}

}  // namespace rasterlab::grading
