// Pictures: exercises 01.2, 01.3, 01.7, 01.10 and 01.11, and the quick lines.
#include "common/lines/avx512.h"
#include "common/lines/bresenham.h"
#include "common/lines/color_run.h"
#include "common/lines/draw_line.h"
#include "common/lines/draw_line_gradient.h"
#include "common/lines/draw_line_list.h"
#include "common/lines/draw_line_list_avx512.h"
#include "common/lines/draw_line_runs.h"
#include "common/lines/draw_pixels.h"
#include "common/lines/draw_wireframe.h"
#include "common/lines/fading_column.h"
#include "common/lines/line_all_octants.h"
#include "common/lines/line_faults.h"
#include "common/lines/line_interpolation.h"
#include "common/lines/red_pixel.h"
#include "common/mesh/shapes.h"

#include "tests/oracle/exact_segment.h"
#include "tests/support/picture_text.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterlab {
namespace {

constexpr Rgb8 white{255, 255, 255};
constexpr int far = max_point_coordinate;

/// Where an image is not black.
Image<std::uint8_t> drawn(const Image<Rgb8>& image) {
  Image<std::uint8_t> result(image.width(), image.height());
  for (std::size_t i = 0; i < image.pixels().size(); ++i)
    result.pixels()[i] = image.pixels()[i] == Rgb8{} ? 0 : 1;
  return result;
}

/// Segments that lie in, cross, touch and miss a 24 × 18 image in every way, from near and from as
/// far as can be.
std::vector<Segment> segments_around_an_image() {
  std::vector<Segment> segments;
  std::mt19937 random(11);
  for (const int reach : {30, 60, 2000, 1000000, far}) {
    const auto coordinate = [&] {
      return static_cast<int>(random() % (2 * static_cast<unsigned>(reach) + 1)) - reach +
             (reach < 100 ? 10 : 0);
    };
    for (int i = 0; i < 400; ++i)
      segments.push_back({{coordinate(), coordinate()}, {coordinate(), coordinate()}});
    // Through the image, however far the ends are.
    for (int i = 0; i < 400; ++i) {
      const Point middle(static_cast<int>(random() % 24), static_cast<int>(random() % 18));
      const Point away = Point(coordinate(), coordinate()) / 4;
      segments.push_back({middle + away, middle - away});
    }
  }
  for (const int dx : {-1, 0, 1}) {
    for (const int dy : {-1, 0, 1}) {
      segments.push_back({{12, 9}, {12 + dx * (far - 12), 9 + dy * (far - 12)}});
      segments.push_back({{dx * far, dy * far}, {dx * far, dy * far}});
      segments.push_back({{12 + 20 * dx, 9 + 20 * dy}, {12 + 20 * dx, 9 + 20 * dy}});
    }
  }
  segments.push_back({{-far, -far}, {far, far}});
  segments.push_back({{far, -far}, {-far, far}});
  segments.push_back({{-far, 0}, {far, 17}});
  segments.push_back({{0, far}, {23, -far}});
  segments.push_back({{-far, far}, {far, far - 1}});
  return segments;
}

using DrawLine = std::function<void(Image<Rgb8>&, const Point&, const Point&)>;

void expect_right_drawings(const DrawLine& draw) {
  for (const Segment& segment : segments_around_an_image()) {
    Image<Rgb8> image(24, 18);
    draw(image, segment.p0, segment.p1);
    ASSERT_EQ(oracle::drawing_mistake(drawn(image), segment.p0, segment.p1), "");
  }
}

// 01.2

TEST(stage01_red_pixel, the_courses_example) {
  const Image<Rgb8> image = red_pixel(100, 100, 52, 41);
  ASSERT_EQ(image.width(), 100);
  ASSERT_EQ(image.height(), 100);
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 100; ++x) {
      const bool here = x == 52 && y == 58;
      ASSERT_EQ(image(x, y), here ? (Rgb8{255, 0, 0}) : Rgb8{})
          << "(" << x << "," << y << "), rows from the top";
    }
  }
}

