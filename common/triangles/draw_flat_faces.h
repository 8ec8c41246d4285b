// Exercise 02.7, second part: every face as bright as the light falls on it.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"
#include "common/mesh/mesh.h"

namespace rasterlab {

/// How much light, from 0 to 1, falls on a face with the unit normal n when it comes in direction
/// (0, 0, −1), from the viewer: −n · (0, 0, −1), or 0 where that is negative: the face is turned
/// away.
float flat_intensity(const Eigen::Vector3f& normal);

/// Fills the faces of a mesh seen along z (seen_along_z()) in the order of the mesh, each in the
/// grey of its flat_intensity(), by its face normal, (b − a) × (c − a) normalised. Faces turned
/// away, intensity 0, are left out. Later faces cover earlier ones, whichever is nearer: what is
/// wrong with that, stage 03 repairs.
///
/// Faces without area, and faces with a corner beyond ±2^30 pixels or not a number, are left out. A
/// right answer is within 1 of 255 in every channel. Cost: the pixels covered.
///
/// Source: B.flat.
void draw_flat_faces(Image<Rgb8>& image, const Mesh& mesh);

}  // namespace rasterlab
