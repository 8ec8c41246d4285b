// OpenMesh's messages to the terminal: a user should see only ours.
#pragma once

namespace rasterlab {

/// They are off while this lives.
class OpenMeshSilence {
 public:
  OpenMeshSilence();
  ~OpenMeshSilence();
  OpenMeshSilence(const OpenMeshSilence&) = delete;
  OpenMeshSilence& operator=(const OpenMeshSilence&) = delete;
};

}  // namespace rasterlab
