// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/film.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "app/numbers.h"

namespace psm {
namespace {

namespace fs = std::filesystem;

/// Without a shell, silently; 0 where that is not possible.
pid_t start(std::vector<std::string> command) {
  std::vector<char*> arguments;
  for (std::string& word : command) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t silence;
  posix_spawn_file_actions_init(&silence);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&silence, stream, "/dev/null", O_RDWR, 0);
  pid_t child = 0;
  const int failed = posix_spawnp(&child, arguments[0], &silence, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&silence);
  return failed ? 0 : child;
}

}  // namespace

bool is_film(const fs::path& file) { return file.extension() == ".mp4" || file.extension() == ".gif"; }

std::optional<InputError> film_missing() {
  const char* path = std::getenv("PATH");
  for (const std::string& folder : split(path ? path : "", ':'))
    if (!folder.empty() && access((fs::path(folder) / "ffmpeg").c_str(), X_OK) == 0) return std::nullopt;
  return InputError{"a film needs ffmpeg, which is not installed; allowed: a .png name for numbered pictures, or install ffmpeg"};
}

FilmMaker::FilmMaker(const fs::path& frames, const fs::path& film)
    : finished_(frames / ("film" + film.extension().string())), film_(film) {
  // Films of this kind have sides of even length; a GIF gets a palette of its own.
  const char* filter = film.extension() == ".gif" ? "split[a][b];[a]palettegen[p];[b][p]paletteuse"
                                                  : "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white,format=yuv420p";
  child_ = start({"ffmpeg", "-nostdin", "-y", "-framerate", std::to_string(kFramesPerSecond), "-i",
                  (frames / "frame_%04d.png").string(), "-filter_complex", filter, finished_.string()});
}

FilmMaker::~FilmMaker() {
  if (child_ == 0) return;
  kill(child_, SIGKILL);
  waitpid(child_, nullptr, 0);
}

bool FilmMaker::ended_within(std::chrono::milliseconds time) {
  constexpr std::chrono::milliseconds step(5);
  const auto due = std::chrono::steady_clock::now() + time;
  for (int status = 0; child_ != 0; std::this_thread::sleep_for(step)) {
    const pid_t ended = waitpid(child_, &status, WNOHANG);
    if (ended == child_ && WIFEXITED(status)) status_ = WEXITSTATUS(status);
    if (ended != 0) child_ = 0;
    if (std::chrono::steady_clock::now() >= due) break;
  }
  return child_ == 0;
}

std::optional<InputError> FilmMaker::finish() {
  if (status_ != 0)
    return InputError{film_.string() + ": ffmpeg could not write it (exit status " + std::to_string(status_) + ")"};
  std::error_code error;
  fs::rename(finished_, film_, error);
  if (error) return InputError{film_.string() + ": cannot be written: " + error.message()};
  return std::nullopt;
}

}  // namespace psm
