// Every shader there is. A new one is a header in common/shaders, all of which are included here,
// and a line: from it come `--shader NAME`, the exercise code's rendering loop and the engine's,
// and a place in the picture of them all.
#pragma once

#include "common/shaders/every_shader.h"  // made by common/CMakeLists.txt

#include <tuple>

namespace rasterlab {

inline constexpr std::tuple shader_list = {
    shader<Plain>("color", "the surface's colour, without light"),
    shader<Plain<TextureColor>>("texture", "a texture, without light"),
    shader<Flat>("flat", "diffuse light, one normal a face"),
    shader<Flat<TextureColor>>("flat_texture", "the same on a texture"),
    shader<GouraudSurface>("gouraud", "diffuse light at the corners, mixed between them"),
    shader<GouraudSurface<TextureColor>>("gouraud_texture", "the same on a texture"),
    shader<QuantizedGouraud>("quantized", "the same in five levels"),
    shader<BumpedInObjectSpace>("normal_object",
                                "diffuse light, normals from a map in object space"),
    shader<Bumped>("normal", "diffuse light, normals from a map in tangent space"),
    shader<Bumped<TextureColor>>("normal_texture", "the same on a texture"),
    shader<PhongSurface>("phong", "Phong's light at every pixel"),
    shader<BumpedPhong>("phong_normal", "the same with a normal map"),
    shader<PhongSurface<TextureColor>>("phong_texture", "Phong's light on a texture"),
    shader<BumpedPhong<TextureColor>>("phong_normal_texture", "the same with a normal map"),
    shader<BumpedShinyPhong<TextureColor>>("phong_all_maps", "and with a map of what shines"),
    shader<BlinnPhongSurface>("blinn_phong", "Blinn's highlight in place of Phong's"),
    shader<BlinnPhongSurface<TextureColor>>("blinn_phong_texture", "the same on a texture"),
    shader<Lattice>("lattice", "with holes: pixels are discarded"),
};

}  // namespace rasterlab
