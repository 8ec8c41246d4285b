// A window on the screen, where OpenCV's highgui was found when this was built.
#pragma once

#include "common/image/image.h"
#include "common/image/pixel.h"

#include <memory>
#include <string>

namespace rasterlab {

/// What the user did in a window since it was last asked.
struct WindowEvents {
  int drag_x = 0;       ///< pixels the mouse went to the right with its left button down
  int drag_y = 0;       ///< and downwards
  int wheel = 0;        ///< notches the wheel was turned, away from the user positive
  int key = -1;         ///< the key last pressed as its character, or −1
  bool closed = false;  ///< the window was closed, or Esc pressed
};

/// One window. All windows belong to one thread.
class Window {
 public:
  /// Throws InputError where windows are not built in or there is no display.
  explicit Window(const std::string& title);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Shows a picture, one of its pixels on one of the screen; the window takes its size.
  void show(const Image<Rgb8>& image);

  /// Lets the window work for so long, at least 1, or until a key is pressed.
  WindowEvents poll(int milliseconds);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Whether this build has windows.
bool windows_are_built_in();

}  // namespace rasterlab
