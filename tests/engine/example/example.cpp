#include "common/engine/renderer.h"
#include "common/image/files.h"
#include "common/mesh/shapes.h"

#include "shader.h"

int main() {
  const rasterlab::Mesh mesh = rasterlab::make_shape("torus_knot:40");
  const rasterlab::PreparedMesh prepared(mesh);
  rasterlab::Framebuffer frame(640, 480);
  rasterlab::Renderer renderer;
  const NormalShader shader;
  renderer.draw({.mesh = &prepared, .shading = rasterlab::shading(shader)}, frame);
  rasterlab::write_image("picture.png", frame.color());
}
