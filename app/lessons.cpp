// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons.h"

#include <algorithm>
#include <iterator>
#include <memory>

#include "app/assets.h"
#include "app/command_line.h"
#include "app/commands.h"
#include "app/numbers.h"
#include "draw/font_face.h"
#include "measure/ray_tracer.h"
#include "measure/texel_analysis.h"
#include "measure/visible_image.h"

namespace psm {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names_of(const std::vector<fs::path>& folders) {
  std::vector<std::string> names;
  for (const fs::path& folder : folders) names.push_back(folder.filename().string());
  return names;
}

/// The folder that a FILE means; nothing where there is none.
Result<fs::path> lesson_folder(const std::string& file) {
  std::error_code error;
  const fs::path path = lesson_folder_of(file);
  if (path != fs::path(file)) return path;
  if (fs::is_directory(path, error)) return path;
  const fs::path shipped = lessons_folder() / path;
  if (!file.empty() && path.is_relative() && fs::exists(shipped / "lesson.json", error)) return shipped;
  return InputError{quotable(file) +
                    ": is no lesson; allowed: a lesson's folder, its lesson.json, or the name of a lesson that "
                    "psmlab lesson list prints"};
}

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string verdict(const Lesson& lesson) {
  std::size_t questions = 0, tasks = 0, claims = 0;
  for (const Step& step : lesson.steps)
    questions += step.questions.size(), tasks += step.tasks.size(), claims += step.claims.size();
  return lesson.name + ": fine: " + counted(lesson.steps.size(), "step") + ", " + counted(questions, "question") + ", " +
         counted(tasks, "task") + ", " + counted(claims, "claim") + "\n";
}

/// Lessons beside this one, and the shipped ones.
std::vector<std::string> reachable_lessons(const fs::path& folder) {
  std::vector<std::string> names = names_of(lesson_folders(fs::absolute(folder).lexically_normal().parent_path()));
  for (const std::string& name : names_of(lesson_folders(lessons_folder())))
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

struct FoundStep {
  Lesson lesson;
  std::size_t index = 0;
};

/// Of "NAME" or "NAME/3", as --lesson takes it.
Result<FoundStep> find_step(const std::string& argument) {
  std::string name = argument;
  const std::size_t step = take_lesson_step(name);
  const auto folder = lesson_folder(name);
  auto lesson = folder ? read_lesson(*folder) : folder.error();
  if (!lesson) return InputError{"--lesson " + lesson.error().text};
  const std::size_t count = lesson->steps.size();
  if (step >= count) return flag_error("--lesson", argument, "a step from 1 to " + std::to_string(count));
  return FoundStep{std::move(*lesson), step};
}

}  // namespace

Analyze ray_traced_analyze() {
  struct Last {
    std::string source;
    std::optional<RayTracer> tracer;
  };
  const auto last = std::make_shared<Last>();
  return [last](const LoadedExperiment& loaded, bool texels) {
    if (texels) return analyze_with_texels(loaded.experiment, loaded.scene);
    const std::string source = (loaded.base / loaded.experiment.scene.source).string();
    if (!last->tracer || last->source != source) last->source = source, last->tracer.emplace(loaded.scene);
    return analyze(loaded.experiment, loaded.scene, *last->tracer);
  };
}

std::optional<InputError> check_lesson_argument(const std::string& argument) {
  const auto found = find_step(argument);
  return found ? std::nullopt : std::optional(found.error());
}

Result<LessonPicture> lesson_picture(const std::string& argument, const std::vector<std::string>& overrides) {
  const auto found = find_step(argument);
  if (!found) return found.error();
  const auto& [lesson, index] = *found;
  const auto given = members_from_overrides(overrides);
  if (!given) return InputError{"--set " + given.error().text};
  ExperimentMembers members = members_at_start(lesson, index);
  members.add(*given);
  auto loaded = load_members(members, "--lesson " + quotable(argument), lesson.folder);
  if (!loaded) return loaded.error();
  const Step& step = lesson.steps[index];
  return LessonPicture{std::move(*loaded), step.views, step.emphasis, step.animation};
}

int list_lessons() {
  std::string text;
  for (const fs::path& folder : lesson_folders(lessons_folder())) {
    const auto lesson = read_lesson(folder);
    if (!lesson) return bad_input(lesson.error());
    text += lesson->name + ": " + lesson->title + ". " + lesson->summary + "\n";
  }
  return finish_printing(print(text));
}

int check_lessons(const std::vector<std::string>& files) {
  std::vector<fs::path> folders;
  for (const std::string& file : files) {
    const auto folder = lesson_folder(file);
    if (!folder) return bad_input(folder.error());
    folders.push_back(*folder);
  }
  if (files.empty()) folders = lesson_folders(lessons_folder());
  const auto font = FontFace::load(font_file());
  if (!font) return other_failure(font.error());
  LessonSurroundings surroundings{ray_traced_analyze(), [&](char32_t point) { return font->has(point); }, {}};
  bool all_fine = true;
  std::string text;
  for (const fs::path& folder : folders) {
    const auto lesson = read_lesson(folder);
    if (!lesson) {
      complain(lesson.error().text);
      all_fine = false;
      continue;
    }
    surroundings.lessons = reachable_lessons(folder);
    const std::vector<InputError> errors = check_lesson(*lesson, surroundings);
    for (const InputError& error : errors) complain(error.text);
    if (errors.empty()) text += verdict(*lesson);
    all_fine = all_fine && errors.empty();
  }
  const int printed = finish_printing(print(text));
  return all_fine ? printed : kBadInput;
}

}  // namespace psm
