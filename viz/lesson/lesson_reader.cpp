// SPDX-License-Identifier: GPL-3.0-or-later
// lesson.json and text.md as one Lesson.
#include <algorithm>
#include <array>
#include <set>

#include "lesson/condition_reader.h"
#include "lesson/file_text.h"
#include "lesson/lesson.h"
#include "scene/control.h"

namespace psm {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestList = 100;  // more of anything in one step is a mistake, and keeps the window busy

template <class Read>
auto read_list(const MemberReader& json, Read read) {
  std::vector<decltype(read(json))> list;
  if (json.node().items.size() > kLongestList)
    json.fail(std::to_string(json.node().items.size()) + " elements; allowed: up to " + std::to_string(kLongestList));
  if (!json.fine()) return list;
  for (const MemberReader& element : json.elements()) list.push_back(read(element));
  return list;
}

/// Roles that a step may stress or leave out.
constexpr std::array kRoles{Role::frustum,    Role::light,    Role::caster_body, Role::receivers_body, Role::vanishing_plane,
                            Role::map_window, Role::infinity, Role::texel_grid,  Role::scene_bounds};

/// Some of these values, by their names.
template <class Value, std::size_t N>
std::vector<Value> read_named(const MemberReader& json, const std::array<Value, N>& allowed, std::size_t most) {
  std::vector<std::string> names;
  for (const Value value : allowed) names.push_back(name_of(value));
  auto values = read_list(json, [&](const MemberReader& element) {
    const auto found = std::find(names.begin(), names.end(), element.one_of(names));
    return found == names.end() ? Value{} : allowed[std::size_t(found - names.begin())];
  });
  if (json.fine() && (values.empty() || values.size() > most))
    json.fail(std::to_string(values.size()) + " names; allowed: 1 to " + std::to_string(most));
  if (json.fine() && std::set<Value>(values.begin(), values.end()).size() != values.size())
    json.fail("a name given twice; allowed: once");
  return values;
}

std::vector<ViewId> read_views(const MemberReader& json) { return read_named(json, kAllViews, kMostTiles); }
std::vector<Role> read_roles(const MemberReader& json) { return read_named(json, kRoles, kRoles.size()); }

/// A number of the experiment that a slider can set, or the derived angle.
std::string read_control(const MemberReader& json) {
  const std::string path = json.text();
  if (!json.fine() || path == kThetaControl) return path;
  const Field* field = find_field(path);
  if (!field) json.fail(unknown_member(path).text);
  return path;
}

std::vector<std::string> read_controls(const MemberReader& json) {
  auto controls = read_list(json, read_control);
  if (json.fine() && (controls.empty() || controls.size() > 3))
    json.fail(std::to_string(controls.size()) + " controls; allowed: 1 to 3");
  return controls;
}

Animation read_animation(const MemberReader& json) {
  Animation animation;
  if (!json.has_only({"path", "from", "to", "seconds"})) return animation;
  const MemberReader path = json.member("path", true);
  animation.path = path.text();
  if (!json.fine()) return animation;
  const auto range = control_range(animation.path);
  if (!range) return path.fail(range.error().text), animation;
  animation.from = json.member("from", true).number(range->lowest, range->highest);
  animation.to = json.member("to", true).number(range->lowest, range->highest);
  animation.seconds = json.member("seconds", true).number(0.1, 60);
  return animation;
}

void read_choice(const MemberReader& json, Question& question) {
  question.choices = read_list(json.member("choices", true), [](const MemberReader& choice) { return choice.prose(); });
  if (!json.fine()) return;
  if (question.choices.size() < 2 || question.choices.size() > 6)
    return json.member("choices").fail(std::to_string(question.choices.size()) + " choices; allowed: 2 to 6");
  const MemberReader answer = json.member("answer", true);
  const double index = answer.number(0, double(question.choices.size() - 1));
  question.answer_index = int(index);
  if (question.answer_index != index) answer.fail("is not a whole number; allowed: the number of a choice, from 0");
}

Question read_question(const MemberReader& json) {
  Question question;
  question.line = json.line();
  const std::string kind = json.member("kind", true).one_of({"choice", "number"});
  question.kind = kind == "number" ? Question::Kind::number : Question::Kind::choice;
  const bool is_number = question.kind == Question::Kind::number;
  if (!json.fine() || !json.has_only({"kind", "prompt", is_number ? "unit" : "choices", "answer", is_number ? "tolerance" : "why",
                                      "cover", "why", "reveal"}))
    return question;
  question.prompt = json.member("prompt", true).prose();
  question.why = json.member("why", true).prose();
  if (is_number) {
    if (json.has("unit")) question.unit = json.member("unit").text();
    const MemberReader answer = json.member("answer", true);
    if (answer.node().kind == JsonTree::Kind::object) answer.has_only({"value", "with", "curve", "column"});
    if (json.fine()) question.answer = read_quantity(answer);
    question.tolerance = json.member("tolerance", true).number(0, 1e300);
  } else {
    read_choice(json, question);
  }
  if (json.has("cover")) question.cover = read_views(json.member("cover"));
  if (json.has("reveal")) question.reveal = json.member("reveal").experiment();
  return question;
}

Task read_task(const MemberReader& json) {
  Task task;
  task.line = json.line();
  if (!json.has_only({"prompt", "goal", "hints", "done", "solution"})) return task;
  task.prompt = json.member("prompt", true).prose();
  task.done = json.member("done", true).prose();
  task.goal = read_list(json.member("goal", true), [](const MemberReader& condition) { return read_condition(condition, {}); });
  if (json.fine() && task.goal.empty()) json.member("goal").fail("no condition; allowed: at least one");
  if (json.has("hints")) task.hints = read_list(json.member("hints"), [](const MemberReader& hint) { return hint.prose(); });
  task.solution = json.member("solution", true).experiment();
  return task;
}

Claim read_claim(const MemberReader& json) {
  Claim claim;
  claim.condition = read_condition(json, {"says"});
  claim.says = json.member("says", true).text();
  return claim;
}

/// All texts below, so that claims find what is said in questions.
void collect_texts(const JsonTree& node, std::string& out) {
  if (node.kind == JsonTree::Kind::text) out += node.text + "\n";
  for (const JsonTree& item : node.items) collect_texts(item, out);
}

Step read_step(const MemberReader& json) {
  Step step;
  step.line = json.line();
  if (!json.has_only({"heading", "source", "experiment", "continues", "views", "controls", "highlight", "hide", "animation",
                      "questions", "tasks", "claims"}))
    return step;
  step.heading = json.member("heading", true).text();
  if (json.has("source")) step.source = json.member("source").text();
  if (json.has("experiment")) step.experiment = json.member("experiment").experiment();
  if (json.has("continues")) step.continues = json.member("continues").boolean();
  step.views = read_views(json.member("views", true));
  if (json.has("controls")) step.controls = read_controls(json.member("controls"));
  if (json.has("highlight")) step.emphasis.strong = read_roles(json.member("highlight"));
  if (json.has("hide")) step.emphasis.hidden = read_roles(json.member("hide"));
  if (json.has("animation")) step.animation = read_animation(json.member("animation"));
  if (json.has("questions")) step.questions = read_list(json.member("questions"), read_question);
  if (json.has("tasks")) step.tasks = read_list(json.member("tasks"), read_task);
  if (json.has("claims")) step.claims = read_list(json.member("claims"), read_claim);
  for (const char* spoken : {"questions", "tasks"})
    if (const JsonTree* texts = json.node().find(spoken)) collect_texts(*texts, step.written);
  return step;
}

Lesson read_json_part(const MemberReader& json) {
  Lesson lesson;
  if (!json.has_only({"psmlab_lesson", "title", "summary", "base", "steps"})) return lesson;
  const MemberReader version = json.member("psmlab_lesson", true);
  if (json.fine() && !(version.node().kind == JsonTree::Kind::number && version.node().number == 1))
    version.fail(quotable(version.node().to_text()) + " is not allowed; allowed: 1, the version that this program reads");
  lesson.title = json.member("title", true).text();
  lesson.summary = json.member("summary", true).text();
  if (json.has("base")) lesson.base = json.member("base").experiment();
  lesson.steps = read_list(json.member("steps", true), read_step);
  const MemberReader steps = json.member("steps");
  if (json.fine() && (lesson.steps.empty() || lesson.steps.size() > 40))
    steps.fail(std::to_string(lesson.steps.size()) + " steps; allowed: 1 to 40");
  if (json.fine() && lesson.steps[0].continues)
    steps.elements()[0].member("continues").fail("there is no step before the first; allowed: false");
  return lesson;
}

// ---- text.md -----------------------------------------------------------------------------------------------------------

std::string with_single_blanks(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\n' || c == '\r' || c == '\t';
    if (!blank)
      out += c;
    else if (!out.empty() && out.back() != ' ')
      out += ' ';
  }
  return out;
}

