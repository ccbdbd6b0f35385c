// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson_panel.h"

#include <algorithm>
#include <cmath>

#include "ui/lesson_context.h"

namespace psm {
namespace {

using Kind = LessonCommand::Kind;

/// Nothing leaves a page's width but what no line could hold: then this is where it ends.
double ink_width(const TextPage& page, const FontMetrics& metrics) {
  double width = 0.0;
  for (const GlyphRun& run : page.ink.runs) width = std::max(width, run.baseline.x + metrics.width(run.text, run.type));
  for (const Rule& rule : page.ink.rules) width = std::max(width, rule.max.x);
  return width;
}

}  // namespace

Prose heading_prose(const std::string& text, int level) {
  auto blocks = parse_markdown(std::string(std::size_t(level), '#') + " " + text);
  return blocks ? std::move(*blocks) : Prose{};
}

const LessonPanel::CachedPage& LessonPanel::page(const Context& c, const std::string& name, const Prose& prose, double width) {
  CachedPage& cached = pages_[name];
  if (cached.revision == c.session.revision() && cached.width == width && cached.size == c.style.size) return cached;
  const auto live = [&](const std::string& path) { return live_text(c.session.values(), path); };
  const FontMetrics metrics = screen_metrics();
  cached = {c.session.revision(), width, c.style.size, typeset(prose, {width, c.style.size, c.style.leading}, metrics, live)};
  cached.too_wide = ink_width(cached.page, metrics) > width + 1.0;
  return cached;
}

void LessonPanel::prose(Context& c, const std::string& name, const Prose& prose) {
  follow(c, show_page(c.ui, page(c, name, prose, c.style.width).page, name));
}

LessonPanel::Part LessonPanel::prose_part(const Context& c, const std::string& name, const Prose& text) {
  const CachedPage& set = page(c, name, text, c.style.width);
  return {std::ceil(set.page.height), [=, this](Context& now) { prose(now, name, text); }, false, set.too_wide};
}

void LessonPanel::follow(Context& c, const std::string& link) {
  if (link.starts_with("lesson:")) c.ask(Kind::follow, 0, link.substr(7));
  if (link.starts_with("set:")) c.ask(Kind::set, 0, link);
  if (link.starts_with("https:")) ImGui::SetClipboardText(link.c_str());
}

std::vector<LessonCommand> LessonPanel::draw(UiContext& ui, const LessonSession& session, const Rect& pane,
                                             Experiment& experiment) {
  Context c{ui, session, pane, experiment, {0.0, ImGui::GetFontSize(), 1.4}};
  open_question_.reset(), open_task_.reset();  // no key answers here
  const float padding = ImGui::GetStyle().WindowPadding.x, row = ImGui::GetFrameHeightWithSpacing();
  const auto child = [&](const char* name, int top, int bottom, ImGuiWindowFlags flags) {
    ImGui::SetCursorScreenPos({float(pane.min.x), float(top)});
    ImGui::BeginChild(name, {float(std::max(1, pane.size().x)), float(std::max(1, bottom - top))}, false,
                      ImGuiWindowFlags_AlwaysUseWindowPadding | flags);
  };
  constexpr ImGuiWindowFlags still = ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
  const bool listed = lists_ || !session.run(), leads_back = !listed && session.way_back() && session.way_back()->linked;
  const int top = pane.min.y + int(std::ceil((leads_back ? 2.0f : 1.0f) * row + padding)),
            bottom = pane.max.y - (listed ? 0 : int(std::ceil(row + 1.5f * padding)));
  ui.places["lesson.pane"] = pane;
  child("lesson title", pane.min.y, top, still);
  take_keyboard(ui, "lesson title");
  title_bar(c);
  ImGui::EndChild();
  child("lesson", top, bottom, 0);
  take_keyboard(ui, "lesson");
  ui.places["lesson.text"] = {{pane.min.x, top}, {pane.max.x, bottom}};
  c.style.width = std::floor(ImGui::GetContentRegionAvail().x);
  if (!session.error().empty()) toned_words(warning_color(ui.theme), "▲ " + session.error());
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
  ImGui::TextDisabled("%s", numbered_title(c.run().lesson().name, c.run().lesson().title).c_str());
  const LessonPlace* place = c.session.way_back();
  if (!place || !place->linked) return;
  if (c.button(("◀ Back to " + place->title).c_str(), "lesson.way_back")) c.ask(Kind::back);
  rest_tooltip("To the step where you followed the link (Backspace).");
}

void LessonPanel::list(Context& c) {
  const float width = ImGui::GetContentRegionAvail().x, padding = ImGui::GetStyle().FramePadding.x;
  if (c.session.shipped().empty()) ImGui::TextDisabled("There are no lessons beside this program.");
  for (const LessonEntry& entry : c.session.shipped()) {
    Prose prose = heading_prose(numbered_title(entry.name, entry.title), 3);
    prose.push_back({0, 0, "", false, {{Inline::Kind::words, entry.summary, false, false, "", 0}}, 0});
    const TextPage& text = page(c, "list." + entry.name, prose, std::floor(width - 2 * padding)).page;
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
      const std::size_t finished = p.finished(), steps = p.steps.size();
      ImGui::TextDisabled("%s %d of %d steps finished", finished == steps ? "●" : "○", int(finished), int(steps));
    }
    ImGui::SetCursorScreenPos(below);
    if (chosen) lists_ = false, c.ask(Kind::open, 0, entry.name);
  }
}

void LessonPanel::step(Context& c) {
  const std::string before = shown_step_;
  const Parts parts = step_parts(c);
  if (before != shown_step_) ImGui::SetScrollY(0.0f);
  for (const Part& part : parts)
    if (part.draw) part.draw(c);
  part_heading("Start again");
  if (c.button("Reset step", "lesson.reset_step")) c.ask(Kind::reset_step), typed_.clear();
  rest_tooltip("This step's experiment, answers and tasks as they were at first.");
  ImGui::SameLine();
  if (c.button("Reset lesson", "lesson.reset_lesson")) c.ask(Kind::reset_lesson), typed_.clear();
  rest_tooltip("All steps as if you had never seen them.");
  ImGui::Dummy({0, ImGui::GetFontSize()});
}

void LessonPanel::navigation(Context& c) {
  const std::size_t index = c.run().index(), count = c.run().lesson().steps.size();
  const bool ends = index + 1 == count && c.session.has_next_lesson();
  const float narrow = 5.0f * ImGui::GetFontSize(), width = (ends ? 1.6f : 1.0f) * narrow;
  const auto go = [&](const char* label, const char* place, float wide, bool possible, Kind kind, std::size_t to) {
    ImGui::BeginDisabled(!possible);
    if (ImGui::Button(label, {wide, 0})) c.ask(kind, to);
    ImGui::EndDisabled();
    note_place(c.ui, place);
  };
  go("◀ Back", "lesson.back", narrow, index > 0 || c.session.way_back(), index > 0 ? Kind::go_to : Kind::back, index - 1);
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
  go(ends ? "Next lesson ▶" : "Next ▶", "lesson.next", width, ends || index + 1 < count, ends ? Kind::next_lesson : Kind::go_to,
     index + 1);
}

}  // namespace psm
