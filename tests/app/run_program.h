// SPDX-License-Identifier: GPL-3.0-or-later
// The real program as a subprocess, and folders of a test's own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace psm::testing {

struct Outcome {
  int code = -1;  // exit status; 128 + signal where one ended it
  std::string out, err;
};

/// PSMLAB_PROGRAM with these arguments, without any display, in `folder`.
Outcome run_program(const std::vector<std::string>& arguments, const std::filesystem::path& folder = ".");

/// The same through a shell: `line` stands after the program's name, so that pipes and closed streams can be had.
Outcome run_shell(const std::string& line);

/// A folder of this test's own, gone afterwards.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  const std::filesystem::path& path() const { return path_; }
  std::vector<std::string> names() const;  // sorted

 private:
  std::filesystem::path path_;
};

std::string contents(const std::filesystem::path& file);

/// One line: something, and a newline at its end only.
bool is_one_line(const std::string& text);

}  // namespace psm::testing
