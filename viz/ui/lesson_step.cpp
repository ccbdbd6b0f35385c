// SPDX-License-Identifier: GPL-3.0-or-later
// A step of a lesson as parts, one below the other: the pane scrolls through them, a screen in front of a class holds some.
#include "ui/field_widgets.h"
#include "ui/lesson_context.h"
#include "ui/theme.h"

namespace psm {
namespace {

std::vector<Prose> blocks_of(const Prose& prose) {
  std::vector<Prose> blocks;
  for (const Block& block : prose) blocks.push_back({block});
  return blocks;
}

/// Beside controls of other groups a bare "position" could be anybody's.
std::string control_label(const Field& field) {
  if (field.path == "light.to_light") return "direction to light";
  const std::string label = field_label(field);
  return field.path.starts_with("light.") ? "light " + label : field.path.starts_with("camera.") ? "camera " + label : label;
}

}  // namespace

LessonPanel::Parts LessonPanel::step_parts(const Context& c) {
  const Step& now = c.run().step();
  const std::string name = c.run().lesson().name + "/" + std::to_string(c.run().index() + 1);
  if (std::exchange(shown_step_, name) != name) {
    pages_.clear();
    play_.reset();
  }
  Parts parts;
  text_parts(c, parts);
  if (!now.controls.empty() || now.animation) control_parts(c, parts);
  for (std::size_t i = 0; i < now.questions.size(); ++i) question_parts(c, i, parts);
  for (std::size_t i = 0; i < now.tasks.size(); ++i) task_parts(c, i, parts);
  return parts;
}

void LessonPanel::text_parts(const Context& c, Parts& parts) {
  const Step& step = c.run().step();
  if (c.staged && !c.session.error().empty()) {
    const std::string words = "▲ " + c.session.error();
    parts.push_back({c.words_height(words), [words](Context& now) { toned_words(warning_color(now.ui.theme), words); }});
  }
  parts.push_back(prose_part(c, "heading", heading_prose(step.heading, 2)));
  parts.back().begins = true;
  const auto space = [&](double em) {
    parts.push_back({em * c.style.size, [=](Context& now) { ImGui::Dummy({0, float(em * now.style.size)}); }});
  };
  space(0.2);
  if (c.staged) {
    // A long text goes on on the next screen, between two of its paragraphs.
    const std::vector<Prose> blocks = blocks_of(step.text);
    for (std::size_t i = 0; i < blocks.size(); ++i) parts.push_back(prose_part(c, "text." + std::to_string(i), blocks[i]));
  } else {
    parts.push_back(prose_part(c, "text", step.text));
  }
  if (step.source.empty()) return;
  const std::string words = "Source: " + step.source;
  parts.push_back({c.words_height(words), [words](Context&) {
                     ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
                     wrapped_words(words);
                     ImGui::PopStyleColor();
                   }});
}

void LessonPanel::animation_button(Context& c) {
  const Animation& animation = *c.run().step().animation;
  const auto control = find_control(animation.path, c.experiment);
  if (!control) return;  // another type of light, say
  if (c.button(play_ ? "■ Stop" : "▶ Play", "lesson.play")) {
    if (play_) return play_.reset();
    play_ = NumberPlay{animation, *control, ImGui::GetTime()};
  }
  rest_tooltip("Plays " + animation.path + ".");
}

bool LessonPanel::play(const LessonSession& session, double now, Experiment& experiment) {
  if (!session.run() || !session.run()->step().animation) play_.reset();
  return move_number(play_, experiment, now);
}

void LessonPanel::control_parts(const Context& c, Parts& parts) {
  parts.push_back({c.part_heading_height(), [](Context&) { part_heading("Try it"); }, true});
  for (const std::string& path : c.run().step().controls) {
    if (path == kThetaControl) {
      const double lines = c.style.size + c.gap() + c.widget_height() + 0.6 * c.style.size;  // caption, slider, its ticks' names
      parts.push_back({lines, [this](Context& now) {
                         if (now.experiment.light.type == LightType::directional) theta_slider(now.ui, light_, now.experiment);
                       }});
    } else if (const Field* field = find_field(path)) {
      const int lines = field_row_lines(*field);
      parts.push_back({lines * c.widget_height() + (lines - 1) * c.gap(),
                       [field](Context& now) { field_row(now.ui, *field, now.experiment, control_label(*field)); }});
    }
  }
  if (c.run().step().animation) parts.push_back({c.widget_height(), [this](Context& now) { animation_button(now); }});
}

}  // namespace psm
