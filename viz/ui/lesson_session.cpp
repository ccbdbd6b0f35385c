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

std::optional<ViewId> view_of(const std::string& name) {
  for (const ViewId id : kAllViews)
    if (name == name_of(id)) return id;
  return std::nullopt;
}

}  // namespace

void show_views(const std::vector<std::string>& views, ViewSettings& settings) {
  std::vector<ViewId> tiles;
  for (const std::string& name : views)
    if (const auto id = view_of(name)) tiles.push_back(*id);
  if (tiles.empty()) return;
  settings.tiles = tiles;
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
  if (known)
    progress_ = std::move(*known);
  else
    error_ = known.error().text + "; progress starts afresh";
}

std::optional<Experiment> LessonSession::perform(const LessonCommand& command, const Model& model) {
  using Kind = LessonCommand::Kind;
  if (command.kind == Kind::open) return open(command.text, model);
  if (!run_) return std::nullopt;
  ++revision_;
  error_.clear();
  switch (command.kind) {
    case Kind::close:
      return close();
    case Kind::go_to:
      return shown(run_->go_to(command.index, model.experiment()));
    case Kind::reset_step:
      return shown(run_->reset_step());
    case Kind::reset_lesson:
      return shown(run_->reset_all());
    case Kind::set:
      if (const auto members = members_of_link(command.text)) return over(*members, model, "link");
      return std::nullopt;
    case Kind::choose:
    case Kind::answer:
    case Kind::show_answer:
      return answer(command, model);
    case Kind::hint:
      run_->state().tasks[command.index].hints++;
      return std::nullopt;
    case Kind::solve:
      run_->state().tasks[command.index].shown = true;
      return over(run_->step().tasks[command.index].solution, model, "solution");
    case Kind::open:
      break;
  }
  return std::nullopt;
}

std::optional<Experiment> LessonSession::open(const std::string& asked, const Model& model) {
  std::string name = asked;
  const std::size_t step = take_lesson_step(name);
  const auto entry = std::find_if(shipped_.begin(), shipped_.end(), [&](const LessonEntry& e) { return e.name == name; });
  const fs::path beside = run_ ? run_->lesson().folder.parent_path() / name : fs::path(name);
  std::error_code none;
  const fs::path folder = fs::exists(beside / "lesson.json", none) || entry == shipped_.end() ? beside : entry->folder;
  auto lesson = read_lesson(folder);
  if (!lesson) return error_ = lesson.error().text, std::nullopt;
  const Experiment own = run_ ? run_->own() : model.experiment();
  LessonRun next(std::move(*lesson), own);
  const auto known = progress_.find(next.lesson().name);
  const bool goes_on = asked == name && known != progress_.end() && known->second.step < next.lesson().steps.size();
  auto experiment = next.go_to(goes_on ? known->second.step : step, own);
  if (!experiment) return error_ = experiment.error().text, std::nullopt;
  run_.emplace(std::move(next));
  error_.clear();
  ++revision_;
  look_at_files();
  return shown(std::move(experiment));
}

std::optional<Experiment> LessonSession::close() {
  keep_progress();
  const Experiment own = run_->own();
  run_.reset();
  return own;
}

/// The step's views stand where its own experiment does not say otherwise.
std::optional<Experiment> LessonSession::shown(Result<Experiment> experiment) {
  if (!experiment) return error_ = experiment.error().text, std::nullopt;
  if (*experiment == run_->start()) show_views(run_->step().views, experiment->view);
  analysis_ = 0;  // tasks are checked again, whatever is shown
  keep_progress();
  return *experiment;
}

std::optional<Experiment> LessonSession::answer(const LessonCommand& command, const Model& model) {
  const Question& question = run_->step().questions[command.index];
  QuestionState& state = run_->state().questions[command.index];
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

void LessonSession::look_at_files() {
  written_.clear();
  std::error_code none;
  for (const char* name : {"lesson.json", "text.md"}) written_.push_back(fs::last_write_time(run_->lesson().folder / name, none));
}

std::optional<Experiment> LessonSession::read_again(const Model& model) {
  ++revision_;
  auto lesson = read_lesson(run_->lesson().folder);
  if (!lesson) return error_ = lesson.error().text, std::nullopt;
  error_.clear();
  // What is on the screen differs from the step's start by its views alone where nobody has touched it.
  Experiment current = model.experiment();
  Experiment start = run_->start();
  show_views(run_->step().views, start.view);
  const bool untouched = current == start;
  return shown(run_->replace(std::move(*lesson), untouched ? run_->start() : current));
}

std::optional<Experiment> LessonSession::update(const Model& model, double now, bool moving) {
  if (!run_) return std::nullopt;
  if (analysis_ != model.texels_revision() || view_ != model.experiment().view) {
    analysis_ = model.texels_revision(), view_ = model.experiment().view;
    values_ = state_of(model.loaded(), model.analysis());
    ++revision_;
    unchecked_ = true;
  }
  if (!moving && std::exchange(unchecked_, false) && run_->check_tasks(values_, analyze_plainly)) ++revision_, keep_progress();
  if (now - looked_ < look_seconds) return std::nullopt;
  looked_ = now;
  const auto before = written_;
  look_at_files();
  return before == written_ ? std::nullopt : read_again(model);
}

std::vector<ViewId> LessonSession::covered() const {
  std::vector<ViewId> ids;
  if (!run_) return ids;
  for (const std::string& name : run_->covered())
    if (const auto id = view_of(name)) ids.push_back(*id);
  return ids;
}

Emphasis LessonSession::emphasis() const { return run_ ? emphasis_of(run_->step()) : Emphasis{}; }

bool LessonSession::needs_texels() const { return run_ && run_->step().written.find("error.texels.") != std::string::npos; }

double LessonSession::next_look(double now) const {
  return run_ ? std::max(0.0, looked_ + look_seconds - now) : std::numeric_limits<double>::infinity();
}

void LessonSession::keep_progress() {
  if (!run_) return;
  LessonProgress& known = progress_[run_->lesson().name];
  const LessonProgress now = run_->progress();
  const LessonProgress next{now.step, now.steps, std::max(now.finished, known.steps == now.steps ? known.finished : 0)};
  if (next == known) return;
  known = next;
  if (progress_file_.empty()) return;
  if (const auto error = write_progress(progress_, progress_file_)) error_ = error->text;
}

}  // namespace psm
