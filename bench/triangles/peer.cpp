#include "bench/triangles/peer.h"

#include <array>

#include <opencv2/imgproc.hpp>

namespace rasterlab::bench {

std::function<void()> opencv_triangles(Image<Rgb8>& image, const std::vector<Corners>& triangles,
                                       const Rgb8& color) {
  constexpr int fraction_bits = 8;
  // OpenCV's pixel centres have whole coordinates.
  const auto coordinate = [](double pixels) { return static_cast<int>(snap(pixels - 0.5)); };
  std::vector<std::array<cv::Point, 3>> polygons;
  for (const Corners& corners : triangles) {
    std::array<cv::Point, 3>& polygon = polygons.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      polygon[i] = {coordinate(corners[i].x()), coordinate(corners[i].y())};
    }
  }
  cv::setNumThreads(1);
  const cv::Mat picture(image.height(), image.width(), CV_8UC3, image.row(0));
  const cv::Scalar scalar(color.r, color.g, color.b);
  return [polygons, picture, scalar]() mutable {
    for (const auto& polygon : polygons)
      cv::fillConvexPoly(picture, polygon.data(), 3, scalar, cv::LINE_8, fraction_bits);
  };
}

}  // namespace rasterlab::bench
