// SPDX-License-Identifier: GPL-3.0-or-later
// The real program in a real window: its own X server, keys and mouse from xdotool.
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>

#include "harness.h"
#include "ui/handles.h"

namespace psm::test {
namespace {

bool installed(const std::string& program) { return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0; }

/// A program of its own, ended with the object.
class Process {
 public:
  explicit Process(const std::string& command) {
    pid_ = fork();
    if (pid_ != 0) return;
    setpgid(0, 0);
    execl("/bin/sh", "sh", "-c", ("exec " + command).c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  ~Process() {
    if (running()) kill(pid_, SIGTERM), waitpid(pid_, nullptr, 0);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  void ask_to_end() const { kill(pid_, SIGTERM); }
  bool running() {
    if (!status_ && waitpid(pid_, &raw_, WNOHANG) == pid_) status_ = raw_;
    return !status_;
  }
  std::optional<int> exit_code() {
    running();
    return status_ && WIFEXITED(*status_) ? std::optional<int>(WEXITSTATUS(*status_)) : std::nullopt;
  }

 private:
  pid_t pid_ = -1;
  int raw_ = 0;
  std::optional<int> status_;
};

/// Polls until it holds; false after a minute, which only a hang takes.
template <class Condition>
bool wait_for(Condition condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (std::chrono::steady_clock::now() < end) {
    if (condition()) return true;
    usleep(20000);
  }
  return false;
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

class WindowTest : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* program : {"Xvfb", "xdotool"})
      if (!installed(program)) GTEST_SKIP() << program << " is not installed";
    start_server();
  }

  void start_server() {
    const auto number = folder_.path() / "display";
    // The server picks a free display itself, and says which.
    server_ = std::make_unique<Process>("Xvfb -displayfd 3 -screen 0 1280x800x24 -nolisten tcp 3>'" + number.string() +
                                        "' >/dev/null 2>&1");
    ASSERT_TRUE(wait_for([&] { return !text_of(number).empty() && text_of(number).back() == '\n'; })) << "no X server";
    const std::string text = text_of(number);
    display_ = ":" + text.substr(0, text.find('\n'));
  }

  // What the X and OpenGL drivers keep until the end is theirs; psmlab's own leaks show in the tests without a window.
  void start_program(const std::string& arguments) {
    program_ = std::make_unique<Process>("env -C '" + folder_.path().string() +
                                         "' ASAN_OPTIONS=detect_leaks=0 DISPLAY=" + display_ + " XDG_CONFIG_HOME='" +
                                         (folder_.path() / "config").string() + "' '" PSMLAB_PROGRAM "' " + arguments);
    xdotool("search --sync --onlyvisible --name '^psmlab: '", "window");
    window_ = text_of(folder_.path() / "window");
    window_ = window_.substr(0, window_.find('\n'));
    ASSERT_FALSE(window_.empty()) << "no window";
    xdotool("windowfocus --sync " + window_);
  }

  int xdotool(const std::string& arguments, const std::string& out = "out") {
    return std::system(
        ("DISPLAY=" + display_ + " timeout 60 xdotool " + arguments + " >'" + (folder_.path() / out).string() + "' 2>/dev/null")
            .c_str());
  }
  void key(const std::string& name) { EXPECT_EQ(xdotool("key --clearmodifiers " + name), 0); }

  void drag_the_sun();
  void save_picture() {
    key("p");
    key("Return");
    const auto picture = folder_.path() / "psmlab-ground-1.png";
    EXPECT_TRUE(wait_for([&] { return std::filesystem::exists(picture); })) << "P saves no picture";
  }

  glm::ivec2 window_size() {
    xdotool("getwindowgeometry --shell " + window_, "geometry");
    const std::string text = text_of(folder_.path() / "geometry");
    const auto number = [&](const char* name) { return std::atoi(text.c_str() + text.find(name) + std::strlen(name)); };
    return {number("WIDTH="), number("HEIGHT=")};
  }

  ScratchFolder folder_;
  std::unique_ptr<Process> server_, program_;
  std::string display_, window_;
};

/// Where the sun's handle is in a window of this size: the same frame, drawn here.
glm::ivec2 sun_pixel(glm::ivec2 size) {
  Bench bench("ground", {}, size);
  const Rect world = bench.work_places().at("view.world");
  for (const Handle& handle : handles(bench.work().images().picture(ViewId::world), bench.experiment(), world.size()))
    if (handle.kind == HandleKind::sun) return world.min + glm::ivec2(handle.pixel);
  return world.min;
}

void WindowTest::drag_the_sun() {
  const glm::ivec2 sun = sun_pixel(window_size());
  const std::string at = std::to_string(sun.x) + " " + std::to_string(sun.y);
  EXPECT_EQ(xdotool("mousemove --window " + window_ + " " + at +
                    " mousedown 1 mousemove_relative -- -30 12 mousemove_relative -- -30 0 "
                    "mouseup 1"),
            0);
}

TEST_F(WindowTest, OpensAnswersSavesAndCloses) {
  start_program("ground");
  if (HasFatalFailure()) return;
  drag_the_sun();
  key("3");
  key("0");
  save_picture();
  key("ctrl+s");
  key("Return");
  const auto state = folder_.path() / "ground.psm.json";
  ASSERT_TRUE(wait_for([&] { return std::filesystem::exists(state); })) << "Ctrl+S saves no experiment";
  const auto saved = load_experiment(state.string(), {});
  ASSERT_TRUE(saved) << saved.error().text;
  EXPECT_NE(saved->experiment.light, load_experiment("ground", {})->experiment.light) << "the light was not dragged";
  EXPECT_EQ(saved->experiment.view.maximised, std::nullopt);
  key("ctrl+q");
  ASSERT_TRUE(wait_for([&] { return !program_->running(); })) << "it does not close";
  EXPECT_EQ(program_->exit_code(), 0);
}

// Ctrl+C in the terminal, a kill, the end of the session.
TEST_F(WindowTest, ASignalThatEndsItNamesWhatIsNotSaved) {
  start_program("ground 2>'" + (folder_.path() / "errors").string() + "'");
  if (HasFatalFailure()) return;
  drag_the_sun();
  save_picture();  // the drag has arrived, too
  program_->ask_to_end();
  ASSERT_TRUE(wait_for([&] { return !program_->running(); }));
  EXPECT_EQ(program_->exit_code(), 1);
  const std::string errors = text_of(folder_.path() / "errors");
  const std::size_t at = errors.find("psmlab:ground?");
  ASSERT_NE(at, std::string::npos) << errors;
  const auto lost = load_experiment(errors.substr(at, errors.find('\n', at) - at), {});
  ASSERT_TRUE(lost) << lost.error().text;
  EXPECT_NE(lost->experiment.light, load_experiment("ground", {})->experiment.light);
}

TEST_F(WindowTest, ASignalLeavesNothingOfAFilm) {
  if (!installed("ffmpeg")) GTEST_SKIP() << "ffmpeg is not installed";
  start_program("--lesson 09_behind_the_viewer/5");
  if (HasFatalFailure()) return;
  key("p");
  key("ctrl+a");
  EXPECT_EQ(xdotool("type film.mp4"), 0);
  key("Return");
  const auto files = [&] {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
      const std::string name = entry.path().filename().string();
      count += name.starts_with("film") || name.ends_with(".tmp");
    }
    return count;
  };
  EXPECT_TRUE(wait_for([&] { return files() > 0; })) << "no film is begun";
  program_->ask_to_end();
  ASSERT_TRUE(wait_for([&] { return !program_->running(); }));
  EXPECT_EQ(program_->exit_code(), 0);
  EXPECT_EQ(files(), 0u);
}

}  // namespace
}  // namespace psm::test
