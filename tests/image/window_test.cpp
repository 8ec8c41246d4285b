#include "common/image/window.h"

#include "tests/image/corners.h"

#include <cstdlib>

#include <gmock/gmock.h>

namespace rasterlab {
namespace {

TEST(stage01_image_window, shows_a_picture) {
  if (!windows_are_built_in()) GTEST_SKIP() << "OpenCV's highgui was not found";
  setenv("QT_QPA_PLATFORM", "offscreen", 1);
  Window window("corners");
  window.show(four_corners());
  const WindowEvents events = window.poll(1);
  EXPECT_FALSE(events.closed);
  EXPECT_EQ(events.key, -1);
  EXPECT_EQ(events.drag_x + events.drag_y + events.wheel, 0);
}

TEST(stage01_image_window, without_a_display_says_so) {
  for (const char* variable : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) unsetenv(variable);
  try {
    const Window window("nowhere");
    ADD_FAILURE() << "there is no display";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(windows_are_built_in() ? "display" : "highgui"));
  }
}

}  // namespace
}  // namespace rasterlab
