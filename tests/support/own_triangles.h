// Stages 02 and 03 on triangles of one's own: --triangles FILE.
#pragma once

#include "common/image/bytes.h"

#include "tests/support/process.h"
#include "tests/support/scratch.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace rasterlab {

class OwnTriangles : public testing::Test {
 protected:
  const ScratchFolder scratch_;

  /// Runs a stage on a file of these rows; it draws out.png.
  ProcessResult draw_rows(const std::string& stage, const std::string& rows,
                          const std::vector<std::string>& flags) const {
    write_file(scratch_ / "triangles.txt", rows);
    std::vector<std::string> command{program(stage), "--triangles", "triangles.txt", "--out",
                                     "out.png"};
    command.insert(command.end(), flags.begin(), flags.end());
    return run_process(command, {.folder = scratch_.path()});
  }
};

}  // namespace rasterlab
