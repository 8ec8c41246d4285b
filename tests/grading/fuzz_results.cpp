// What the grader's judge reads: results that a student's program has written.
#include "grading/judge/compare.h"
#include "tests/fuzz/fuzz_target.h"

namespace rasterlab::grading {
namespace {

/// The reference's results, one of each kind.
std::vector<Record> references() {
  return {{.name = "picture",
           .kind = RecordKind::picture,
           .width = 3,
           .height = 2,
           .channels = 3,
           .bytes = std::vector<std::uint8_t>(18, 9)},
          {.name = "depths",
           .kind = RecordKind::values,
           .width = 2,
           .height = 2,
           .numbers = {0, 0.5, 1, 1},
           .tolerance = 1e-3},
          {.name = "pixels",
           .kind = RecordKind::coverage,
           .width = 3,
           .height = 1,
           .bytes = {1, 0, 0},
           .demands = {Record::must, Record::may, Record::must_not}},
          {.name = "line",
           .kind = RecordKind::segment,
           .numbers = {0, 0, 1, 0, 2, 1},
           .ends = {0, 0, 2, 1, 1}},
          {.name = "matrix", .kind = RecordKind::numbers, .numbers = {1, 0, 0, 1}},
          {.name = "words", .kind = RecordKind::text, .text = "yes"}};
}

}  // namespace
}  // namespace rasterlab::grading

void rasterlab::fuzz(std::string_view bytes) {
  using namespace grading;
  static const std::vector<Record> expected = references();
  for (const Record& record : read_results(as_file(bytes, ".result"))) {
    for (const Record& reference : expected) {
      const Comparison comparison = compare(reference, record);
      require(comparison.score >= 0 && comparison.score <= 1, "a score is between 0 and 1");
      require(comparison.right || !comparison.message.empty(), "what is wrong is said");
      const double alike = likeness(reference, record, record);
      require(alike >= 0 && alike <= 1, "a likeness is between 0 and 1");
      wrong_places(reference, record);
      kind_of_wrong(reference, record);
      character_grid(reference, record);
      if (reference.kind == record.kind) difference_image(reference, record);
    }
  }
}
