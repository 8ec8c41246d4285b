#include "common/mesh/openmesh_silence.h"

#include <OpenMesh/Core/System/omstream.hh>

namespace rasterlab {

OpenMeshSilence::OpenMeshSilence() {
  omerr().disable();
}

OpenMeshSilence::~OpenMeshSilence() {
  omerr().enable();
}

}  // namespace rasterlab
