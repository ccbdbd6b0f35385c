// SPDX-License-Identifier: GPL-3.0-or-later
// Damaged lessons: read or refused in one line, whatever the damage.
#include <gtest/gtest.h>

#include <random>

#include "lesson_fixture.h"

namespace psm::testing {
namespace {

/// Refused in one line that names a file, or read; then checking it does no harm either.
void expect_an_answer(const LessonFolder& folder, const std::string& json, const std::string& text, bool check) {
  folder.write(json, text);
  const auto lesson = read_lesson(folder.path());
  std::vector<InputError> errors;
  if (!lesson)
    errors.push_back(lesson.error());
  else if (check)
    errors = check_lesson(*lesson, plain_surroundings());
  for (const InputError& error : errors) {
    EXPECT_TRUE(error.text.starts_with(folder.path().string())) << error.text;
    EXPECT_EQ(error.text.find('\n'), std::string::npos) << error.text;
  }
}

TEST(ATruncatedLesson, IsRefusedInOneLine) {
  const LessonFolder folder;
  for (std::size_t size = 0; size < kGoodJson.size(); size += 11)
    expect_an_answer(folder, kGoodJson.substr(0, size), kGoodText, false);
  for (std::size_t size = 0; size < kGoodText.size(); size += 3)
    expect_an_answer(folder, kGoodJson, kGoodText.substr(0, size), false);
}

/// Some bytes changed, taken out, or doubled.
std::string damaged(std::string text, std::mt19937& random) {
  const std::string bytes = "{}[]\"\\:,$_^`*#-&<=(!)0 9e\n\t\x01\xff\xc3\xa9|~";
  for (int i = 0; i < 3; ++i) {
    const std::size_t at = random() % text.size(), length = 1 + random() % 20;
    switch (random() % 3) {
      case 0:
        text[at] = bytes[random() % bytes.size()];
        break;
      case 1:
        text.erase(at, length);
        break;
      default:
        text.insert(at, text.substr(random() % text.size(), length));
    }
  }
  return text;
}

TEST(ADamagedLesson, IsReadOrRefusedInOneLine) {
  const LessonFolder folder;
  std::mt19937 random(20021);
  for (int i = 0; i < 500; ++i) expect_an_answer(folder, damaged(kGoodJson, random), kGoodText, i % 20 == 0);
  for (int i = 0; i < 500; ++i) expect_an_answer(folder, kGoodJson, damaged(kGoodText, random), i % 20 == 0);
}

TEST(ADeepOrEndlessLesson, IsRefused) {
  const LessonFolder folder;
  const auto many = [](const std::string& what, int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += what;
    return text;
  };
  expect_an_answer(folder, many("[", 100000), kGoodText, false);
  expect_an_answer(folder, many("{\"steps\":", 100000), kGoodText, false);
  for (const char* piece : {"{", "\\frac{", "\\left(", "x^{", "\\sqrt{", "_", "'"})
    expect_an_answer(folder, kGoodJson, replaced(kGoodText, "\\lambda", many(piece, 20000)), false);
  for (const char* piece : {"> ", "- ", "*", "`", "[", "$", "&", "_a", "1. "})
    expect_an_answer(folder, kGoodJson, replaced(kGoodText, "- one", many(piece, 20000) + "x"), false);
  expect_an_answer(folder, kGoodJson + many(" ", 2 << 20), kGoodText, false);
}

}  // namespace
}  // namespace psm::testing
