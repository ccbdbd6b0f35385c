// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace psm::testing {
namespace {

namespace fs = std::filesystem;

/// In the child: never returns.
[[noreturn]] void become(const std::vector<std::string>& command, const fs::path& folder, const std::string& out,
                         const std::string& err) {
  std::vector<char*> arguments;
  for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  dup2(open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), 1);
  dup2(open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), 2);
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY"}) unsetenv(name);
  if (chdir(folder.c_str()) == 0) execv(arguments[0], arguments.data());
  _exit(127);
}

Outcome run(const std::vector<std::string>& command, const fs::path& folder) {
  const Folder streams;
  const std::string out = streams / "out", err = streams / "err";
  const pid_t child = fork();
  if (child == 0) become(command, folder, out, err);
  int status = 0;
  waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), contents(out), contents(err)};
}

}  // namespace

Outcome run_program(const std::vector<std::string>& arguments, const fs::path& folder) {
  std::vector<std::string> command{PSMLAB_PROGRAM};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return run(command, folder);
}

Outcome run_shell(const std::string& line) {
  return run({"/bin/sh", "-c", std::string("'") + PSMLAB_PROGRAM + "' " + line}, ".");
}

Folder::Folder() {
  std::string pattern = (fs::temp_directory_path() / "psmlab-test-XXXXXX").string();
  path_ = mkdtemp(pattern.data());
}

Folder::~Folder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::vector<std::string> Folder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(path_)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string contents(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

bool is_one_line(const std::string& text) { return text.size() > 1 && text.find('\n') == text.size() - 1; }

}  // namespace psm::testing