/// Lines [first, last) of a text, counted from 1.
std::string lines_between(const std::string& text, int first, int last) {
  std::size_t at = 0;
  const auto skip_line = [&] {
    const std::size_t end = text.find('\n', at);
    at = end == std::string::npos ? text.size() : end + 1;
  };
  for (int line = 1; line < first; ++line) skip_line();
  const std::size_t begin = at;
  for (int line = first; line < last && at < text.size(); ++line) skip_line();
  return text.substr(begin, at - begin);
}

struct Section {
  const Block* heading = nullptr;  // none: the introduction
  Prose blocks;
};

/// The part below each heading of level 2; the first is what stands below the title.
std::vector<Section> sections_of(const Prose& blocks) {
  std::vector<Section> sections(1);
  for (std::size_t i = 1; i < blocks.size(); ++i) {
    if (blocks[i].heading == 2)
      sections.push_back({&blocks[i], {}});
    else
      sections.back().blocks.push_back(blocks[i]);
  }
  return sections;
}

/// A heading of text.md against the words that lesson.json has for it.
void compare_heading(ReadState& text, const Block& heading, const std::string& expected, const std::string& where) {
  if (plain_text(heading) != expected)
    text.fail(heading.line,
              "\"" + quotable(plain_text(heading)) + "\" is not " + where + "; allowed: \"" + quotable(expected) + "\"");
}