TEST(stage01_red_pixel, corners) {
  EXPECT_TRUE(covers_exactly(red_pixel(3, 2, 0, 0), {"...", "#.."}))
      << "row 0 from the bottom is the last row";
  EXPECT_TRUE(covers_exactly(red_pixel(3, 2, 2, 1), {"..#", "..."}));
  EXPECT_THROW(red_pixel(3, 2, 3, 0), CheckError);
  EXPECT_THROW(red_pixel(3, 2, 0, 2), CheckError);
  EXPECT_THROW(red_pixel(3, 2, 0, -1), CheckError);
}

// 01.3

TEST(stage01_draw_fading_column, black_to_white_and_nothing_else) {
  const Rgb8 before{1, 2, 3};
  Image<Rgb8> image(5, 52, before);
  draw_fading_column(image, 3);
  for (int y = 0; y < 52; ++y) {
    for (int x = 0; x < 5; ++x) {
      const auto grey = static_cast<std::uint8_t>(5 * y);
      ASSERT_EQ(image(x, y), x == 3 ? (Rgb8{grey, grey, grey}) : before)
          << "(" << x << "," << y << ")";
    }
  }
}

TEST(stage01_draw_fading_column, any_height) {
  for (int height = 2; height <= 300; height += 7) {
    Image<Rgb8> image(1, height);
    draw_fading_column(image, 0);
    for (int y = 0; y < height; ++y) {
      ASSERT_LE(std::abs(image(0, y).g - 255.0 * y / (height - 1)), 0.5)
          << "row " << y << " of " << height;
    }
  }
}

TEST(stage01_draw_fading_column, one_row_and_none) {
  Image<Rgb8> image(1, 1, white);
  draw_fading_column(image, 0);
  EXPECT_EQ(image(0, 0), Rgb8{}) << "a line of one pixel is black: 0/0 is no number";
  EXPECT_THROW(draw_fading_column(image, 1), CheckError);
  EXPECT_THROW(draw_fading_column(image, -1), CheckError);
}

// 01.7

TEST(stage01_draw_line, small) {
  Image<Rgb8> image(8, 5);
  draw_line(image, {0, 0}, {7, 4}, white);
  EXPECT_TRUE(covers_exactly(image, {"#.......", ".##.....", "...##...", ".....##.", ".......#"}));
}

TEST(stage01_draw_line, wherever_the_ends_are) {
  expect_right_drawings([](Image<Rgb8>& image, const Point& p0, const Point& p1) {
    draw_line(image, p0, p1, white);
  });
}

TEST(stage01_draw_line, are_the_pixels_of_line_all_octants) {
  for (const Segment& segment : random_segments(500, 60)) {
    Image<Rgb8> image(24, 18);
    draw_line(image, segment.p0, segment.p1, white);
    Image<Rgb8> expected(24, 18);
    draw_pixels(expected, line_all_octants(segment.p0, segment.p1), white);
    ASSERT_TRUE(same_picture(picture_text(image), picture_text(expected)));
  }
}

TEST(stage01_draw_line, keeps_what_is_beside_it) {
  Image<Rgb8> image(9, 3, Rgb8{9, 9, 9});
  draw_line(image, {-5, 1}, {20, 1}, Rgb8{1, 2, 3});
  for (int x = 0; x < 9; ++x) {
    EXPECT_EQ(image(x, 0), (Rgb8{9, 9, 9}));
    EXPECT_EQ(image(x, 1), (Rgb8{1, 2, 3}));
    EXPECT_EQ(image(x, 2), (Rgb8{9, 9, 9}));
  }
}

TEST(stage01_draw_line, empty_image_and_ends_too_far) {
  Image<Rgb8> empty;
  EXPECT_NO_THROW(draw_line(empty, {0, 0}, {5, 5}, white));
  Image<Rgb8> image(4, 4);
  EXPECT_THROW(draw_line(image, {0, 0}, {far + 1, 0}, white), CheckError);
  EXPECT_THROW(draw_line(image, {0, std::numeric_limits<int>::min()}, {0, 0}, white), CheckError);
}

