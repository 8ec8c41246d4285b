#include "common/lines/number_rows.h"

#include "tests/fuzz/fuzz_target.h"

#include <cmath>

void rasterlab::fuzz(std::string_view bytes) {
  const RowFormat lines = {"x0 y0 x1 y1 [r g b [r g b]]", {4, 7, 10}};
  for_each_row(as_file(bytes, ".txt"), lines, [](const NumberRow& row) {
    require(row.numbers.size() == 4 || row.numbers.size() == 7 || row.numbers.size() == 10,
            "a row has as many numbers as its format says");
    for (const double number : row.numbers) require(std::isfinite(number), "numbers are finite");
    if (row.numbers.size() > 4) color_at(row, 4);
  });
}
