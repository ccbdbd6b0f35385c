// SPDX-License-Identifier: GPL-3.0-or-later
#include "lesson/progress_file.h"

#include "lesson/file_text.h"
#include "lesson/member_reader.h"
#include "scene/experiment_file.h"
#include "scene/json_node.h"

namespace psm {

namespace fs = std::filesystem;

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
  const MemberReader lessons = root.member("lessons", true);
  for (const std::string& name : lessons.node().names) {
    const MemberReader lesson = lessons.member(name);
    if (!lesson.has_only({"step", "steps", "finished"})) break;
    const auto count = [&](const char* member) { return std::size_t(lesson.member(member, true).number(0, 1000)); };
    progress[name] = {count("step"), count("steps"), count("finished")};
  }
  if (state.error) return *state.error;
  return progress;
}

std::optional<InputError> write_progress(const ProgressByLesson& progress, const fs::path& file) {
  JsonNode root = JsonNode::object();
  root["psmlab_progress"] = JsonNode::integer(1);
  JsonNode& lessons = root["lessons"] = JsonNode::object();
  for (const auto& [name, p] : progress) {
    JsonNode& lesson = lessons[name] = JsonNode::object();
    lesson["step"] = JsonNode::integer((long long)p.step);
    lesson["steps"] = JsonNode::integer((long long)p.steps);
    lesson["finished"] = JsonNode::integer((long long)p.finished);
  }
  std::error_code ignored;
  fs::create_directories(file.parent_path(), ignored);
  return write_file_atomically(file, root.to_text() + "\n");
}

}  // namespace psm
