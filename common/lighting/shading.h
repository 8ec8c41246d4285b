// Exercise 05.5, a ladder: how often the light is computed: once a face, once a vertex, once a
// pixel.
#pragma once

#include "common/lighting/lit_mesh.h"
#include "common/projection/draw_mesh.h"
#include "common/projection/frame.h"

#include <array>

namespace rasterlab {

/// One rung: draws the mesh, nearest triangles winning. Positions, normals and directions are those
/// of the world; normals move by normal_matrix() of the model. Nothing is lit from behind: a
/// surface turned away from the light gets ambient light alone. Throws CheckError when the mesh has
/// no normals where it needs them.
using ShadeFunction = DrawCounts (*)(const LitMesh& lit_mesh, Frame& frame);

/// One colour for each face, from the face's own normal, at its centroid, with the mean of its
/// corners' colours. Needs no vertex normals. Cost: one reflection a face of which a pixel is seen.
DrawCounts shade_flat(const LitMesh& lit_mesh, Frame& frame);

/// Lit at the vertices, by light_vertices() of exercise 05.4, and the colours interpolated: H.
/// Gouraud, "Continuous Shading of Curved Surfaces", IEEE Transactions on Computers C-20(6), 1971.
/// Cost: one reflection a vertex.
DrawCounts shade_gouraud(const LitMesh& lit_mesh, Frame& frame);

/// Lit at every pixel: position, normal and colour are interpolated, and the normal made a unit
/// vector again: B. T. Phong, "Illumination for Computer Generated Pictures", CACM 18(6), 1975.
/// Cost: one reflection a pixel that is nearer than what was there.
DrawCounts shade_phong(const LitMesh& lit_mesh, Frame& frame);

/// The ladder, worst first.
///
/// Source: B.gouraud, A.Q34, C.4.
struct ShadingRung {
  const char* name;
  ShadeFunction shade;
  const char* known_fault;
};
extern const std::array<ShadingRung, 3> shading_ladder;

}  // namespace rasterlab
