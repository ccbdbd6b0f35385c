// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_session.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace psm {
namespace {

namespace fs = std::filesystem;

constexpr double look_seconds = 1.0;

Analysis analyze_plainly(const LoadedExperiment& loaded, bool) { return analyze(loaded.experiment, loaded.scene); }

/// Two ways to write a folder's name are one lesson.
fs::path whole_path(const fs::path& folder) {
  std::error_code none;
  return fs::weakly_canonical(folder, none);
}

std::vector<fs::file_time_type> times_of_files(const fs::path& folder) {
  std::vector<fs::file_time_type> times;
  std::error_code none;
  for (const char* name : {"lesson.json", "text.md"}) times.push_back(fs::last_write_time(folder / name, none));
  return times;
}

/// Over a step's start: what the answers revealed that are known from an earlier run of the program.
void show_reveals(const LessonRun& run, Experiment& experiment) {
  for (std::size_t i = 0; i < run.step().questions.size(); ++i) {
    const Question& question = run.step().questions[i];
    if (!question.reveal || !run.state().questions[i].answered()) continue;
    Experiment revealed = experiment;
    question.reveal->copy_to(revealed);
    if (!check_experiment(revealed)) experiment = revealed;
  }
}

}  // namespace

void show_views(const std::vector<ViewId>& views, ViewSettings& settings) {
  settings.tiles = views;
  settings.maximised.reset();
}

LessonSession::LessonSession(fs::path lessons, fs::path progress)
    : lessons_(std::move(lessons)), progress_file_(std::move(progress)) {
  for (const fs::path& folder : lesson_folders(lessons_)) {
    const auto lesson = read_lesson(folder);
    if (lesson) shipped_.push_back({folder, lesson->name, lesson->title, lesson->summary});
  }
  if (progress_file_.empty()) return;
  auto known = read_progress(progress_file_);
  if (known) {
    progress_ = std::move(*known);
    return;
  }
  // What a hand could still mend is not written over.
  const fs::path kept = progress_file_.string() + ".damaged";
  std::error_code error;
  fs::rename(progress_file_, kept, error);
  error_ = known.error().text + "; progress starts afresh" + (error ? "" : ", the file is kept as " + kept.filename().string());
}

std::optional<Experiment> LessonSession::perform(const LessonCommand& command, const Model& model) {
  using Kind = LessonCommand::Kind;
  if (!open_ && command.kind != Kind::open) return std::nullopt;
  ++revision_;
  error_.clear();
  switch (command.kind) {
    case Kind::open:
    case Kind::follow:
    case Kind::back:
    case Kind::next_lesson:
      return change_lesson(command, model);
    case Kind::close:
      return close(model);
    case Kind::go_to:
      return shown(open_->run.go_to(command.index, model.experiment()));
    case Kind::reset_step:
      return shown(open_->run.reset_step());
    case Kind::reset_lesson:
      return shown(open_->run.reset_all());
    case Kind::set:
      if (const auto members = members_of_link(command.text)) return over(*members, model, "link");
      return std::nullopt;
    case Kind::choose:
    case Kind::answer:
    case Kind::show_answer:
      return answer(command, model);
    case Kind::hint:
      open_->run.state().tasks[command.index].hints++;
      return std::nullopt;
    case Kind::solve:
      open_->run.state().tasks[command.index].shown = true;
      return over(open_->run.step().tasks[command.index].solution, model, "solution");
  }
  return std::nullopt;
}

fs::path LessonSession::folder_of(const std::string& name) const {
  const auto entry = std::find_if(shipped_.begin(), shipped_.end(), [&](const LessonEntry& e) { return e.name == name; });
  const fs::path beside = open_ ? open_->run.lesson().folder.parent_path() / name : fs::path(name);
  std::error_code none;
  return fs::exists(beside / "lesson.json", none) || entry == shipped_.end() ? beside : entry->folder;
}

const LessonEntry* LessonSession::next_lesson() const {
  if (!open_) return nullptr;
  const fs::path here = whole_path(open_->run.lesson().folder);
  const auto is_here = [&](const LessonEntry& entry) { return whole_path(entry.folder) == here; };
  const auto found = std::find_if(shipped_.begin(), shipped_.end(), is_here);
  return shipped_.end() - found > 1 ? &found[1] : nullptr;
}

std::optional<Experiment> LessonSession::change_lesson(const LessonCommand& command, const Model& model) {
  using Kind = LessonCommand::Kind;
  std::string name = command.text;
  const std::size_t step = take_lesson_step(name);
  if (command.kind == Kind::open) {
    const bool as_left = name == command.text;
    auto shown = open(folder_of(lesson_folder_of(name).string()), as_left ? std::nullopt : std::optional(step), model);
    if (shown) way_back_.clear();
    return shown;
  }
  if (command.kind == Kind::back) {
    if (way_back_.empty()) return std::nullopt;
    auto shown = open(way_back_.back().folder, way_back_.back().step, model);
    if (shown) way_back_.pop_back();
    return shown;
  }
  const LessonEntry* next = next_lesson();
  const bool linked = command.kind == Kind::follow;
  if (!linked && !next) return std::nullopt;
  const Lesson& left = open_->run.lesson();
  const LessonPlace place{whole_path(left.folder), open_->run.index(), numbered_title(left.name, left.title), linked};
  auto shown = open(linked ? folder_of(name) : next->folder, step, model);
  if (shown) way_back_.push_back(place);
  return shown;
}

