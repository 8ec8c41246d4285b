// The shaders of stage 07, each put together in one line.
#pragma once

#include "common/shaders/color_sources.h"
#include "common/shaders/face_normal.h"
#include "common/shaders/gouraud.h"
#include "common/shaders/highlights.h"
#include "common/shaders/light_models.h"
#include "common/shaders/normal_maps.h"
#include "common/shaders/quantized.h"
#include "common/shaders/surface.h"
#include "common/shaders/vertex_normal.h"

namespace rasterlab {

// With a colour source of one's choice: ConstantColor, VertexColor or TextureColor.
template <class ColorSource>
using Plain = Surface<ColorSource, FaceNormal, Unlit>;
template <class ColorSource>
using Flat = Surface<ColorSource, FaceNormal, Diffuse>;
template <class ColorSource>
using GouraudSurface = Surface<ColorSource, VertexNormal, Gouraud<Diffuse>>;
template <class ColorSource>
using QuantizedGouraud = Surface<ColorSource, VertexNormal, Quantized<Gouraud<Diffuse>>>;
template <class ColorSource>
using BumpedInObjectSpace = Surface<ColorSource, ObjectSpaceNormalMap, Diffuse>;
template <class ColorSource>
using Bumped = Surface<ColorSource, TangentSpaceNormalMap, Diffuse>;
template <class ColorSource>
using GouraudHighlight = Surface<ColorSource, VertexNormal, Gouraud<Phong>>;
template <class ColorSource>
using PhongSurface = Surface<ColorSource, VertexNormal, Phong>;
template <class ColorSource>
using BlinnPhongSurface = Surface<ColorSource, VertexNormal, BlinnPhong>;
template <class ColorSource>
using BumpedPhong = Surface<ColorSource, TangentSpaceNormalMap, Phong>;
template <class ColorSource>
using BumpedShinyPhong = Surface<ColorSource, TangentSpaceNormalMap, SpecularMapped<Phong>>;

}  // namespace rasterlab
