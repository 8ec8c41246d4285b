#include "common/projection/cut_outline.h"

#include "common/projection/clip_piece.h"

#include <algorithm>

namespace rasterlab {
namespace {

int sign(double value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

}  // namespace

int seen_side(const ClipTriangle& triangle) {
  const Eigen::Vector4d a = triangle[0].cast<double>();  // products of two of them are exact
  const Eigen::Vector4d b = triangle[1].cast<double>();
  const Eigen::Vector4d c = triangle[2].cast<double>();
  const double determinant = a.x() * (b.y() * c.w() - b.w() * c.y()) +
                             a.y() * (b.w() * c.x() - b.x() * c.w()) +
                             a.w() * (b.x() * c.y() - b.y() * c.x());
  return -sign(determinant);  // y is up here
}

CutOutline::CutOutline(const ClipTriangle& triangle, const ClipPolygon& polygon, int width,
                       int height)
    : side_(seen_side(triangle)) {
  double area = 0;
  for (std::size_t first = 1; first + 1 < polygon.size(); ++first) {
    SnappedPiece& piece = pieces_.emplace_back();
    const auto seen = to_window(piece_of(polygon, first), width, height);
    if (!seen) continue;
    const SnappedTriangle snapped = snap(seen->position);
    const auto piece_area = static_cast<double>(cross(snapped[0], snapped[1], snapped[2]));
    piece = {make_edges(snapped), sign(piece_area)};
    area += piece_area;
  }
  if (side_ == 0) side_ = sign(area);
}

bool CutOutline::gives(int x, int y, std::size_t piece) const {
  if (pieces_[piece].side != side_) return false;
  int winding = 0;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if (!pieces_[i].covers(x, y)) continue;
    if (pieces_[i].side == side_ && i < piece) return false;
    winding += pieces_[i].side;
  }
  return winding * side_ > 0;
}

bool CutOutline::SnappedPiece::covers(int x, int y) const {
  return side != 0 && std::all_of(edges.edges.begin(), edges.edges.end(), [&](const auto& edge) {
           return edge.at(x, y) >= edge.threshold();
         });
}

}  // namespace rasterlab
