#include "03_zbuffer/figures.h"

#include "common/image/operations.h"
#include "common/mesh/read_mesh.h"
#include "common/stage/given_files.h"
#include "common/zbuffer/draw_depth_line.h"
#include "common/zbuffer/draw_depth_triangle.h"
#include "common/zbuffer/draw_flat_depth.h"

#include "03_zbuffer/inputs.h"

#include <sstream>

namespace rasterlab {
namespace {

constexpr Size figure_size{200, 200};

/// Near white, far black, so that what is near stands out.
Image<std::uint8_t> depth_picture(const DepthBuffer& depth) {
  return grey_picture(depth.depths(), 1.0F, -1.0F);
}

const char* yes_or_no(bool value) {
  return value ? "seen" : "hidden";
}

}  // namespace

void show_depth_buffer(Run& run) {
  DepthBuffer depth(4, 3);
  std::ostringstream text;
  text << "a depth buffer of 4x3 pixels, cleared to " << depth.depths()(2, 1) << "\n";
  for (const float z : {0.5F, 0.75F, 0.5F, 0.25F}) {
    const bool seen = depth.test(2, 1, z);
    if (seen) depth.write(2, 1, z);
    text << "z = " << z << " at (2, 1): " << yes_or_no(seen) << "; the buffer holds "
         << depth.depths()(2, 1) << "\n";
  }
  run.printout("03.1_depth_buffer", text.str());
}

void draw_points(Run& run) {
  constexpr int count = 17;
  constexpr int middle = count / 2;
  Image<Rgb8> image(count, count);
  DepthBuffer depth(count, count);
  for (int x = 0; x < count; ++x) {
    for (int y = 0; y < count; ++y) {
      // From left to right z goes from −2 to 2; each row is drawn over the one before, a little
      // farther or nearer.
      const float z = static_cast<float>(x - middle) / 4;
      draw_point(image, depth, {x, y}, z, {1, 0.8F, 0.3F});
      draw_point(image, depth, {x, y}, z + static_cast<float>(y - middle) / 4, {0.2F, 0.5F, 1});
    }
  }
  run.picture("03.2_points", enlarged(image, 12));
}

void draw_segments(Run& run) {
  const Size size = run.size(figure_size);
  Image<Rgb8> image(size.width, size.height);
  DepthBuffer depth(size.width, size.height);
  const Color white(1, 1, 1);
  const Color red(1, 0.1F, 0.1F);
  const Color blue(0.2F, 0.4F, 1);
  for (int i = 0; i < 12; ++i) {
    const int y = 10 + 16 * i;
    draw_depth_line(image, depth, {{10, y}, -0.9F, white}, {{190, y}, 0.9F, red});
    draw_depth_line(image, depth, {{y, 10}, 0.9F, white}, {{y, 190}, -0.9F, blue});
  }
  run.picture("03.3_segments", image);
}

void draw_interpenetrating(Run& run) {
  const Size size = run.size(figure_size);
  Image<Rgb8> image(size.width, size.height);
  DepthBuffer depth(size.width, size.height);
  for (const auto& triangle : interpenetrating_triangles())
    draw_depth_triangle(image, depth, triangle);
  run.picture("03.4_triangles", image);
  run.picture("03.4_depth", depth_picture(depth));
}

void draw_bunny_with_depth(Run& run) {
  const Size size = run.size({800, 800});
  Image<Rgb8> image(size.width, size.height);
  DepthBuffer depth(size.width, size.height);
  draw_flat_depth(image, depth, read_mesh(bunny_path()));
  run.picture("03.6_flat", image);
  run.picture("03.6_depth", depth_picture(depth));
}

}  // namespace rasterlab
