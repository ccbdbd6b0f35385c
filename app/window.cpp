// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

#include "app/assets.h"
#include "app/progress.h"
#include "app/window_picture.h"
#include "figure/png.h"
#include "scene/share_text.h"
#include "ui/host.h"

namespace psm {
namespace {

/// GLFW from its start to its end.
class Glfw {
 public:
  Glfw() : started_(glfwInit() == GLFW_TRUE) {}
  ~Glfw() {
    if (started_) glfwTerminate();
  }
  Glfw(const Glfw&) = delete;
  Glfw& operator=(const Glfw&) = delete;
  explicit operator bool() const { return started_; }

 private:
  bool started_;
};

struct WindowDeleter {
  void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
};
using WindowPtr = std::unique_ptr<GLFWwindow, WindowDeleter>;

std::string glfw_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "unknown reason";
}

/// Core 3.3, or whatever the driver gives where it has no such thing.
WindowPtr open_window(const std::string& title) {
  const GLFWvidmode* mode = glfwGetPrimaryMonitor() ? glfwGetVideoMode(glfwGetPrimaryMonitor()) : nullptr;
  const int width = mode ? std::clamp(mode->width * 9 / 10, 640, 1920) : 1280;
  const int height = mode ? std::clamp(mode->height * 9 / 10, 480, 1200) : 800;
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  if (GLFWwindow* window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr)) return WindowPtr(window);
  glfwDefaultWindowHints();
  return WindowPtr(glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr));
}

/// GLFW names keys by their place on an American keyboard; what counts here is the letter printed on them.
int printed_key(int key, int scancode) {
  if (key < 'A' || key > 'Z') return key;
  const char* name = glfwGetKeyName(key, scancode);
  if (!name || !name[0] || name[1]) return key;
  const int letter = std::toupper(static_cast<unsigned char>(name[0]));
  return letter >= 'A' && letter <= 'Z' ? letter : key;
}

/// The screen (a lecturer has two) that shows this point; the first one where none does.
GLFWmonitor* monitor_at(glm::ivec2 point) {
  int count = 0;
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  for (int i = 0; i < count; ++i) {
    glm::ivec2 corner(0);
    glfwGetMonitorPos(monitors[i], &corner.x, &corner.y);
    const GLFWvidmode* mode = glfwGetVideoMode(monitors[i]);
    const glm::ivec2 in = point - corner;
    if (mode && in.x >= 0 && in.y >= 0 && in.x < mode->width && in.y < mode->height) return monitors[i];
  }
  return count > 0 ? monitors[0] : nullptr;
}

/// Seconds after which a wait looks whether a signal came, which GLFW sleeps through.
constexpr double kSignalWait = 0.5;

/// The window with everything in it. GLFW's callbacks find it by the window's user pointer.
class App {
 public:
  App(GLFWwindow* window, const LoadedExperiment& loaded, const WindowStart& start);
  ~App() { ImGui_ImplGlfw_Shutdown(); }
  std::optional<InputError> run();
  void present(bool on) { workbench_.present(on); }

 private:
  static App& of(GLFWwindow* window) { return *static_cast<App*>(glfwGetWindowUserPointer(window)); }
  void install_callbacks();
  void wait();
  void ask_before_closing();
  void draw();
  bool idle() const;
  void draw_or_rescue();
  void fill_screen_while_presenting();
  glm::dvec2 framebuffer_point(double x, double y) const;
  static WorkbenchOptions options(const WindowStart& start);

  GLFWwindow* window_;
  InputQueue input_;
  Host host_;
  Workbench workbench_;
  std::string title_;
  double last_time_ = 0.0;
  bool fills_screen_ = false;
  glm::ivec2 place_{0}, size_{0};  // of the window before it filled the screen
};

WorkbenchOptions App::options(const WindowStart& start) {
  WorkbenchOptions options;
  options.assets = assets_folder();
  options.font = font_file();
  options.settings = settings_file();
  options.lessons = lessons_folder();
  options.lesson = start.lesson;
  options.start_card = start.asks_for_nothing;
  options.write_picture = [](const std::filesystem::path& file, const Image& image) {
    return write_png(file, image.width, image.height, image.rgba);
  };
  options.write_views = shown_views_writer;
  return options;
}

App::App(GLFWwindow* window, const LoadedExperiment& loaded, const WindowStart& start)
    : window_(window), host_(Screen::Target::window), workbench_(loaded, options(start)), last_time_(glfwGetTime()) {
  ImGui_ImplGlfw_InitForOpenGL(window, false);
  glfwSetWindowUserPointer(window, this);
  install_callbacks();
}

glm::dvec2 App::framebuffer_point(double x, double y) const {
  int width = 1, height = 1, pixels_x = 1, pixels_y = 1;
  glfwGetWindowSize(window_, &width, &height);
  glfwGetFramebufferSize(window_, &pixels_x, &pixels_y);
  return {x * pixels_x / std::max(1, width), y * pixels_y / std::max(1, height)};
}

