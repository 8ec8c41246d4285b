// What the judge says of results whose fault is known.
#include "common/image/check.h"
#include "common/image/files.h"

#include "grading/judge/compare.h"
#include "grading/judge/segment.h"
#include "tests/support/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterlab::grading {
namespace {

using testing::HasSubstr;

const std::vector<double> course_line = {5, 5, 6, 6, 7, 6, 8, 7, 9, 7, 10, 8, 11, 8, 12, 9};
const std::vector<double> course_ends = {5, 5, 12, 9, 0};

TEST(grading_segment, course_example_is_right) {
  EXPECT_EQ(segment_fault(course_line, course_ends), "");
  EXPECT_EQ(segment_share(course_line, course_ends), 1);
}

TEST(grading_segment, either_of_two_equally_near_pixels_is_right) {
  EXPECT_EQ(segment_fault({0, 0, 1, 0, 2, 1}, {0, 0, 2, 1, 0}), "");
  EXPECT_EQ(segment_fault({0, 0, 1, 1, 2, 1}, {0, 0, 2, 1, 0}), "");
}

TEST(grading_segment, names_what_is_broken_first) {
  const std::vector<double> ends = {0, 0, 3, 1, 0};
  EXPECT_THAT(segment_fault({}, ends), HasSubstr("No pixel"));
  EXPECT_THAT(segment_fault({0, 1, 1, 1}, ends), HasSubstr("The first pixel is (0, 1)"));
  EXPECT_THAT(segment_fault({0, 0, 2, 1, 3, 1}, ends), HasSubstr("gap before pixel (2, 1)"));
  EXPECT_THAT(segment_fault({0, 0, 1, 0, 2, 1}, ends), HasSubstr("The last pixel is (2, 1)"));
  EXPECT_THAT(segment_fault({0, 0, 1, 1, 2, 1, 3, 1}, ends), HasSubstr("more than ½"));
  EXPECT_THAT(segment_fault({0, 0, 1, 0, 1, 0, 2, 1}, ends), HasSubstr("does not step forward"));
  EXPECT_THAT(segment_fault({0, 0, 1, 0, 2, 1, 3, 1, 4, 1}, ends), HasSubstr("beyond"));
}

TEST(grading_segment, direction_is_free_only_where_the_contract_says_so) {
  const std::vector<double> backwards = {2, 1, 1, 1, 0, 0};
  EXPECT_EQ(segment_fault(backwards, {0, 0, 2, 1, 1}), "");
  EXPECT_NE(segment_fault(backwards, {0, 0, 2, 1, 0}), "");
}

Record coverage(std::vector<std::uint8_t> drawn, std::vector<std::uint8_t> demands) {
  Record record{.name = "a",
                .kind = RecordKind::coverage,
                .width = static_cast<int>(drawn.size()),
                .height = 1};
  record.bytes = std::move(drawn);
  record.demands = std::move(demands);
  return record;
}

TEST(grading_compare, coverage_knows_must_may_and_must_not) {
  const std::vector<std::uint8_t> demands = {Record::must, Record::must, Record::may,
                                             Record::must_not};
  const Record expected = coverage({1, 1, 0, 0}, demands);
  EXPECT_TRUE(compare(expected, coverage({1, 1, 0, 0}, {})).right);
  EXPECT_TRUE(compare(expected, coverage({1, 1, 1, 0}, {})).right);
  EXPECT_EQ(compare(expected, coverage({1, 0, 0, 0}, {})).score, 0.5);
  EXPECT_EQ(compare(expected, coverage({1, 1, 0, 1}, {})).score, 0.5);
  EXPECT_EQ(compare(expected, coverage({0, 0, 0, 0}, {})).score, 0);
  EXPECT_EQ(compare(expected, coverage({1, 1, 1, 1}, {})).score, 0.5);
}

Record picture(const std::vector<std::uint8_t>& bytes, double tolerance = 0) {
  Record record{.name = "a",
                .kind = RecordKind::picture,
                .width = static_cast<int>(bytes.size()),
                .height = 1};
  record.bytes = bytes;
  record.tolerance = tolerance;
  return record;
}

TEST(grading_compare, the_tolerance_is_the_references) {
  EXPECT_TRUE(compare(picture({0, 9, 9}, 1), picture({0, 10, 8}, 0)).right);
  EXPECT_FALSE(compare(picture({0, 9, 9}, 1), picture({0, 11, 9}, 255)).right);
}

TEST(grading_compare, an_empty_picture_scores_nothing) {
  EXPECT_EQ(compare(picture({9, 0, 0, 0, 9}), picture({0, 0, 0, 0, 0})).score, 0);
  EXPECT_EQ(compare(picture({9, 0, 0, 0, 9}), picture({9, 0, 0, 0, 0})).score, 0.5);
}

TEST(grading_compare, not_a_number_is_no_number) {
  Record expected{.name = "n", .kind = RecordKind::numbers};
  expected.numbers = {1};
  expected.tolerance = 1e9;
  Record actual = expected;
  actual.numbers = {std::numeric_limits<double>::quiet_NaN()};
  EXPECT_FALSE(compare(expected, actual).right);
}

TEST(grading_compare, likeness_is_of_what_is_wrong) {
  const Record expected = picture({0, 0, 0, 9, 9});
  EXPECT_EQ(likeness(expected, picture({0, 0, 0, 0, 9}), picture({0, 0, 0, 0, 9})), 1);
  EXPECT_EQ(likeness(expected, picture({0, 0, 0, 0, 9}), picture({0, 0, 0, 9, 0})), 0);
  EXPECT_EQ(likeness(expected, picture({0, 0, 0, 0, 9}), expected), 0);
}

TEST(grading_compare, looks_up_no_pixel_where_none_can_be) {
  const Record expected = {.name = "p",
                           .kind = RecordKind::picture,
                           .width = 2,
                           .height = 1,
                           .channels = 3,
                           .bytes = {9, 9, 9, 0, 0, 0}};
  const Record grey = {.name = "p",
                       .kind = RecordKind::picture,
                       .width = 2,
                       .height = 1,
                       .channels = 1,
                       .bytes = {9, 0}};
  const Record depths = {.name = "p",
                         .kind = RecordKind::values,
                         .width = 2,
                         .height = 1,
                         .channels = 3,
                         .numbers = {9, 0}};
  for (const Record& written : {grey, depths}) {
    EXPECT_FALSE(compare(expected, written).right);
    EXPECT_EQ(character_grid(expected, written), "");
    EXPECT_TRUE(difference_image(expected, written).empty());
    EXPECT_EQ(likeness(expected, written, expected), 0);
    EXPECT_EQ(likeness(expected, expected, written), 0);
    EXPECT_EQ(likeness(expected, written, written), 1) << "the same mistake, whatever it is";
  }
}

TEST(grading_records, are_read_as_written) {
  const ScratchFolder folder;
  Results results;
  results.picture("p q", Image<Rgb8>(2, 3, {1, 2, 3}), 4, 5);
  results.numbers("n", {0.1, -1e300}, 0.5);
  results.text("t", "line\nline");
  results.segment("s", {{1, 2}}, {1, 2}, {1, 2}, true);
  results.values("v", Image<float>(1, 1, 0.5F), 1);
  results.write(folder / "r");
  const std::vector<Record> read = read_results(folder / "r");
  ASSERT_EQ(read.size(), 5U);
  EXPECT_EQ(read[0].name, "p q");
  EXPECT_EQ(read[0].bytes.size(), 18U);
  EXPECT_EQ(read[0].free_pixels, 5);
  EXPECT_EQ(read[1].numbers, (std::vector<double>{0.1, -1e300}));
  EXPECT_EQ(read[2].text, "line\nline");
  EXPECT_EQ(read[3].ends, (std::vector<double>{1, 2, 1, 2, 1}));
  EXPECT_EQ(read[4].numbers, std::vector<double>{0.5});
}

TEST(grading_records, anything_else_is_refused) {
  const ScratchFolder folder;
  const std::string head = "RASTERLAB RESULT 1\n";
  for (const std::string& text :
       {std::string(), std::string("RASTERLAB RESULT 2\nend\n"), head, head + "end\nmore",
        head + "picture 8192 8192 3 0 0 0 a\nxx", head + "picture -1 1 1 0 0 0 a\n\nend\n",
        head + "picture 99999999 99999999 1 0 0 0 a\n\nend\n",
        head + "numbers 0 0 1 2305843009213693952 0 0 a\n",
        head + "text 0 0 1 3 0 0 a\nabcd\nend\n", head + "sound 0 0 1 0 0 0 a\n\nend\n",
        head + "text 0 0 2 0 0 0 a\n\nend\n",
        head + "segment 0 0 1 0 0 0 a\n" + std::string(40, '\xE7') + "\nend\n",
        head + "text 0 0 1 0 0 0 " + std::string(500, 'a') + "\n\nend\n"}) {
    write_file(folder / "r", text);
    EXPECT_THROW(read_results(folder / "r"), InputError) << text.substr(0, 80);
  }
  EXPECT_THROW(read_results(folder / "none"), InputError);
  EXPECT_THROW(read_results("/dev/zero"), InputError);
  EXPECT_THROW(read_results(folder.path()), InputError);
}

}  // namespace
}  // namespace rasterlab::grading
