// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson: one plain value, read from a folder that holds lesson.json and text.md (lessons/README.md says what they may hold).
#pragma once

#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "draw/emphasis.h"
#include "lesson/markdown.h"
#include "scene/curve_row.h"
#include "scene/experiment_between.h"
#include "scene/experiment_members.h"
#include "scene/result.h"

namespace psm {

/// A row of the two-dimensional error model, as `psmlab curves` prints it, and one of its columns.
struct CurveQuantity {
  Warp technique = Warp::gmnpr;
  CurveRange range;
  double theta_deg = 90.0;
  double CurveRow::*column = nullptr;
};

/// A path into the analysis' JSON; with some members over the experiment at hand, where `with` is given.
struct AnalysisQuantity {
  std::string path;
  std::optional<ExperimentMembers> with;
};

using Quantity = std::variant<double, AnalysisQuantity, CurveQuantity>;

/// A scalar of JSON: null, true, 4.5, "directional".
using Scalar = std::variant<std::monostate, bool, double, std::string>;

struct Condition {
  enum class Test { is, above, below, between };
  Quantity quantity;
  Test test = Test::is;
  Scalar expected;                     // is
  Quantity bound;                      // above, below
  double lowest = 0.0, highest = 0.0;  // between
  int line = 0;
};

/// A few blocks of Markdown, from a string of lesson.json.
using Prose = std::vector<Block>;

struct Question {
  enum class Kind { choice, number };
  Kind kind = Kind::choice;
  Prose prompt, why;
  std::string unit;
  std::vector<Prose> choices;
  int answer_index = 0;  // of `choices`
  Quantity answer;       // number
  double tolerance = 0.0;
  std::vector<ViewId> cover;  // views hidden until it is answered
  std::optional<ExperimentMembers> reveal;
  int line = 0;
};

struct Task {
  Prose prompt, done;
  std::vector<Condition> goal;  // all must hold
  std::vector<Prose> hints;
  ExperimentMembers solution;
  int line = 0;
};

/// What the prose says about a result, and the condition that makes it true.
struct Claim {
  std::string says;
  Condition condition;
};

struct Animation {
  std::string path;  // of a number, as find_control takes it
  double from = 0.0, to = 1.0, seconds = 4.0;

  /// Its value so many seconds after the start; gently at both ends.
  double at(double time) const { return std::lerp(from, to, eased(time / seconds)); }
};

struct Step {
  std::string heading, source;
  std::optional<ExperimentMembers> experiment;
  bool continues = false;  // the experiment of the step before stays; `experiment` goes over it
  std::vector<ViewId> views;
  std::vector<std::string> controls;
  Emphasis emphasis;
  std::optional<Animation> animation;
  std::vector<Question> questions;
  std::vector<Task> tasks;
  std::vector<Claim> claims;
  Prose text;           // of its section in text.md; the first step's begins with the lesson's introduction
  std::string written;  // all of its words as they stand in both files, each run of blanks as one
  int line = 0;         // in lesson.json
  int text_line = 0;    // of its heading in text.md
};

struct Lesson {
  std::string name;  // of its folder: "05_directional_lights"
  std::filesystem::path folder;
  std::string title, summary;
  ExperimentMembers base;  // every step starts from defaults, these, and its own
  std::vector<Step> steps;
};

/// The lesson's folder, where one of its two files was given; else what was given.
std::filesystem::path lesson_folder_of(const std::filesystem::path& given);

/// Errors start with file and line: ".../lesson.json:12: steps.0.views: ...".
Result<Lesson> read_lesson(const std::filesystem::path& folder);

/// Folders below `lessons` that hold a lesson.json, sorted by name.
std::vector<std::filesystem::path> lesson_folders(const std::filesystem::path& lessons);

/// Of "05_directional_lights/3", which loses its "/3": 2. Without a number behind the last slash: 0.
std::size_t take_lesson_step(std::string& name);

/// "5  Directional lights": the number from the lesson's name, "05_directional_lights", before its title. A name without one
/// adds nothing.
std::string numbered_title(const std::string& name, const std::string& title);

}  // namespace psm
