// Exercise 06.2: a mesh with a picture on it, in the light of stage 05.
#pragma once

#include "common/lighting/shading.h"
#include "common/projection/frame.h"
#include "common/texture/sample.h"

namespace rasterlab {

/// Throws InputError when the mesh has no texture coordinates.
void require_texture_coordinates(const Mesh& mesh);

/// Draws the mesh, nearest triangles winning, each pixel lit by itself as shade_phong() of
/// common/lighting does it, its surface's colour being what the sampler reads at the pixel's
/// (u, v): interpolated perspective-correctly, with exact derivatives for the filter. The mesh's
/// own colours and `lit_mesh.color` count for nothing.
///
/// Throws InputError when the mesh has no texture coordinates, CheckError when it has no normals.
/// Cost: one sample of the texture and one reflection a pixel that is nearer than what was there.
/// Source: A.Q33, B.mission.
DrawCounts draw_textured_mesh(const LitMesh& lit_mesh, const Sampler& sampler, Frame& frame);

}  // namespace rasterlab
