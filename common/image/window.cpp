#include "common/image/window.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#ifdef RASTERLAB_OPENCV_HIGHGUI
#include "common/image/opencv_library.h"

#include <opencv2/core.hpp>
#include <opencv2/highgui.hpp>
#include <opencv2/imgproc.hpp>
#endif

namespace rasterlab {

#ifdef RASTERLAB_OPENCV_HIGHGUI

namespace {

struct Highgui {
  OpenCvLibrary library{RASTERLAB_OPENCV_HIGHGUI};
  template <class Function>
  Function* of_window(const std::string& name, const std::string& parameters = "") const {
    return library.function<Function>(name, OpenCvLibrary::string + parameters);
  }
  decltype(cv::namedWindow)* named_window =
      of_window<decltype(cv::namedWindow)>("namedWindow", "i");
  decltype(cv::destroyWindow)* destroy_window =
      of_window<decltype(cv::destroyWindow)>("destroyWindow");
  decltype(cv::moveWindow)* move_window = of_window<decltype(cv::moveWindow)>("moveWindow", "ii");
  decltype(cv::getWindowImageRect)* get_window_image_rect =
      of_window<decltype(cv::getWindowImageRect)>("getWindowImageRect");
  decltype(cv::getWindowProperty)* get_window_property =
      of_window<decltype(cv::getWindowProperty)>("getWindowProperty", "i");
  decltype(cv::setMouseCallback)* set_mouse_callback =
      of_window<decltype(cv::setMouseCallback)>("setMouseCallback", "PFviiiiPvES8_");
  void (*show)(const cv::String&, cv::InputArray) =
      of_window<void(const cv::String&, cv::InputArray)>("imshow", "RKNS_11_InputArrayE");
  decltype(cv::waitKey)* wait_key = library.function<decltype(cv::waitKey)>("waitKey", "i");
  decltype(cv::getMouseWheelDelta)* get_mouse_wheel_delta =
      library.function<decltype(cv::getMouseWheelDelta)>("getMouseWheelDelta", "i");
};

const Highgui& highgui() {
  static const Highgui loaded;
  return loaded;
}

/// Qt ends the process where it finds no display, so it is looked for first.
bool has_display() {
  for (const char* variable : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
    const char* value = std::getenv(variable);
    if (value != nullptr && *value != '\0') return true;
  }
  return false;
}

}  // namespace

struct Window::State {
  std::string title;
  WindowEvents events;
  int mouse_x = 0;
  int mouse_y = 0;
  cv::Rect place;
  bool reopened = false;

  void open() {
    highgui().named_window(title, cv::WINDOW_AUTOSIZE | cv::WINDOW_GUI_NORMAL);
    highgui().set_mouse_callback(title, on_mouse, this);
  }

  /// The wheel also enlarges the picture's pixels in OpenCV's Qt windows, which no flag switches
  /// off (https://github.com/opencv/opencv/issues/11500); a new window shows them one to one.
  void reopen() {
    place = highgui().get_window_image_rect(title);
    highgui().destroy_window(title);
    open();
    highgui().move_window(title, place.x, place.y);
    reopened = true;
  }

  /// Once the new window is seen: it stands off by the width of its frame.
  void put_back() {
    const cv::Rect seen = highgui().get_window_image_rect(title);
    highgui().move_window(title, 2 * place.x - seen.x, 2 * place.y - seen.y);
    reopened = false;
  }

  static void on_mouse(int event, int x, int y, int flags, void* self) {
    static_cast<State*>(self)->note_mouse(event, x, y, flags);
  }

  void note_mouse(int event, int x, int y, int flags) {
    if (event == cv::EVENT_MOUSEMOVE && (flags & cv::EVENT_FLAG_LBUTTON) != 0) {
      events.drag_x += x - mouse_x;
      events.drag_y += y - mouse_y;
    }
    if (event == cv::EVENT_MOUSEWHEEL)
      events.wheel += highgui().get_mouse_wheel_delta(flags) > 0 ? 1 : -1;
    mouse_x = x;
    mouse_y = y;
  }
};

Window::Window(const std::string& title) : state_(std::make_unique<State>()) {
  if (!has_display()) {
    throw InputError("a window needs a display: neither DISPLAY nor WAYLAND_DISPLAY is set");
  }
  state_->title = title;
  try {
    state_->open();
  } catch (const cv::Exception& error) {
    throw InputError("no window can be opened: " + error.err);
  }
}

Window::~Window() {
  try {
    highgui().destroy_window(state_->title);
  } catch (const cv::Exception&) {
    // The user has closed it already.
  }
}

void Window::show(const Image<Rgb8>& image) {
  const cv::Mat pixels(image.height(), image.width(), CV_8UC3,
                       const_cast<Rgb8*>(image.row(0)));  // NOLINT: only read
  cv::Mat swapped;
  cv::cvtColor(pixels, swapped, cv::COLOR_RGB2BGR);
  highgui().show(state_->title, swapped);
}

WindowEvents Window::poll(int milliseconds) {
  constexpr int escape = 27;
  state_->events = {};
  state_->events.key = highgui().wait_key(std::max(milliseconds, 1));
  state_->events.closed = state_->events.key == escape ||
                          highgui().get_window_property(state_->title, cv::WND_PROP_VISIBLE) < 1;
  if (state_->events.closed) return state_->events;
  if (state_->reopened) state_->put_back();
  if (state_->events.wheel != 0) state_->reopen();
  return state_->events;
}

bool windows_are_built_in() {
  return true;
}

#else

struct Window::State {};

Window::Window(const std::string&) {
  throw InputError(
      "windows are not built in: expected OpenCV's highgui (Debian: libopencv-highgui-dev) when "
      "configuring");
}
Window::~Window() = default;
void Window::show(const Image<Rgb8>&) {}
WindowEvents Window::poll(int) {
  return {};
}
bool windows_are_built_in() {
  return false;
}

#endif

}  // namespace rasterlab