TEST(stage01_draw_line, the_check_finds_each_mistake) {
  const auto mistake = [](const std::vector<Point>& pixels) {
    Image<std::uint8_t> image(5, 3);
    for (const Point& pixel : pixels) image(pixel.x(), pixel.y()) = 1;
    return oracle::drawing_mistake(image, {-2, 0}, {6, 2});
  };
  using testing::HasSubstr;
  EXPECT_EQ(mistake({{0, 1}, {1, 1}, {2, 1}, {3, 1}, {4, 1}}), "");
  EXPECT_EQ(mistake({{0, 0}, {1, 1}, {2, 1}, {3, 1}, {4, 2}}), "") << "ties either way";
  EXPECT_THAT(mistake({{0, 0}, {1, 1}, {3, 1}, {4, 2}}), HasSubstr("no pixel in column 2"));
  EXPECT_THAT(mistake({{0, 0}, {1, 0}, {2, 1}, {3, 1}, {4, 2}}),
              HasSubstr("(1,0) does not belong"));
  EXPECT_THAT(mistake({{0, 0}, {0, 1}, {1, 1}, {2, 1}, {3, 1}, {4, 2}}),
              HasSubstr("two pixels in column 0"));
}

// The quick lines

/// The pixels that draw_line_runs() promises in an image, each by its own division in 128 bits.
Image<Rgb8> exactly_drawn(const Point& p0, const Point& p1, int width, int height) {
  __extension__ using Int128 = __int128;
  const Eigen::Matrix<std::int64_t, 2, 1> way = p1.cast<std::int64_t>() - p0.cast<std::int64_t>();
  const int axis = std::abs(way.y()) > std::abs(way.x()) ? 1 : 0;
  const Point& from = way[axis] < 0 ? p1 : p0;
  const Int128 major = std::abs(way[axis]);
  const Int128 minor = std::abs(way[1 - axis]);
  const int direction = (way[axis] < 0) != (way[1 - axis] < 0) ? -1 : 1;
  Image<Rgb8> image(width, height);
  for (int place = 0; place < (axis == 0 ? width : height); ++place) {
    const Int128 step = Int128{place} - from[axis];
    if (step < 0 || step > major) continue;
    const Int128 offset = major == 0 ? 0 : (2 * step * minor + major) / (2 * major);
    const auto across = static_cast<int>(from[1 - axis] + direction * offset);
    const Point pixel = axis == 0 ? Point(place, across) : Point(across, place);
    if (image.contains(pixel.x(), pixel.y())) image(pixel.x(), pixel.y()) = white;
  }
  return image;
}

/// Exactly what is promised, which is what the last rung has wherever that has no choice.
void expect_drawn_by_runs(const Point& p0, const Point& p1, int width, int height) {
  SCOPED_TRACE(testing::Message() << "(" << p0.transpose() << ") to (" << p1.transpose() << ")");
  Image<Rgb8> image(width, height);
  const std::int64_t count = draw_line_runs(image, p0, p1, white);
  ASSERT_EQ(image, exactly_drawn(p0, p1, width, height));
  ASSERT_EQ(count, std::ranges::count(image.pixels(), white));
  if (oracle::ExactSegment(p0, p1).has_ties()) return;
  Image<Rgb8> last_rung(width, height);
  draw_pixels(last_rung, line_bresenham(p0, p1), white);
  ASSERT_EQ(image, last_rung);
}

TEST(stage01_draw_line_runs, are_the_pixels_of_the_last_rung) {
  for (const int reach : {5, 40, 300, 5000}) {
    for (const Segment& segment : random_segments(reach < 1000 ? 1500 : 100, reach)) {
      for (const Point& corner : {Point(0, 0), Point(-12, -9)}) {
        expect_drawn_by_runs(segment.p0 - corner, segment.p1 - corner, 25, 19);
        if (HasFatalFailure()) return;
      }
    }
  }
}

TEST(stage01_draw_line_runs, all_lines_in_a_small_image) {
  for (const auto& [width, height] : {std::pair{7, 6}, {1, 9}, {9, 1}, {1, 1}}) {
    for (int from = 0; from < width * height; ++from) {
      for (int to = 0; to < width * height; ++to) {
        expect_drawn_by_runs({from % width, from / width}, {to % width, to / width}, width, height);
        if (HasFatalFailure()) return;
      }
    }
  }
}