// Each event wakes the workbench; what it does, the queue tells it in the frame.
void App::install_callbacks() {
  glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
    of(w).input_.mouse_move(of(w).framebuffer_point(x, y));
    of(w).workbench_.wake();
  });
  glfwSetCursorEnterCallback(window_, [](GLFWwindow* w, int entered) {
    if (!entered) of(w).input_.mouse_leave();
    of(w).workbench_.wake();
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int) {
    of(w).input_.mouse_button(button, action == GLFW_PRESS);
    of(w).workbench_.wake();
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double x, double y) {
    of(w).input_.wheel({x, y});
    of(w).workbench_.wake();
  });
  glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int scancode, int action, int) {
    if (action != GLFW_REPEAT) of(w).input_.key(printed_key(key, scancode), action == GLFW_PRESS);
    of(w).workbench_.wake();
  });
  glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned character) {
    of(w).input_.text(character);
    of(w).workbench_.wake();
  });
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int focused) {
    of(w).input_.focus(focused == GLFW_TRUE);
    of(w).workbench_.wake();
  });
  glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
    if (count > 0) of(w).workbench_.open(paths[0]);
  });
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { of(w).workbench_.wake(); });
  glfwSetWindowContentScaleCallback(window_, [](GLFWwindow* w, float, float) { of(w).workbench_.wake(); });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) {
    of(w).workbench_.wake();
    of(w).draw();
  });
}

void App::draw() {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  if (width <= 0 || height <= 0) return;
  float scale_x = 1.0f, scale_y = 1.0f;
  glfwGetWindowContentScale(window_, &scale_x, &scale_y);
  const double now = glfwGetTime();
  ImGui_ImplGlfw_NewFrame();
  host_.frame(workbench_, input_, {width, height}, std::max(scale_x, scale_y), now - last_time_);
  last_time_ = now;
  glfwSwapBuffers(window_);
  if (title_ == workbench_.window_title()) return;
  title_ = workbench_.window_title();
  glfwSetWindowTitle(window_, title_.c_str());
}

bool App::idle() const {
  return !workbench_.needs_redraw() && input_.empty() && !glfwWindowShouldClose(window_) && !Interruptible::asked();
}

void App::wait() {
  const bool minimised = glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE;
  if (!minimised && !idle()) return glfwPollEvents();
  const double due = glfwGetTime() + workbench_.next_look();
  do glfwWaitEventsTimeout(std::clamp(due - glfwGetTime(), 0.0, kSignalWait));
  while (idle() && glfwGetTime() < due);
  if (glfwGetTime() >= due) workbench_.look();
}

void App::fill_screen_while_presenting() {
  if (std::exchange(fills_screen_, workbench_.presenting()) == workbench_.presenting()) return;
  workbench_.wake();
  if (!fills_screen_) return glfwSetWindowMonitor(window_, nullptr, place_.x, place_.y, size_.x, size_.y, GLFW_DONT_CARE);
  glfwGetWindowPos(window_, &place_.x, &place_.y);
  glfwGetWindowSize(window_, &size_.x, &size_.y);
  GLFWmonitor* monitor = monitor_at(place_ + size_ / 2);
  const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
  if (mode) glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

// A minimised window comes back with its question.
void App::ask_before_closing() {
  if (!glfwWindowShouldClose(window_)) return;
  glfwSetWindowShouldClose(window_, GLFW_FALSE);
  workbench_.ask_to_quit();
  if (!workbench_.wants_quit() && glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE) glfwRestoreWindow(window_);
}

/// What fails for good leaves the experiment behind as a line to paste.
void App::draw_or_rescue() {
  try {
    draw();
  } catch (const std::exception& error) {
    const Model& model = workbench_.model();
    throw std::runtime_error(std::string(error.what()) + "; the experiment was " + share_text(model.experiment(), model.scene()));
  }
}

std::optional<InputError> App::run() {
  const Interruptible interruptible;  // what is being written must not stay in part
  while (!workbench_.wants_quit() && !Interruptible::asked()) {
    wait();
    ask_before_closing();
    fill_screen_while_presenting();
    const bool minimised = glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE;
    if (!minimised && (workbench_.needs_redraw() || !input_.empty())) draw_or_rescue();
  }
  const auto lost = Interruptible::asked() ? workbench_.unsaved_text() : std::nullopt;
  return lost ? std::optional(InputError{"interrupted; the experiment was " + *lost}) : std::nullopt;
}

}  // namespace

bool display_available() { return bool(Glfw()); }

std::optional<InputError> run_window(const LoadedExperiment& loaded, const WindowStart& start) {
  const Glfw glfw;
  if (!glfw) return InputError{"cannot open a window: " + glfw_error()};
  const WindowPtr window = open_window("psmlab");
  if (!window) return InputError{"cannot open a window with OpenGL: " + glfw_error()};
  glfwMakeContextCurrent(window.get());
  glfwSwapInterval(1);
  App app(window.get(), loaded, start);
  app.present(start.present);
  return app.run();
}

}  // namespace psm
