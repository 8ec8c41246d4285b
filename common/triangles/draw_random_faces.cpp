#include "common/triangles/draw_random_faces.h"

#include "common/triangles/face_corners.h"
#include "common/triangles/fill_spans.h"

#include <random>

namespace rasterlab {

void draw_random_faces(Image<Rgb8>& image, const Mesh& mesh, std::uint32_t seed) {
  std::mt19937 random(seed);
  for (const Mesh::Triangle& triangle : mesh.triangles) {
    const auto bits = random();
    const auto byte = [bits](int shift) { return static_cast<std::uint8_t>(bits >> shift); };
    const Corners corners = face_corners(mesh, triangle, image.width(), image.height());
    if (!within(corners, max_wide_coordinate)) continue;
    fill_spans(image, corners, Rgb8{byte(0), byte(8), byte(16)});
  }
}

}  // namespace rasterlab