void add_texts(ReadState& state, const std::string& source, Lesson& lesson) {
  const auto blocks = parse_markdown(source);
  if (!blocks) {
    state.error = InputError{quotable(state.file) + ":" + blocks.error().text};
    return;
  }
  if (blocks->empty() || (*blocks)[0].heading != 1)
    return state.fail(blocks->empty() ? 1 : (*blocks)[0].line,
                      "no title; allowed: \"# " + quotable(lesson.title) + "\" comes first");
  compare_heading(state, (*blocks)[0], lesson.title, "the title of lesson.json");
  for (std::size_t i = 1; i < blocks->size(); ++i)
    if ((*blocks)[i].heading == 1)
      return state.fail((*blocks)[i].line, "a second title; allowed: one # heading, ## for each step");
  const std::vector<Section> sections = sections_of(*blocks);
  for (std::size_t i = 0; i < lesson.steps.size() && !state.error; ++i) {
    Step& step = lesson.steps[i];
    if (i + 1 >= sections.size())
      return state.fail(
          int(std::count(source.begin(), source.end(), '\n')),
          "step " + std::to_string(i + 1) + " of lesson.json has no section; allowed: \"## " + quotable(step.heading) + "\"");
    const Section& section = sections[i + 1];
    compare_heading(state, *section.heading, step.heading, "the heading of step " + std::to_string(i + 1) + " in lesson.json");
    step.text_line = section.heading->line;
    if (i == 0) step.text = sections[0].blocks;
    step.text.insert(step.text.end(), section.blocks.begin(), section.blocks.end());
    if (section.blocks.empty()) return state.fail(step.text_line, "no text below this heading; allowed: at least a paragraph");
    const int begin = i == 0 ? 1 : step.text_line;
    const int end = i + 2 < sections.size() ? sections[i + 2].heading->line : 1 << 30;
    step.written = with_single_blanks(lines_between(source, begin, end) + " " + step.written);
  }
  if (!state.error && sections.size() > lesson.steps.size() + 1)
    state.fail(sections[lesson.steps.size() + 1].heading->line, "no such step in lesson.json; allowed: a section for each step");
}

}  // namespace

Result<Lesson> read_lesson(const fs::path& folder) {
  const auto json_text = read_text_file(folder / "lesson.json");
  if (!json_text) return json_text.error();
  ReadState json_state{(folder / "lesson.json").string(), std::nullopt};
  const auto tree = parse_json(*json_text);
  if (!tree) return InputError{quotable(json_state.file) + ":" + tree.error().text};
  Lesson lesson = read_json_part(MemberReader(json_state, *tree, ""));
  if (json_state.error) return *json_state.error;
  const auto text = read_text_file(folder / "text.md");
  if (!text) return text.error();
  ReadState text_state{(folder / "text.md").string(), std::nullopt};
  add_texts(text_state, *text, lesson);
  if (text_state.error) return *text_state.error;
  lesson.folder = folder;
  lesson.name = fs::absolute(folder).lexically_normal().filename().string();
  if (lesson.name.empty()) lesson.name = fs::absolute(folder).lexically_normal().parent_path().filename().string();
  return lesson;
}

fs::path lesson_folder_of(const fs::path& given) {
  if (given.filename() != "lesson.json" && given.filename() != "text.md") return given;
  return given.has_parent_path() ? given.parent_path() : fs::path(".");
}

std::size_t take_lesson_step(std::string& name) {
  const std::size_t slash = name.rfind('/');
  if (slash == std::string::npos || slash == 0) return 0;
  const std::string digits = name.substr(slash + 1);
  if (digits.empty() || digits.size() > 3 || digits.find_first_not_of("0123456789") != std::string::npos) return 0;
  const int number = std::stoi(digits);
  if (number == 0) return 0;  // steps count from 1: the whole is a name, which is nobody's
  name.erase(slash);
  return std::size_t(number) - 1;
}

std::string numbered_title(const std::string& name, const std::string& title) {
  const std::size_t end = name.find_first_not_of("0123456789");
  if (end == 0 || end == std::string::npos || name[end] != '_') return title;
  const std::size_t begin = std::min(name.find_first_not_of('0'), end - 1);
  return name.substr(begin, end - begin) + "\u00a0 " + title;
}

std::vector<fs::path> lesson_folders(const fs::path& lessons) {
  std::vector<fs::path> folders;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(lessons, error))
    if (fs::exists(entry.path() / "lesson.json", error)) folders.push_back(entry.path());
  std::sort(folders.begin(), folders.end());
  return folders;
}

}  // namespace psm
