// SPDX-License-Identifier: GPL-3.0-or-later
// The lesson in the window: its pane, its keys, the views that its questions cover.
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>

#include "ui/workbench.h"
#include "ui/workbench_frame.h"

namespace psm {
namespace {

/// What stays in the same step: what has changed is to be seen changing.
bool reveals(const LessonCommand& command) {
  using Kind = LessonCommand::Kind;
  return command.kind == Kind::set || command.kind == Kind::choose || command.kind == Kind::answer ||
         command.kind == Kind::show_answer || command.kind == Kind::solve;
}

/// What brings another step, and with it an experiment that belongs to its text.
bool enters_step(LessonCommand::Kind kind) {
  using Kind = LessonCommand::Kind;
  return kind == Kind::open || kind == Kind::follow || kind == Kind::back || kind == Kind::next_lesson || kind == Kind::go_to;
}

/// ImGui would now begin to use the arrow keys.
void forget_navigation() {
  ImGuiContext& g = *ImGui::GetCurrentContext();
  g.NavDisableHighlight = true;
  g.NavId = 0;
  g.NavInitRequest = false;
}

}  // namespace

void Workbench::lesson_pane(Frame& f) {
  const bool shown = !f.layout.lesson.empty();
  images_.set_emphasis(shown ? lessons_.emphasis() : Emphasis{});
  if (f.layout.lesson.empty()) return;
  if (lesson_panel_.play(lessons_, f.now, f.edited)) f.tag = "play lesson", wake();
  auto commands = stages_lesson() ? lesson_panel_.draw_stage(f.ui, lessons_, f.layout.lesson, f.edited)
                                  : lesson_panel_.draw(f.ui, lessons_, f.layout.lesson, f.edited);
  for (LessonCommand& command : commands) lesson_commands_.push_back(std::move(command));
}

/// All of them were asked of the step on the screen: once another one is there, what is left means nothing.
void Workbench::perform(const std::vector<LessonCommand>& commands) {
  const LessonRun* run = lessons_.run();
  const std::size_t step = run ? run->index() : 0;
  for (const LessonCommand& command : commands) {
    perform(command);
    if (lessons_.run() != run || (run && run->index() != step)) return;
  }
}

void Workbench::perform(const LessonCommand& command) {
  const bool was_open = lessons_.run() != nullptr;
  movements_.finish_reveal(ImGui::GetTime());
  lesson_panel_.stop();
  const auto next = lessons_.perform(command, model_);
  if (!was_open && lessons_.run()) own_history_ = model_.replace_history(History());
  if (next && reveals(command))
    reveal(*next);
  else
    show_lesson_experiment(next);
  // Undo stays within a step: its text would not fit the experiment of another. The student's own history comes back.
  if (lessons_.run() && enters_step(command.kind) && next) model_.replace_history(History());
  if (was_open && !lessons_.run()) model_.replace_history(std::exchange(own_history_, History()));
  if (enters_step(command.kind) && lessons_.run() && lessons_.error().empty()) lesson_panel_.show_list(false);
  if (was_open && !lessons_.run()) toggle_lesson_pane();
}

/// Another scene has nothing in common with this one: it is there at once.
void Workbench::reveal(const Experiment& to) {
  drag_ = {};
  if (settings_.reduced_motion || to.scene != model_.experiment().scene) return commit_now(to);
  movements_.play_reveal(to, ImGui::GetTime());
  wake();
}

/// The step's start is what resets go back to while the lesson is open.
void Workbench::show_lesson_experiment(const std::optional<Experiment>& experiment) {
  if (!experiment) return;
  drag_ = {};
  commit_now(*experiment);
  if (!lessons_.run()) return model_.set_original(std::nullopt);
  Experiment start = lessons_.run()->start();
  show_views(lessons_.run()->step().views, start.view);
  model_.set_original(start);
}

/// The lesson has the controls that it needs; the pane of all of them makes room, and comes back.
void Workbench::toggle_lesson_pane() {
  LayoutSettings& layout = settings_.layout;
  layout.lesson_shown = !layout.lesson_shown;
  if (layout.lesson_shown) {
    pane_before_lesson_ = std::exchange(layout.pane_shown, false);
    if (!lessons_.run()) lesson_panel_.show_list(true);
  } else {
    layout.pane_shown = pane_before_lesson_;
  }
  wake();
}

/// To where one followed a link or came from the lesson before.
void Workbench::lesson_way_back() {
  if (lessons_.way_back() && settings_.layout.lesson_shown)
    lesson_commands_.push_back({LessonCommand::Kind::back, 0, "", 0, 0.0});
}

/// Whether there is a lesson to step through. Beyond its last step is the next lesson, before its first where one came from.
bool Workbench::step_lesson(int by) {
  using Kind = LessonCommand::Kind;
  const LessonRun* run = lessons_.run();
  if (!run || !settings_.layout.lesson_shown || lesson_panel_.lists()) return false;
  if (presenting_ && step_stage(by)) return true;
  const std::ptrdiff_t to = std::ptrdiff_t(run->index()) + by;
  const bool inside = to >= 0 && to < std::ptrdiff_t(run->lesson().steps.size());
  if (!inside && !(by > 0 ? lessons_.has_next_lesson() : lessons_.way_back() != nullptr)) return true;
  if (by < 0) lesson_panel_.enter_at_end();
  const Kind kind = inside ? Kind::go_to : by > 0 ? Kind::next_lesson : Kind::back;
  lesson_commands_.push_back({kind, std::size_t(std::max<std::ptrdiff_t>(to, 0)), "", 0, 0.0});
  return true;
}

/// Arrows and page keys step through a lesson, the arrows while nobody uses them for a widget; with Ctrl they are the
/// workbench's. ImGui is told to forget them.
bool Workbench::key_is_free(const KeyPress& press) {
  const bool arrow = press.key == key::left || press.key == key::right;
  const bool page = press.key == key::page_down || press.key == key::page_up;
  if ((!arrow && !page) || drag_.selected) return true;
  if (arrow && press.modifiers.control) {
    ImGui::NavMoveRequestCancel();
    if (!ImGui::GetIO().NavVisible) forget_navigation();
    return !ImGui::IsAnyItemActive();
  }
  if (arrow && !presenting_ && (ImGui::GetIO().NavVisible || ImGui::IsAnyItemActive())) return false;
  if (!lessons_.run() || !settings_.layout.lesson_shown) return true;
  ImGui::NavMoveRequestCancel();
  forget_navigation();
  return true;
}

bool Workbench::is_covered(ViewId id) const {
  const std::vector<ViewId> covered = settings_.layout.lesson_shown ? lessons_.covered() : std::vector<ViewId>();
  return std::find(covered.begin(), covered.end(), id) != covered.end();
}

/// A plate over what a question asks to predict.
void Workbench::cover_tiles(Frame& f) {
  for (const ViewId id : kAllViews) {
    const Rect& rect = f.layout.view(id);
    if (rect.empty() || !is_covered(id)) continue;
    ImDrawList* list = ImGui::GetWindowDrawList();
    const ImVec2 min(float(rect.min.x), float(rect.min.y)), max(float(rect.max.x), float(rect.max.y));
    list->AddRectFilled(min, max, ImGui::GetColorU32(ImGuiCol_FrameBg));
    const char *text = "Predict first: the answer uncovers this view", *longest_word = "uncovers";
    ImFont* font = ImGui::GetFont();
    const float width = 0.8f * float(rect.size().x), full = ImGui::GetFontSize();
    const float px = std::min(full, full * width / ImGui::CalcTextSize(longest_word).x);
    const ImVec2 size = font->CalcTextSizeA(px, 1e9f, width, text);
    list->AddText(font, px, {0.5f * (min.x + max.x - size.x), 0.5f * (min.y + max.y - size.y)}, text_color(), text, nullptr,
                  width);
    places_["cover." + std::string(name_of(id))] = rect;
  }
}

}  // namespace psm