TEST(stage01_draw_line_runs, wherever_the_ends_are) {
  expect_right_drawings([](Image<Rgb8>& image, const Point& p0, const Point& p1) {
    draw_line_runs(image, p0, p1, white);
  });
}

TEST(stage01_draw_line_runs, draw_the_same_when_the_ends_change_places) {
  for (const Segment& segment : segments_around_an_image()) {
    Image<Rgb8> there(24, 18);
    Image<Rgb8> back(24, 18);
    EXPECT_EQ(draw_line_runs(there, segment.p0, segment.p1, white),
              draw_line_runs(back, segment.p1, segment.p0, white));
    ASSERT_EQ(there, back);
  }
}

TEST(stage01_draw_line_runs, are_exact_for_ends_of_every_magnitude) {
  std::mt19937 random(6);
  const auto coordinate = [&random] {
    const int reach = 1 << random() % 31;
    return static_cast<int>(random() % (2U * static_cast<unsigned>(reach) + 1U)) - reach;
  };
  for (int i = 0; i < 20000; ++i) {
    const Point p0(coordinate(), coordinate());
    const Point p1(coordinate(), coordinate());
    Image<Rgb8> image(83, 61);
    draw_line_runs(image, p0, p1, white);
    ASSERT_EQ(image, exactly_drawn(p0, p1, 83, 61))
        << "(" << p0.transpose() << ") to (" << p1.transpose() << ")";
  }
}

TEST(stage01_draw_line_runs, are_exact_between_any_two_pixels) {
  std::mt19937 random(7);
  const auto pixel = [&random] {
    return Point(static_cast<int>(random() % 640U), static_cast<int>(random() % 480U));
  };
  for (int i = 0; i < 500; ++i) {
    const Point p0 = pixel();
    // Two of three have a simple slope, where many pixels are equally near.
    const int way = static_cast<int>(random() % 201U) - 100;
    const Point p1 = i % 3 == 0   ? pixel()
                     : i % 3 == 1 ? p0 + Point(2 * way, way)
                                  : p0 + Point(way, -2 * way);
    Image<Rgb8> image(640, 480);
    draw_line_runs(image, p0, p1, white);
    ASSERT_EQ(image, exactly_drawn(p0, p1, 640, 480))
        << "(" << p0.transpose() << ") to (" << p1.transpose() << ")";
  }
}

TEST(stage01_draw_line_runs, are_exact_along_their_whole_length) {
  for (const auto& [width, height] :
       {std::pair{32768, 5}, {32769, 5}, {100000, 7}, {3, 32768}, {3, 40000}}) {
    for (int from = 0; from < (width < height ? width : height); ++from) {
      for (int to = 0; to < (width < height ? width : height); ++to) {
        const bool flat = width > height;
        const Point p0 = flat ? Point(0, from) : Point(from, 0);
        const Point p1 = flat ? Point(width - 1, to) : Point(to, height - 1);
        Image<Rgb8> image(width, height);
        draw_line_runs(image, p0, p1, white);
        ASSERT_EQ(image, exactly_drawn(p0, p1, width, height))
            << "(" << p0.transpose() << ") to (" << p1.transpose() << ")";
      }
    }
  }
}

/// Every way to draw a list, on a picture that has something in it already.
void expect_drawn_as_one_by_one(const std::vector<Segment>& segments, int width, int height) {
  const Rgb8 color{10, 20, 30};
  Image<Rgb8> before(width, height);
  for (std::size_t i = 0; i < before.pixels().size(); ++i)
    before.pixels()[i].g = static_cast<std::uint8_t>(i * 7);
  Image<Rgb8> expected = before;
  DrawnLines drawn;
  for (const auto& [p0, p1] : segments) drawn.add(draw_line_runs(expected, p0, p1, color));
  std::vector<LineListWay> ways = line_list_ways();
  // Lists that are too short to be worth marks are marked all the same.
  if (has_avx512()) ways.push_back({"marks", &draw_line_list_avx512});
  for (const LineListWay& way : ways) {
    Image<Rgb8> image = before;
    EXPECT_EQ(way.draw(image, segments, color), drawn) << way.name;
    EXPECT_TRUE(image == expected)
        << way.name << ", " << segments.size() << " segments, " << width << " x " << height;
  }
}

