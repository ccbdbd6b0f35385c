// SPDX-License-Identifier: GPL-3.0-or-later
// A small lesson that has everything, in a folder of the test's own.
#pragma once

#include <filesystem>
#include <string>

#include "lesson/check.h"
#include "lesson/lesson.h"

namespace psm::testing {

extern const std::string kGoodJson, kGoodText;

/// A lessons folder with one lesson in it, gone afterwards.
class LessonFolder {
 public:
  explicit LessonFolder(const std::string& json = kGoodJson, const std::string& text = kGoodText);
  ~LessonFolder();
  LessonFolder(const LessonFolder&) = delete;
  LessonFolder& operator=(const LessonFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  void write(const std::string& json, const std::string& text) const;

 private:
  std::filesystem::path root_, path_;
};

/// `text` with the first `from` replaced; a test fault where there is none.
std::string replaced(const std::string& text, const std::string& from, const std::string& to);

/// Analyses without rays, the font's glyphs, and the names of two lessons.
LessonSurroundings plain_surroundings();

/// The first error of reading and checking, without the folder's path; empty where the lesson is fine.
std::string first_fault(const std::string& json, const std::string& text);

}  // namespace psm::testing
