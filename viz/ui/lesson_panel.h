// SPDX-License-Identifier: GPL-3.0-or-later
// The pane at the left: the list of lessons, or a step of one with its text, controls, questions and tasks.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "ui/lesson_session.h"
#include "ui/light_controls.h"
#include "ui/page_view.h"

namespace psm {

/// A number of the experiment on its way through a step's animation.
struct LessonPlay {
  double start = 0.0;                    // seconds
  double last = 0.0;                     // what it set last: anything else means that the user has taken over
  std::optional<glm::dvec3> theta_side;  // of the light's angle
};

class LessonPanel {
 public:
  /// Draws into `pane` and edits the experiment by the step's controls. Returns what was asked for.
  std::vector<LessonCommand> draw(UiContext& ui, const LessonSession& session, const Rect& pane, Experiment& experiment);
  /// The list of lessons instead of the open one, or back.
  void show_list(bool shown) { lists_ = shown; }
  bool lists() const { return lists_; }

  /// Moves the animated number; returns whether it goes on.
  bool play(const LessonSession& session, double now, Experiment& experiment);
  void stop() { play_.reset(); }

 private:
  struct Context;
  struct CachedPage {
    std::uint64_t revision = 0;
    double width = 0.0, size = 0.0;
    TextPage page;
  };
  const TextPage& page(const Context& c, const std::string& name, const Prose& prose, double width);
  void prose(Context& c, const std::string& name, const Prose& prose);
  void follow(Context& c, const std::string& link);
  void list(Context& c);
  void title_bar(Context& c);
  void step(Context& c);
  void navigation(Context& c);
  void controls(Context& c);
  void animation_button(Context& c);
  void question(Context& c, std::size_t index);
  void choices(Context& c, std::size_t index);
  void number_answer(Context& c, std::size_t index);
  void verdict(Context& c, std::size_t index);
  void task(Context& c, std::size_t index);

  std::map<std::string, CachedPage> pages_;
  LightControls light_;
  std::map<std::string, double> typed_;  // numbers not yet answered, by the question's name
  std::optional<LessonPlay> play_;
  std::string scrolled_for_;  // the step that the scroll position belongs to
  bool lists_ = false;
};

}  // namespace psm
