#include "bench/lines/peer.h"

#include <utility>

#include <opencv2/imgproc.hpp>

namespace rasterlab::bench {

std::function<void()> opencv_lines(Image<Rgb8>& image, const std::vector<Segment>& segments,
                                   const Rgb8& color) {
  std::vector<std::pair<cv::Point, cv::Point>> lines;
  for (const auto& [p0, p1] : segments) {
    lines.emplace_back(cv::Point(p0.x(), p0.y()), cv::Point(p1.x(), p1.y()));
  }
  cv::setNumThreads(1);
  const cv::Mat picture(image.height(), image.width(), CV_8UC3, image.row(0));
  const cv::Scalar scalar(color.r, color.g, color.b);
  return [lines, picture, scalar]() mutable {
    for (const auto& [from, to] : lines) cv::line(picture, from, to, scalar, 1, cv::LINE_8);
  };
}

}  // namespace rasterlab::bench
