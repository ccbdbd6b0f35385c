// SPDX-License-Identifier: GPL-3.0-or-later
// The pane at the left: the list of lessons, or a step of one with its text, controls, questions and tasks.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "ui/lesson_session.h"
#include "ui/lesson_stage.h"
#include "ui/light_controls.h"
#include "ui/number_play.h"
#include "ui/page_view.h"

namespace psm {

class LessonPanel {
 public:
  /// Draws into `pane` and edits the experiment by the step's controls. Returns what was asked for.
  std::vector<LessonCommand> draw(UiContext& ui, const LessonSession& session, const Rect& pane, Experiment& experiment);
  /// The list of lessons instead of the open one, or back.
  void show_list(bool shown) { lists_ = shown; }
  bool lists() const { return lists_; }

  /// In front of a class: sets the step for a window of this size whose text may use `height` of it, and returns the width of the
  /// text's column, in pixels. What is set stays as it is until it no longer fits.
  double set_stage(UiContext& ui, const LessonSession& session, glm::ivec2 window, int height, Experiment& experiment);
  /// As `draw`, after set_stage: one screen of the step, without anything that only a student needs.
  std::vector<LessonCommand> draw_stage(UiContext& ui, const LessonSession& session, const Rect& pane, Experiment& experiment);
  /// To another screen of the same step; false: it has none there. `by`: 1 or -1.
  bool turn_screen(int by);
  /// The step that set_stage meets next is entered from behind: at its last screen.
  void enter_at_end() { enters_at_end_ = true; }
  std::size_t screen() const { return screen_; }
  const StageFit& stage() const { return stage_; }
  /// The first question of this screen that nobody has answered, and the first task that is not done.
  std::optional<std::size_t> open_question() const { return open_question_; }
  std::optional<std::size_t> open_task() const { return open_task_; }

  /// Moves the animated number; whether it has.
  bool play(const LessonSession& session, double now, Experiment& experiment);
  void stop() { play_.reset(); }
  bool playing() const { return play_.has_value(); }

 private:
  struct Context;
  /// A piece of a step that no screen divides.
  struct Part {
    double height = 0.0;                 // pixels, with what an answer may add
    std::function<void(Context&)> draw;  // at the cursor; empty: nothing yet
    bool begins = false;                 // a group: its parts share a screen where one can hold them
    bool too_wide = false;               // something in it is wider than the column
    std::optional<std::size_t> question = std::nullopt, task = std::nullopt;  // that it asks, and that is open
  };
  struct CachedPage {
    std::uint64_t revision = 0;
    double width = 0.0, size = 0.0;
    TextPage page;
    bool too_wide = false;
  };
  struct StageKey {
    std::string step;
    glm::ivec2 window{0};
    int height = 0;
    float font = 0.0f;
    bool operator==(const StageKey&) const = default;
  };
  using Parts = std::vector<Part>;
  const CachedPage& page(const Context& c, const std::string& name, const Prose& prose, double width);
  void prose(Context& c, const std::string& name, const Prose& prose);
  Part prose_part(const Context& c, const std::string& name, const Prose& prose);
  void follow(Context& c, const std::string& link);
  void list(Context& c);
  void title_bar(Context& c);
  void step(Context& c);
  void navigation(Context& c);

  Parts step_parts(const Context& c);
  void text_parts(const Context& c, Parts& parts);
  void control_parts(const Context& c, Parts& parts);
  void animation_button(Context& c);
  void question_parts(const Context& c, std::size_t index, Parts& parts);
  Part choice_part(const Context& c, std::size_t question, std::size_t choice);
  void draw_choice(Context& c, std::size_t question, std::size_t choice);
  void number_answer(Context& c, std::size_t index);
  void task_parts(const Context& c, std::size_t index, Parts& parts);
  void task_buttons(Context& c, std::size_t index);
  std::optional<std::vector<PartSize>> part_sizes(const Context& c);

  std::map<std::string, CachedPage> pages_;
  LightControls light_;
  std::map<std::string, double> typed_;  // numbers not yet answered, by the question's name
  std::optional<NumberPlay> play_;
  std::string shown_step_;                   // that pages, scroll position and animation belong to
  std::optional<std::size_t> answered_now_;  // a question whose verdict is to be scrolled to
  bool lists_ = false;
  StageFit stage_;
  StageKey stage_key_;
  std::size_t screen_ = 0;
  std::optional<std::size_t> open_question_, open_task_;
  bool enters_at_end_ = false;
};

}  // namespace psm
