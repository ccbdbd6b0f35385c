// SPDX-License-Identifier: GPL-3.0-or-later
// The quiz beside the explorer's map: the light seen from the side, the question, the answers, the reason, the score.
#pragma once

#include <optional>

#include "scene/light_quiz.h"
#include "ui/ui_context.h"

namespace psm {

struct QuizClicks {
  std::optional<int> answer;
  bool next = false, show = false, close = false;  // the next question; the light into the experiment; no quiz any more
  bool reset_score = false;
};

/// Over this part of the explorer's picture.
QuizClicks quiz_panel(UiContext& ui, const Rect& place, const LightQuiz& quiz);

}  // namespace psm
