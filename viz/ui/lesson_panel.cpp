// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_panel.h"

#include <algorithm>
#include <cmath>

#include "scene/light_angles.h"
#include "ui/field_widgets.h"
#include "ui/lesson_context.h"

namespace psm {
namespace {

using Kind = LessonCommand::Kind;

Prose heading_prose(const std::string& text, int level) {
  auto blocks = parse_markdown(std::string(std::size_t(level), '#') + " " + text);
  return blocks ? std::move(*blocks) : Prose{};
}

void wrapped_warning(const UiContext& ui, const std::string& text) {
  const glm::vec3 tone = warning_color(ui.theme);
  ImGui::PushStyleColor(ImGuiCol_Text, {tone.r, tone.g, tone.b, 1.0f});
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(("▲ " + text).c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

}  // namespace

const TextPage& LessonPanel::page(const Context& c, const std::string& name, const Prose& prose, double width) {
  CachedPage& cached = pages_[name];
  const double size = ImGui::GetFontSize();
  if (cached.revision != c.session.revision() || cached.width != width || cached.size != size) {
    const auto live = [&](const std::string& path) { return live_text(c.session.values(), path); };
    cached = {c.session.revision(), width, size, typeset(prose, {width, size, 1.4}, screen_metrics(), live)};
  }
  return cached.page;
}

void LessonPanel::prose(Context& c, const std::string& name, const Prose& prose) {
  const double width = std::floor(ImGui::GetContentRegionAvail().x);
  follow(c, show_page(c.ui, page(c, name, prose, width), name));
}

void LessonPanel::follow(Context& c, const std::string& link) {
  if (link.starts_with("lesson:")) c.ask(Kind::open, 0, link.substr(7));
  if (link.starts_with("set:")) c.ask(Kind::set, 0, link);
  if (link.starts_with("https:")) ImGui::SetClipboardText(link.c_str());
}

std::vector<LessonCommand> LessonPanel::draw(UiContext& ui, const LessonSession& session, const Rect& pane,
                                             Experiment& experiment) {
  Context c{ui, session, pane, experiment, {}};
  const float padding = ImGui::GetStyle().WindowPadding.x, row = ImGui::GetFrameHeightWithSpacing();
  const auto child = [&](const char* name, int top, int bottom, ImGuiWindowFlags flags) {
    ImGui::SetCursorScreenPos({float(pane.min.x), float(top)});
    ImGui::BeginChild(name, {float(std::max(1, pane.size().x)), float(std::max(1, bottom - top))}, false,
                      ImGuiWindowFlags_AlwaysUseWindowPadding | flags);
  };
  constexpr ImGuiWindowFlags still = ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
  const bool listed = lists_ || !session.run();
  const int top = pane.min.y + int(std::ceil(row + padding)),
            bottom = pane.max.y - (listed ? 0 : int(std::ceil(row + 1.5f * padding)));
  ui.places["lesson.pane"] = pane;
  child("lesson title", pane.min.y, top, still);
  title_bar(c);
  ImGui::EndChild();
  child("lesson", top, bottom, 0);
  ui.places["lesson.text"] = {{pane.min.x, top}, {pane.max.x, bottom}};
  if (!session.error().empty()) wrapped_warning(ui, session.error());
  listed ? list(c) : step(c);
  ImGui::EndChild();
  if (!listed) {
    child("lesson steps", bottom, pane.max.y, still);
    navigation(c);
    ImGui::EndChild();
  }
  return std::move(c.commands);
}

void LessonPanel::title_bar(Context& c) {
  const bool listed = lists_ || !c.session.run();
  if (listed) {
    ImGui::TextUnformatted("Lessons");
    if (c.session.run()) {
      ImGui::SameLine();
      if (c.button("Back to the lesson", "lesson.resume")) lists_ = false;
    }
    return;
  }
  if (c.button("Lessons", "lesson.list")) lists_ = true;
  rest_tooltip("The list of lessons.");
  ImGui::SameLine();
  if (c.button("Leave", "lesson.close")) c.ask(Kind::close);
  rest_tooltip("Leave the lesson. Your own experiment comes back.");
  ImGui::SameLine();
  ImGui::TextDisabled("%s", c.run().lesson().title.c_str());
}

void LessonPanel::list(Context& c) {
  const float width = ImGui::GetContentRegionAvail().x, padding = ImGui::GetStyle().FramePadding.x;
  if (c.session.shipped().empty()) ImGui::TextDisabled("There are no lessons beside this program.");
  for (const LessonEntry& entry : c.session.shipped()) {
    Prose prose = heading_prose(entry.title, 3);
    prose.push_back({0, 0, "", false, {{Inline::Kind::words, entry.summary, false, false, "", 0}}, 0});
    const TextPage& text = page(c, "list." + entry.name, prose, std::floor(width - 2 * padding));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const auto known = c.session.progress().find(entry.name);
    const bool begun = known != c.session.progress().end();
    const float line = ImGui::GetTextLineHeight(), height = float(text.height) + (begun ? 1.3f : 0.3f) * line + 2 * padding;
    ImGui::PushID(entry.name.c_str());
    const bool chosen = ImGui::Selectable("##open", false, 0, {width, height});
    ImGui::PopID();
    note_place(c.ui, "lesson.open=" + entry.name);
    const ImVec2 below = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos({at.x + padding, at.y + padding});
    show_page(c.ui, text, "list." + entry.name);
    if (begun) {
      ImGui::SetCursorScreenPos({at.x + padding, at.y + padding + float(text.height) + 0.2f * line});
      const LessonProgress& p = known->second;
      ImGui::TextDisabled("%s %d of %d steps finished", p.finished == p.steps ? "●" : "○", int(p.finished), int(p.steps));
    }
    ImGui::SetCursorScreenPos(below);
    if (chosen) lists_ = false, c.ask(Kind::open, 0, entry.name);
  }
}

void LessonPanel::step(Context& c) {
  const Step& now = c.run().step();
  const std::string name = c.run().lesson().name + "/" + std::to_string(c.run().index() + 1);
  if (std::exchange(scrolled_for_, name) != name) {
    ImGui::SetScrollY(0.0f);
    pages_.clear();
    play_.reset();
  }
  prose(c, "heading", heading_prose(now.heading, 2));
  ImGui::Dummy({0, 0.2f * ImGui::GetFontSize()});
  prose(c, "text", now.text);
  if (!now.source.empty()) {
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextDisabled("Source: %s", now.source.c_str());
    ImGui::PopTextWrapPos();
  }
  if (!now.controls.empty() || now.animation) controls(c);
  for (std::size_t i = 0; i < now.questions.size(); ++i) question(c, i);
  for (std::size_t i = 0; i < now.tasks.size(); ++i) task(c, i);
  part_heading("Start again");
  if (c.button("Reset step", "lesson.reset_step")) c.ask(Kind::reset_step);
  rest_tooltip("This step's experiment, answers and tasks as they were at first.");
  ImGui::SameLine();
  if (c.button("Reset lesson", "lesson.reset_lesson")) c.ask(Kind::reset_lesson);
  rest_tooltip("All steps as if you had never seen them.");
  ImGui::Dummy({0, ImGui::GetFontSize()});
}

void LessonPanel::navigation(Context& c) {
  const std::size_t index = c.run().index(), count = c.run().lesson().steps.size();
  const float width = 5.0f * ImGui::GetFontSize();
  const auto go = [&](const char* label, const char* place, bool possible, std::size_t to) {
    ImGui::BeginDisabled(!possible);
    if (ImGui::Button(label, {width, 0})) c.ask(Kind::go_to, to);
    ImGui::EndDisabled();
    note_place(c.ui, place);
  };
  go("◀ Back", "lesson.back", index > 0, index - 1);
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::Text("%d of %d", int(index + 1), int(count));
  ImGui::SameLine();
  // One mark a step: full where it is finished.
  const float right = ImGui::GetContentRegionMax().x - width, radius = 0.22f * ImGui::GetFontSize();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetWindowPos().x + right - at.x - ImGui::GetStyle().ItemSpacing.x;
  const float pitch = std::min(3.2f * radius, room / float(count));
  for (std::size_t i = 0; i < count && pitch > 2.2f * radius; ++i) {
    const ImVec2 middle(at.x + (float(i) + 0.5f) * pitch, at.y + 0.5f * ImGui::GetFrameHeight());
    const Color tone = i == index ? color(accent_color(c.ui.theme)) : ImGui::GetColorU32(ImGuiCol_TextDisabled);
    if (c.run().finished(i))
      ImGui::GetWindowDrawList()->AddCircleFilled(middle, radius, tone);
    else
      ImGui::GetWindowDrawList()->AddCircle(middle, radius, tone, 0, i == index ? 2.0f : 1.0f);
  }
  ImGui::SetCursorPosX(right);
  go("Next ▶", "lesson.next", index + 1 < count, index + 1);
}

void LessonPanel::controls(Context& c) {
  part_heading("Try it");
  const Step& now = c.run().step();
  for (const std::string& path : now.controls) {
    if (path == kThetaControl) {
      if (c.experiment.light.type == LightType::directional) theta_slider(c.ui, light_, c.experiment);
    } else if (const Field* field = find_field(path)) {
      field_row(c.ui, *field, c.experiment);
    }
  }
  if (now.animation) animation_button(c);
}

void LessonPanel::animation_button(Context& c) {
  if (c.button(play_ ? "■ Stop" : "▶ Play", "lesson.play")) {
    if (play_) return play_.reset();
    play_ = LessonPlay{ImGui::GetTime(), NAN, std::nullopt};
  }
  rest_tooltip("Plays " + c.run().step().animation->path + ".");
}

namespace {

/// The animated number, read and set.
double animated(const Animation& animation, const Experiment& e) {
  if (animation.path == kThetaControl) return glm::degrees(light_theta(e));
  Experiment copy = e;
  return std::get<NumberRef>(find_field(animation.path)->member)(copy);
}
void set_animated(const Animation& animation, double value, const glm::dvec3& side, Experiment& e) {
  if (animation.path == kThetaControl)
    e.light.to_light = to_light_at(e, glm::radians(value), side);
  else
    std::get<NumberRef>(find_field(animation.path)->member)(e) = value;
}

}  // namespace

bool LessonPanel::play(const LessonSession& session, double now, Experiment& e) {
  if (!play_ || !session.run() || !session.run()->step().animation) return play_.reset(), false;
  const Animation& animation = *session.run()->step().animation;
  if (!play_->theta_side) play_->theta_side = theta_side(e);
  const bool taken_over =
      !std::isnan(play_->last) && std::abs(animated(animation, e) - play_->last) > 1e-6 * (1.0 + std::abs(play_->last));
  if (taken_over) return play_.reset(), false;
  const double time = now - play_->start;
  set_animated(animation, animation.at(time), *play_->theta_side, e);
  play_->last = animated(animation, e);
  if (time >= animation.seconds) play_.reset();
  return true;
}

}  // namespace psm
