// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of the analysis and every note, as text.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "draw/probe.h"
#include "scene/analysis.h"
#include "ui/control_pane.h"
#include "ui/ui_context.h"

namespace psm {

struct NumberLine {
  std::string name, value, help;
};

/// "—" where the technique has no such quantity.
std::vector<NumberLine> number_lines(const Analysis& analysis);

/// A note with its value and limit.
std::string note_text(const Note& note);

/// Notes of the scene's file and of the analysis.
std::vector<Note> all_notes(const Scene& scene, const Analysis& analysis);

/// `settings`: which language and convention matrices are copied in. `second`: of technique B, beside A's; or null. `show_notes`:
/// scrolls to the notes.
void numbers_pane(UiContext& ui, const Analysis* second, const std::optional<Probe>& probe, Settings& settings,
                  Requests& requests, bool show_notes);

}  // namespace psm