TEST(stage01_draw_line_list, each_segment_from_a_pixel) {
  for (int x = 0; x < 64; ++x) {
    for (int y = 0; y < 70; ++y) expect_drawn_as_one_by_one({{{31, 40}, {x, y}}}, 64, 70);
  }
}

TEST(stage01_draw_line_list, segments_near_the_borders_of_64_pixels) {
  for (const Point& p0 : {Point(63, 63), Point(64, 64), Point(127, 60), Point(60, 128)}) {
    for (int x = 57; x < 72; ++x) {
      for (int y = 57; y < 72; ++y) {
        expect_drawn_as_one_by_one({{p0, {x, y}}}, 130, 129);
        expect_drawn_as_one_by_one({{{x, y}, {x - 57, 128}}}, 130, 129);
      }
    }
  }
}

TEST(stage01_draw_line_list, segments_along_the_borders_of_an_image) {
  for (const auto& [width, height] :
       {std::pair{64, 64}, {65, 71}, {127, 128}, {7, 200}, {200, 1}}) {
    const int right = width - 1;
    const int bottom = height - 1;
    for (const Segment& segment :
         {Segment{{0, 0}, {right, 0}}, Segment{{0, bottom}, {right, bottom}},
          Segment{{0, 0}, {0, bottom}}, Segment{{right, bottom}, {right, 0}},
          Segment{{0, 0}, {right, bottom}}, Segment{{0, bottom}, {right, 0}},
          Segment{{right, bottom}, {right, bottom}}})
      expect_drawn_as_one_by_one({segment}, width, height);
  }
}

TEST(stage01_draw_line_list, any_segment_of_an_image) {
  std::mt19937 random(8);
  for (int i = 0; i < 1500; ++i) {
    const int width = 64 + static_cast<int>(random() % 140U);
    const int height = 64 + static_cast<int>(random() % 140U);
    const auto pixel = [&] {
      return Point(static_cast<int>(random() % static_cast<unsigned>(width)),
                   static_cast<int>(random() % static_cast<unsigned>(height)));
    };
    // Two of three have a simple slope, where many pixels are equally near.
    const Point p0 = pixel();
    const int way = static_cast<int>(random() % 81U) - 40;
    const Point p1 = i % 3 == 0   ? pixel()
                     : i % 3 == 1 ? p0 + Point(2 * way, way)
                                  : p0 + Point(way, -2 * way);
    expect_drawn_as_one_by_one({{p0, p1}}, width, height);
  }
}

TEST(stage01_draw_line_list, long_segments_one_by_one) {
  for (const int minor : {0, 1, 2, 31, 62, 63}) {
    expect_drawn_as_one_by_one({{{0, 0}, {32767, minor}}}, 32768, 64);
    expect_drawn_as_one_by_one({{{32766, 0}, {0, minor}}}, 32768, 64);
  }
}

TEST(stage01_draw_line_list, segments_inside_across_and_outside) {
  std::mt19937 random(9);
  for (const int reach : {3, 20, 70, 300}) {
    for (const auto& [width, height] : {std::pair{64, 64}, {65, 127}, {200, 71}, {63, 300}}) {
      std::vector<Segment> segments;
      for (int i = 0; i < 40000 / reach; ++i) {
        const auto within = [&random](int size) {
          return static_cast<int>(random() % static_cast<unsigned>(size));
        };
        const Point p0(within(width), within(height));
        const Point away(within(2 * reach + 1) - reach, within(2 * reach + 1) - reach);
        segments.push_back({p0, p0 + away});
      }
      segments.push_back({{-far, -far}, {far, far - 1}});
      segments.push_back({{-far, 5}, {far, 5}});
      segments.push_back({{far, far}, {far, far}});
      expect_drawn_as_one_by_one(segments, width, height);
    }
  }
}

