// SPDX-License-Identifier: GPL-3.0-or-later
#include "lesson_fixture.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <random>

#include "draw/font_face.h"

namespace psm::testing {

namespace fs = std::filesystem;

const std::string kGoodJson = R"({
  "psmlab_lesson": 1,
  "title": "A small lesson",
  "summary": "Where the light stands decides its case.",
  "base": {"scene": {"source": "ground"}, "light": {"type": "directional", "to_light": [0, 1, 0]}},
  "steps": [
    {
      "heading": "The sun",
      "source": "PSM 2002, section 3.1",
      "experiment": {"light": {"to_light": [0, 1, -0.5]}},
      "views": ["world", "cube"],
      "controls": ["light.theta_deg", "shadow.resolution"],
      "highlight": ["light"],
      "questions": [
        {
          "kind": "choice",
          "prompt": "What does the cube make of it?",
          "choices": ["a point", "a direction"],
          "answer": 0,
          "cover": ["cube"],
          "why": "Because $w \\ne 0$.",
          "reveal": {"light": {"to_light": [0, 1, -0.25]}}
        },
        {
          "kind": "number",
          "prompt": "How large is the angle?",
          "unit": "degrees",
          "answer": {"value": "theta_deg"},
          "tolerance": 5,
          "why": "It is `=theta_deg` degrees."
        }
      ],
      "claims": [
        {
          "says": "far below 4",
          "curve": {"technique": "GMNPR", "n": 1, "f": 100, "phi_deg": 30, "theta_deg": 90},
          "column": "lambda",
          "below": 4
        }
      ]
    },
    {
      "heading": "Behind the eye",
      "continues": true,
      "views": ["world"],
      "animation": {"path": "light.theta_deg", "from": 20, "to": 160, "seconds": 3},
      "tasks": [
        {
          "prompt": "Make this light inverted.",
          "goal": [{"value": "light_case.post", "is": "inverted_point"}, {"value": "light_case.w", "below": 0}],
          "hints": ["Look where the eye looks."],
          "done": "It is inverted.",
          "solution": {"light": {"to_light": [0, 1, 1]}}
        }
      ]
    }
  ]
}
)";

const std::string kGoodText = R"(# A small lesson

What this is about.

## The sun

The warp $\lambda = \frac{\sqrt{n f} + n}{f - n}$ is *far below* 4, to be exact far below 4:

$$l_{post} = P V l, \quad \left( \frac{a}{b} \right)^2 \ge \hat{v} \cdot \bar{q}_1$$

- one
- two, see [the other](lesson:01_other) or [from above](set:light.to_light=0,1,0&shadow.resolution=512)

## Behind the eye

Now `=light_case.w` is **negative**.
)";

LessonFolder::LessonFolder(const std::string& json, const std::string& text) {
  std::random_device random;
  root_ = fs::temp_directory_path() / ("psmlab-lesson-" + std::to_string(random()) + std::to_string(random()));
  path_ = root_ / "00_small";
  fs::create_directories(path_);
  write(json, text);
}

LessonFolder::~LessonFolder() {
  std::error_code ignored;
  fs::remove_all(root_, ignored);
}

void LessonFolder::write(const std::string& json, const std::string& text) const {
  std::ofstream(path_ / "lesson.json", std::ios::binary) << json;
  std::ofstream(path_ / "text.md", std::ios::binary) << text;
}

std::string replaced(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  if (at == std::string::npos) return text;
  std::string out = text;
  return out.replace(at, from.size(), to);
}

LessonSurroundings plain_surroundings() {
  static const FontFace font = [] {
    std::ifstream stream("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", std::ios::binary);
    return FontFace(std::string(std::istreambuf_iterator<char>(stream), {}));
  }();
  return {[](const LoadedExperiment& loaded, bool) { return analyze(loaded.experiment, loaded.scene); },
          [](char32_t point) { return font.has(point); },
          {"00_small", "01_other"}};
}

std::string first_fault(const std::string& json, const std::string& text) {
  const LessonFolder folder(json, text);
  const auto without_folder = [&](const std::string& line) {
    const std::string prefix = folder.path().string() + "/";
    return line.starts_with(prefix) ? line.substr(prefix.size()) : line;
  };
  const auto lesson = read_lesson(folder.path());
  if (!lesson) return without_folder(lesson.error().text);
  const auto errors = check_lesson(*lesson, plain_surroundings());
  return errors.empty() ? "" : without_folder(errors.front().text);
}

}  // namespace psm::testing