/// Without a step: at the one that was left. On an error nothing changes.
std::optional<Experiment> LessonSession::open(const fs::path& folder, std::optional<std::size_t> step, const Model& model) {
  if (open_) open_->run.leave(model.experiment());
  const auto known = opened_.find(whole_path(folder));
  std::optional<Opened> next;
  if (known != opened_.end()) {
    next = known->second;
  } else {
    auto lesson = read_lesson(folder);
    if (!lesson) return error_ = lesson.error().text, std::nullopt;
    const auto progress = progress_.find(lesson->name);
    next = Opened{LessonRun(std::move(*lesson), progress == progress_.end() ? LessonProgress() : progress->second),
                  times_of_files(folder)};
  }
  LessonRun& run = next->run;
  auto experiment = run.go_to(step.value_or(run.index()), run.state().left.value_or(model.experiment()));
  if (!experiment) return error_ = experiment.error().text, std::nullopt;
  if (!open_) own_ = model.experiment();
  open_ = &opened_.insert_or_assign(whole_path(folder), std::move(*next)).first->second;
  return shown(std::move(experiment));
}

std::optional<Experiment> LessonSession::close(const Model& model) {
  open_->run.leave(model.experiment());
  keep_progress();
  open_ = nullptr;
  way_back_.clear();
  return own_;
}

/// The step's views stand where its own experiment does not say otherwise, and so does what its answers revealed.
std::optional<Experiment> LessonSession::shown(Result<Experiment> experiment) {
  if (!experiment) return error_ = experiment.error().text, std::nullopt;
  if (*experiment == open_->run.start()) {
    show_views(open_->run.step().views, experiment->view);
    show_reveals(open_->run, *experiment);
  }
  analysis_ = 0;  // tasks are checked again, whatever is shown
  keep_progress();
  return *experiment;
}

std::optional<Experiment> LessonSession::answer(const LessonCommand& command, const Model& model) {
  const Question& question = open_->run.step().questions[command.index];
  QuestionState& state = open_->run.state().questions[command.index];
  if (question.kind == Question::Kind::number) {
    const auto truth = evaluate(question.answer, values_, analyze_plainly);
    const double* number = truth ? std::get_if<double>(&*truth) : nullptr;
    if (!number) return error_ = "this experiment has no such number; reset the step", std::nullopt;
    state.truth = *number;
  }
  if (command.kind == LessonCommand::Kind::choose) state.choice = command.choice;
  if (command.kind == LessonCommand::Kind::answer) state.number = command.number;
  state.shown = command.kind == LessonCommand::Kind::show_answer;
  keep_progress();
  return question.reveal ? over(*question.reveal, model, "reveal") : std::nullopt;
}

std::optional<Experiment> LessonSession::over(const ExperimentMembers& members, const Model& model, const std::string& place) {
  auto next = with_members(model.loaded(), members, place);
  if (!next) return error_ = next.error().text, std::nullopt;
  return next->experiment;
}

std::optional<Experiment> LessonSession::read_again(const Model& model) {
  ++revision_;
  auto lesson = read_lesson(open_->run.lesson().folder);
  if (!lesson) return error_ = lesson.error().text, std::nullopt;
  error_.clear();
  // What is on the screen differs from the step's start by its views alone where nobody has touched it.
  Experiment current = model.experiment();
  Experiment start = open_->run.start();
  show_views(open_->run.step().views, start.view);
  const bool untouched = current == start;
  return shown(open_->run.replace(std::move(*lesson), untouched ? open_->run.start() : current));
}

std::optional<Experiment> LessonSession::update(const Model& model, double now, bool moving) {
  if (!open_) return std::nullopt;
  if (analysis_ != model.texels_revision() || view_ != model.experiment().view) {
    analysis_ = model.texels_revision(), view_ = model.experiment().view;
    values_ = state_of(model.loaded(), model.analysis());
    ++revision_;
    unchecked_ = true;
  }
  if (!moving && std::exchange(unchecked_, false) && open_->run.check_tasks(values_, analyze_plainly))
    ++revision_, keep_progress();
  if (now - looked_ < look_seconds) return std::nullopt;
  looked_ = now;
  const auto before = std::exchange(open_->written, times_of_files(open_->run.lesson().folder));
  return before == open_->written ? std::nullopt : read_again(model);
}

bool LessonSession::needs_texels() const { return open_ && open_->run.step().written.find("error.texels.") != std::string::npos; }

bool LessonSession::files_changed() const { return open_ && times_of_files(open_->run.lesson().folder) != open_->written; }

double LessonSession::seconds_to_look() const { return open_ ? look_seconds : std::numeric_limits<double>::infinity(); }

void LessonSession::keep_progress() {
  LessonProgress now = open_->run.progress();
  LessonProgress& known = progress_[open_->run.lesson().name];
  if (now == known) return;
  known = std::move(now);
  if (progress_file_.empty()) return;
  if (const auto error = write_progress(progress_, progress_file_)) error_ = error->text;
}

}  // namespace psm
