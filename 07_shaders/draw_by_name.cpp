#include "07_shaders/draw_by_name.h"

#include "common/shaders/draw_shaded.h"

#include "07_shaders/shader_list.h"

namespace rasterlab {

DrawCounts draw_by_name(const std::string& shader, const ShaderInputs& inputs, Cull cull,
                        Frame& frame) {
  return with_shader(shader_list, shader, inputs, [&](const auto& made) {
    return draw_shaded(inputs.mesh, inputs.transforms, cull, made, frame);
  });
}

Image<Rgb8> picture_by_name(const std::string& shader, const ShaderInputs& inputs, Size size) {
  Frame frame = make_frame(size.width, size.height);
  draw_by_name(shader, inputs, Cull::none, frame);
  return frame.color;
}

}  // namespace rasterlab
