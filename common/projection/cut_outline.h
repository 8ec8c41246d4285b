// Which pixels a triangle covers that is thinner than the 1/256 pixel its corners are snapped to.
//
// Corners, and the new ones where it is cut, are snapped each by itself. What is that thin may be
// turned over by it, all of it or, if it is cut, the one end of it, and then lies on its
// neighbours: drawn, it would cover their pixels a second time.
#pragma once

#include "common/projection/clip.h"
#include "common/triangles/edge_function.h"

#include <cstddef>
#include <vector>

namespace rasterlab {

/// Which way round a triangle's corners go as it is seen, wherever they are: the sign of the
/// determinant of their (x, y, w), in double precision. 1 clockwise in the window, −1
/// counter-clockwise, 0 where the eye is in its plane, nearer than doubles can say.
int seen_side(const ClipTriangle& triangle);

/// The snapped outline of what clipping has left of a triangle.
///
/// A pixel is the triangle's where the outline winds round its centre the way the triangle is seen.
/// Where the outline winds the other way, or there and back, it is not. Windings add up: along the
/// edges of neighbours what the one's winds the other's unwinds. So of triangles that share edges
/// one at least has each pixel that their common outline winds round, and only one, unless a third
/// at that very pixel is turned over.
///
/// Where one side is culled, a triangle that is not cut shows the side on which it lies, turned
/// over or not: so leaving out its back faces takes no pixel from a closed mesh.
///
/// Of a triangle in whose plane the eye is the side counts that shows the larger area after
/// snapping.
class CutOutline {
 public:
  CutOutline(const ClipTriangle& triangle, const ClipPolygon& polygon, int width, int height);

  /// Whether pixel (x, y) is the triangle's, and this the first of its pieces to cover it.
  bool gives(int x, int y, std::size_t piece) const;

 private:
  struct SnappedPiece {
    TriangleEdges edges;
    int side = 0;  ///< 1 clockwise in the window, −1 counter-clockwise, 0 covers nothing

    bool covers(int x, int y) const;
  };

  std::vector<SnappedPiece> pieces_;
  int side_;  ///< of the triangle as it is seen
};

}  // namespace rasterlab
