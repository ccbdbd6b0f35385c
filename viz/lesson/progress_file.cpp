// SPDX-License-Identifier: GPL-3.0-or-later
#include "lesson/progress_file.h"

#include <limits>

#include "lesson/file_text.h"
#include "lesson/member_reader.h"
#include "scene/experiment_file.h"
#include "scene/json_node.h"

namespace psm {

namespace fs = std::filesystem;

namespace {

constexpr int kVersion = 2;
constexpr double kMost = 1000.0;  // steps of a lesson, choices of a question

QuestionState read_answer(const MemberReader& node) {
  QuestionState answer;
  constexpr double any = std::numeric_limits<double>::max();
  if (!node.has_only({"choice", "number", "truth"})) return answer;
  if (node.has("choice")) answer.choice = int(node.member("choice").number(0, kMost));
  if (!node.has("number")) return answer;
  answer.number = node.member("number").number(-any, any);
  answer.truth = node.member("truth", true).number(-any, any);
  return answer;
}

StepProgress read_step(const MemberReader& node) {
  StepProgress step;
  if (!node.has_only({"heading", "finished", "answers", "tasks"})) return step;
  if (node.has("heading")) step.heading = node.member("heading").text();
  step.finished = node.member("finished", true).boolean();
  for (const MemberReader& answer : node.member("answers", true).elements()) step.answers.push_back(read_answer(answer));
  for (const MemberReader& done : node.member("tasks", true).elements()) step.tasks.push_back(done.boolean());
  return step;
}

LessonProgress read_lesson_progress(const MemberReader& node, bool counts_only) {
  LessonProgress progress;
  if (!node.has_only(counts_only ? std::vector<std::string>{"step", "steps", "finished"}
                                 : std::vector<std::string>{"step", "steps"}))
    return progress;
  const auto count = [&](const char* member) { return std::size_t(node.member(member, true).number(0, kMost)); };
  progress.step = count("step");
  if (counts_only) {
    progress.steps.resize(count("steps"));
    for (StepProgress& step : progress.steps) step.finished = count("finished") == progress.steps.size();
  } else {
    for (const MemberReader& step : node.member("steps", true).elements()) progress.steps.push_back(read_step(step));
  }
  return progress;
}

JsonNode answer_node(const QuestionState& answer) {
  JsonNode node = JsonNode::object();
  if (answer.choice) node["choice"] = JsonNode::integer(*answer.choice);
  if (answer.number) node["number"] = *answer.number, node["truth"] = answer.truth;
  return node;
}

JsonNode step_node(const StepProgress& step) {
  JsonNode node = JsonNode::object();
  if (!step.heading.empty()) node["heading"] = step.heading;
  node["finished"] = JsonNode::boolean(step.finished);
  JsonNode& answers = node["answers"] = JsonNode::array();
  for (const QuestionState& answer : step.answers) answers.push_back(answer_node(answer));
  JsonNode& tasks = node["tasks"] = JsonNode::array();
  for (const bool done : step.tasks) tasks.push_back(JsonNode::boolean(done));
  return node;
}

}  // namespace

Result<ProgressByLesson> read_progress(const fs::path& file) {
  std::error_code error;
  ProgressByLesson progress;
  if (!fs::exists(file, error)) return progress;
  const auto text = read_text_file(file);
  if (!text) return text.error();
  const auto tree = parse_json(*text);
  if (!tree) return InputError{quotable(file.string()) + ":" + tree.error().text};
  ReadState state{file.string(), std::nullopt};
  const MemberReader root(state, *tree, "");
  root.has_only({"psmlab_progress", "lessons"});
  const bool counts_only = root.member("psmlab_progress", true).number(1, kVersion) < kVersion;
  const MemberReader lessons = root.member("lessons", true);
  for (const std::string& name : lessons.node().names) progress[name] = read_lesson_progress(lessons.member(name), counts_only);
  if (state.error) return *state.error;
  return progress;
}

std::optional<InputError> write_progress(const ProgressByLesson& progress, const fs::path& file) {
  JsonNode root = JsonNode::object();
  root["psmlab_progress"] = JsonNode::integer(kVersion);
  JsonNode& lessons = root["lessons"] = JsonNode::object();
  for (const auto& [name, p] : progress) {
    JsonNode& lesson = lessons[name] = JsonNode::object();
    lesson["step"] = JsonNode::integer((long long)p.step);
    JsonNode& steps = lesson["steps"] = JsonNode::array();
    for (const StepProgress& step : p.steps) steps.push_back(step_node(step));
  }
  std::error_code ignored;
  fs::create_directories(file.parent_path(), ignored);
  return write_file_atomically(file, root.to_text() + "\n");
}

}  // namespace psm