TEST(stage01_draw_line_list, long_segments_from_edge_to_edge) {
  std::vector<Segment> segments;
  for (int i = 0; i < 64; ++i) {
    segments.push_back({{0, i}, {32767, 63 - i}});
    segments.push_back({{32767 - i, i}, {100, 0}});
    segments.push_back({{i * 500, 0}, {i * 500 + i, 63}});
  }
  expect_drawn_as_one_by_one(segments, 32768, 64);
  expect_drawn_as_one_by_one(segments, 32769, 64);
}

TEST(stage01_draw_line_list, few_and_none) {
  expect_drawn_as_one_by_one({}, 70, 70);
  expect_drawn_as_one_by_one({{{1, 2}, {30, 9}}, {{-5, -5}, {-1, 0}}}, 70, 70);
  expect_drawn_as_one_by_one({{{1, 2}, {30, 9}}}, 0, 0);
}

TEST(stage01_color_run, sets_its_pixels_and_no_others) {
  const ColorRun run(Rgb8{10, 20, 30});
  for (std::ptrdiff_t count = -2; count <= 100; ++count) {
    std::vector<Rgb8> pixels(120, Rgb8{7, 8, 9});
    run.fill(pixels.data() + 10, count);
    for (std::ptrdiff_t i = 0; i < 120; ++i) {
      const bool inside = i >= 10 && i < 10 + count;
      ASSERT_EQ(pixels[static_cast<std::size_t>(i)], inside ? (Rgb8{10, 20, 30}) : (Rgb8{7, 8, 9}))
          << "pixel " << i - 10 << " of a run of " << count;
    }
  }
}

TEST(stage01_draw_line_runs, ends_too_far) {
  Image<Rgb8> image(4, 4);
  EXPECT_THROW(draw_line_runs(image, {0, 0}, {far + 1, 0}, white), CheckError);
  EXPECT_THROW(draw_line_runs(image, {0, std::numeric_limits<int>::min()}, {0, 0}, white),
               CheckError);
}

// 01.10

/// Checks the colour of the pixel whose weight is α.
void expect_color(const Image<Rgb8>& image, const Point& pixel, const Color& c0, const Color& c1,
                  double weight) {
  const Color expected =
      255 * ((1 - static_cast<float>(weight)) * c0 + static_cast<float>(weight) * c1);
  const Rgb8& actual = image(pixel.x(), pixel.y());
  const Color off = Color(actual.r, actual.g, actual.b) - expected;
  EXPECT_LE(off.cwiseAbs().maxCoeff(), 1) << "pixel (" << pixel.transpose() << ") has weight "
                                          << weight << ", its colour is off by " << off.transpose();
}

TEST(stage01_draw_line_gradient, colours_go_along_the_line) {
  const Color c0(1, 0.5F, 0.1F);
  const Color c1(0.1F, 0.6F, 1);
  for (const Segment& segment : random_segments(150, 30)) {
    Image<Rgb8> image(40, 40);
    const Point p0 = segment.p0 + Point(15, 15);
    const Point p1 = segment.p1 + Point(15, 15);
    draw_line_gradient(image, p0, c0, p1, c1);
    ASSERT_EQ(oracle::drawing_mistake(drawn(image), p0, p1), "");
    const double length = (p1 - p0).cast<double>().norm();
    for (int y = 0; y < 40; ++y) {
      for (int x = 0; x < 40; ++x) {
        if (image(x, y) == Rgb8{}) continue;
        const double weight = length > 0 ? (Point(x, y) - p0).cast<double>().norm() / length : 0;
        expect_color(image, {x, y}, c0, c1, weight);
      }
    }
  }
}

TEST(stage01_draw_line_gradient, ends_have_their_colours) {
  Image<Rgb8> image(9, 4);
  draw_line_gradient(image, {8, 3}, Color(1, 0, 0), {0, 0}, Color(0, 0, 1));
  EXPECT_EQ(image(8, 3), (Rgb8{255, 0, 0})) << "p0 has c0";
  EXPECT_EQ(image(0, 0), (Rgb8{0, 0, 255})) << "p1 has c1";
}

TEST(stage01_draw_line_gradient, one_pixel_has_the_first_colour) {
  Image<Rgb8> image(3, 3);
  draw_line_gradient(image, {1, 1}, Color(1, 0, 0), {1, 1}, Color(0, 0, 1));
  EXPECT_TRUE(covers_exactly(image, {"...", ".#.", "..."}));
  EXPECT_EQ(image(1, 1), (Rgb8{255, 0, 0}));
}

TEST(stage01_draw_line_gradient, a_part_has_the_colours_of_the_whole) {
  Image<Rgb8> image(11, 1);
  draw_line_gradient(image, {-500000000, 0}, Color(1, 0.2F, 0), {500000010, 0}, Color(0, 0.2F, 1));
  for (int x = 0; x < 11; ++x)
    expect_color(image, {x, 0}, Color(1, 0.2F, 0), Color(0, 0.2F, 1), 0.5);
}

TEST(stage01_draw_line_gradient, wherever_the_ends_are) {
  expect_right_drawings([](Image<Rgb8>& image, const Point& p0, const Point& p1) {
    draw_line_gradient(image, p0, Color(1, 1, 1), p1, Color(0.5F, 0.5F, 0.5F));
  });
}

TEST(stage01_draw_line_gradient, ends_too_far) {
  Image<Rgb8> image(4, 4);
  const Color grey(0.5F, 0.5F, 0.5F);
  EXPECT_THROW(draw_line_gradient(image, {0, 0}, grey, {far + 1, 0}, grey), CheckError);
  EXPECT_THROW(draw_line_gradient(image, {0, -far - 1}, grey, {0, 0}, grey), CheckError);
}

// 01.11

Mesh triangle_mesh(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c) {
  Mesh mesh;
  mesh.positions = {a, b, c};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

TEST(stage01_draw_wireframe, y_is_up_and_the_edges_of_the_window_are_in_it) {
  Image<Rgb8> image(5, 5);
  draw_wireframe(image, triangle_mesh({-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}), white);
  EXPECT_TRUE(covers_exactly(image, {"#....", "##...", "#.#..", "#..#.", "#####"}));
}

TEST(stage01_draw_wireframe, depth_does_not_matter) {
  Image<Rgb8> flat(20, 20);
  draw_wireframe(flat, triangle_mesh({-0.5F, 0.5F, 0}, {-0.6F, -0.4F, 0}, {0.7F, 0.1F, 0}), white);
  Image<Rgb8> deep(20, 20);
  draw_wireframe(deep, triangle_mesh({-0.5F, 0.5F, 9}, {-0.6F, -0.4F, -5}, {0.7F, 0.1F, 0.3F}),
                 white);
  EXPECT_EQ(flat, deep);
}

TEST(stage01_draw_wireframe, every_edge_of_every_triangle) {
  Image<Rgb8> image(9, 9);
  draw_wireframe(image, make_shape("wall:1"), white);
  const PictureText text = picture_text(image);
  EXPECT_EQ(text.front(), "#########");
  EXPECT_EQ(text.back(), "#########");
  for (const std::string& row : text)
    EXPECT_TRUE(row.front() == '#' && row.back() == '#') << "the square's sides";
}

TEST(stage01_draw_wireframe, what_is_outside_is_cut_off) {
  Image<Rgb8> image(9, 9);
  draw_wireframe(image, triangle_mesh({-5, 0, 0}, {5, 0, 0}, {0, 1e30F, 0}), white);
  EXPECT_EQ(picture_text(image)[4], "#########")
      << "an edge from beyond the left to beyond the right";
}

TEST(stage01_draw_wireframe, no_mesh_and_no_numbers) {
  Image<Rgb8> image(5, 5);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NO_THROW(draw_wireframe(image, Mesh(), white));
  EXPECT_NO_THROW(
      draw_wireframe(image, triangle_mesh({nan, 0, 0}, {nan, 1, 0}, {0, nan, 0}), white));
  EXPECT_EQ(image, Image<Rgb8>(5, 5));
}

}  // namespace
}  // namespace rasterlab
