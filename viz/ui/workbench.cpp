// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "draw/texel_overlay.h"
#include "scene/light_angles.h"
#include "ui/badge_bar.h"
#include "ui/cube_tools.h"
#include "ui/curves_tile.h"
#include "ui/explorer_tile.h"
#include "ui/eye_tools.h"
#include "ui/field_widgets.h"
#include "ui/numbers_pane.h"
#include "ui/quiz_panel.h"
#include "ui/tile_menu.h"
#include "ui/workbench_frame.h"

namespace psm {
namespace {

ImVec2 vec(glm::ivec2 v) { return {float(v.x), float(v.y)}; }

void begin_child(const char* name, const Rect& rect, ImGuiWindowFlags flags = 0) {
  ImGui::SetCursorScreenPos(vec(rect.min));
  ImGui::BeginChild(name, {float(std::max(1, rect.size().x)), float(std::max(1, rect.size().y))}, false,
                    ImGuiWindowFlags_AlwaysUseWindowPadding | flags);
}

/// The pane's two parts: selectors above, everything else scrolls.
Rect header_rect(const Rect& pane) {
  return {pane.min, {pane.max.x, std::min(pane.max.y, pane.min.y + int(std::ceil(control_header_height(float(pane.size().x)))))}};
}
Rect fields_rect(const Rect& pane) { return {{pane.min.x, header_rect(pane).max.y}, pane.max}; }

std::vector<std::filesystem::path> shipped_experiments(const std::filesystem::path& assets) {
  std::vector<std::filesystem::path> files;
  std::error_code none;  // an installation without them has none to offer
  for (const auto& entry : std::filesystem::directory_iterator(assets / "experiments", none)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

Workbench::Workbench(LoadedExperiment loaded, WorkbenchOptions options)
    : options_(std::move(options)),
      settings_(read_settings(options_.settings)),
      saved_settings_(settings_),
      model_(std::move(loaded)),
      renderer_(options_.assets, options_.font),
      images_(renderer_),
      comparison_(options_.assets, options_.font),
      experiments_(shipped_experiments(options_.assets)),
      lessons_(options_.lessons, options_.settings.empty() ? "" : options_.settings.parent_path() / "lessons.json") {
  if (options_.lesson.empty()) return;
  toggle_lesson_pane();
  lesson_commands_.push_back({LessonCommand::Kind::open, 0, options_.lesson, 0, 0.0});
}

Workbench::~Workbench() = default;

LookKey Workbench::look(glm::ivec2 size, double display_scale) const {
  double scale = std::clamp(display_scale, 0.25, 8.0) * settings_.scale_percent / 100.0;
  if (presenting_) scale = presenting_scale(size, scale);
  const double type = stages_lesson() ? largest_stage_type(size.y) : settings_.font_px * scale;
  return {std::max(6, int(std::lround(type))), scale, settings_.theme};
}

void Workbench::frame(glm::ivec2 size, double display_scale, const std::vector<KeyPress>& presses) {
  ++frames_;
  profile_.begin_frame();
  frames_left_ = std::max(0, frames_left_ - 1);
  if (!presses.empty()) wake();
  const Requests asked = std::exchange(requests_, {});
  if (asked.open) open(*asked.open);
  if (asked.action) act(*asked.action);
  take_keys(presses);
  perform(std::exchange(lesson_commands_, {}));
  // What is on its way to a solution does not count as one, nor as a result.
  const bool moving = ImGui::IsAnyMouseDown() || ImGui::IsAnyItemActive() || lesson_panel_.playing();
  if (!movements_.reveals()) show_lesson_experiment(lessons_.update(model_, ImGui::GetTime(), moving));
  model_.set_points_source(settings_.points_from);
  readback_.take(model_, renderer_, profile_);

  // The arrow keys are a clicker's while presenting, or move the selected handle.
  ImGuiConfigFlags& flags = ImGui::GetIO().ConfigFlags;
  flags =
      presenting_ || drag_.selected ? flags & ~ImGuiConfigFlags_NavEnableKeyboard : flags | ImGuiConfigFlags_NavEnableKeyboard;

  if (presenting_) ImGui::GetCurrentContext()->HoveredIdTimer = 0.0f;  // no tooltips in front of a class
  places_.clear();
  const double scale = look(size, display_scale).scale;
  const int splitter = std::max(2, int(std::lround(6.0 * scale)));
  UiContext ui{model_, settings_.theme, scale, places_, experiments_, &keyboard_};
  keyboard_.panes.clear();
  Layout layout = lay_out(size, shown_layout(ui, size), model_.experiment().view, bar_height(size), splitter);
  const auto second = place_second(layout, model_.experiment().view, splitter);
  Frame f{size, scale, ImGui::GetTime(), layout, second, ui, model_.experiment(), "", false};

  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(vec(size));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
  ImGui::Begin("workbench", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar(3);
  if (movements_.any()) wake();
  f.tag = movements_.move(f.edited, f.now);
  if (!presenting_) splitters(f);
  move_selected_handle(f.layout.view(ViewId::world), f.scale, f.edited, f.tag);
  tiles(f);
  lesson_pane(f);
  pane_fields(f);
  commit(f);
  pane_header(f);
  commit(f);
  draw_views(f);
  pane_numbers(f);
  bar(f);
  ImGui::End();
  start_card(f);
  dialogs(f);
  draw_black(size);
  end_frame(f);
}

void Workbench::splitters(Frame& f) {
  const auto bar = [&](const char* name, const Rect& rect, Splitter which, ImGuiMouseCursor cursor) {
    if (rect.empty()) return;
    ImGui::SetCursorScreenPos(vec(rect.min));
    ImGui::InvisibleButton(name, vec(rect.size()));
    note_place(f.ui, std::string("splitter.") + name);
    const bool active = ImGui::IsItemActive(), hot = active || ImGui::IsItemHovered();
    if (hot) ImGui::SetMouseCursor(cursor);
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) {
      settings_.layout = reset_splitter(which, settings_.layout);
    } else if (active && (ImGui::GetIO().MouseDelta.x != 0.0f || ImGui::GetIO().MouseDelta.y != 0.0f)) {
      const glm::dvec2 mouse(ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y);
      settings_.layout = move_splitter(which, mouse, f.size, settings_.layout, f.layout.badges.size().y);
    }
    const Color tone = hot ? color(accent_color(settings_.theme)) : color(ground_color(settings_.theme));
    ImGui::GetWindowDrawList()->AddRectFilled(vec(rect.min), vec(rect.max), tone);
  };
  bar("lesson", f.layout.lesson_splitter, Splitter::lesson, ImGuiMouseCursor_ResizeEW);
  bar("pane", f.layout.pane_splitter, Splitter::pane, ImGuiMouseCursor_ResizeEW);
  bar("column", f.layout.column_splitter, Splitter::column, ImGuiMouseCursor_ResizeEW);
  bar("row", f.layout.row_splitter, Splitter::row, ImGuiMouseCursor_ResizeNS);
}

void Workbench::tiles(Frame& f) {
  pointed_.reset();
  if (const std::string tag = second_input(f.ui, f.second, comparison_.images(), drag_, f.edited); !tag.empty()) f.tag = tag;
  for (ViewId id : kAllViews) {
    const Rect rect = f.layout.view(id);
    const std::string tag = tile_input(f.ui, id, rect, images_, drag_, f.edited);
    if (!tag.empty()) f.tag = tag;
    if (rect.empty() || !ImGui::IsItemHovered() || ImGui::IsAnyMouseDown()) continue;
    pointed_ = PointedAt{id, glm::dvec2(ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y) - glm::dvec2(rect.min)};
  }
  if (!presenting_) tile_controls(f);
}

void Workbench::tile_controls(Frame& f) {
  const auto place = [&](ViewId id) { return is_covered(id) ? Rect{} : f.layout.view(id); };
  for (ViewId id : kAllViews) tile_menu(f.ui, id, place(id), images_.picture(id), f.edited.view);
  if (!place(ViewId::cube).empty()) cube_tools(f.ui, place(ViewId::cube), f.edited);
  if (!place(ViewId::eye).empty()) eye_tools(f.ui, place(ViewId::eye), f.edited);
  if (!place(ViewId::curves).empty() && curve_tools(f.ui, place(ViewId::curves), f.edited)) act(Action::copy_curves);
  if (place(ViewId::explorer).empty()) return;
  if (explorer_tools(f.ui, place(ViewId::explorer), f.edited)) act(Action::toggle_quiz);
  quiz(f);
}

void Workbench::quiz(Frame& f) {
  if (!quiz_) return;
  const QuizClicks clicks = quiz_panel(f.ui, quiz_place(f.layout.view(ViewId::explorer), f.scale), *quiz_);
  if (clicks.answer) quiz_->answer(*clicks.answer);
  if (clicks.reset_score) quiz_->reset_score();
  settings_.quiz = quiz_->score();
  if (clicks.answer || clicks.next) keyboard_.wanted = "quiz";
  if (clicks.show) {
    Experiment shown = model_.experiment();
    shown.light = quiz_->light();
    commit_now(shown);
    f.edited = model_.experiment();
  }
  if (clicks.next) quiz_->next(model_.experiment(), model_.scene());
  if (clicks.close) quiz_.reset();
}

void Workbench::find_probe() {
  probe_.reset();
  if (pointed_ && settings_.hovering) probe_ = probe_under(*pointed_, model_, images_);
  if (!probe_) probe_ = probe_at(model_.experiment().view.probe, model_.tracer(), model_.analysis());
}

void Workbench::pane_fields(Frame& f) {
  if (f.layout.pane.empty()) return;
  begin_child("fields", fields_rect(f.layout.pane));
  take_keyboard(f.ui, "fields");
  places_["pane.fields"] = fields_rect(f.layout.pane);
  control_fields(f.ui, light_, f.edited);
  keep_light_in_place(f.edited);
  ImGui::EndChild();
}

// Each type has members of its own: without this a change of type would bring up a light that was left somewhere long ago.
void Workbench::keep_light_in_place(Experiment& edited) const {
  const LightSettings& before = model_.experiment().light;
  if (edited.light.type == before.type) return;
  const ConvexBody& seen = model_.analysis().receivers_body;
  const glm::dvec3 middle = seen.empty() ? edited.camera.target : seen.centroid();
  edited.light = with_type(before, edited.light.type, middle, scene_size(model_.scene()));
}

void Workbench::pane_header(Frame& f) {
  if (f.layout.pane.empty()) return;
  begin_child("header", header_rect(f.layout.pane), ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  take_keyboard(f.ui, "header");
  control_header(f.ui, f.edited, requests_);
  ImGui::EndChild();
}

// Goes on where pane_fields ended: the numbers are those of the analysis that the fields have just led to.
void Workbench::pane_numbers(Frame& f) {
  profile_.watch(false);
  if (f.layout.pane.empty()) return;
  begin_child("fields", fields_rect(f.layout.pane));
  numbers_pane(f.ui, comparison_.analysis(), probe_, settings_, requests_, std::exchange(show_notes_, false));
  profile_panel_.draw(f.ui, profile_, readback_, std::exchange(show_profile_, std::nullopt));
  ImGui::EndChild();
}

void Workbench::bar(Frame& f) {
  begin_child("badges", f.layout.badges, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  stages_lesson() ? lesson_line(f) : badge_line(f);
  ImGui::EndChild();
}

void Workbench::badge_line(Frame& f) {
  std::vector<Badge> shown = badges(model_, views_ms_, message_, settings_.theme);
  if (presenting_) shown.resize(1);  // the light case
  const std::string clicked = badge_bar(f.ui, shown, f.layout.badges);
  if (clicked != "badge.notes" && clicked != "badge.worse") return;
  show_notes_ = settings_.layout.pane_shown = true;
  wake();
}

void Workbench::dialogs(Frame& f) {
  const Dialogs::Answer answer = dialogs_.draw(f.ui, settings_);
  if (answer.open) requests_.open = typed_path_ = *answer.open;
  if (answer.discard) wants_quit_ = true;
  if (answer.save_first) {
    ask_for_path_to_save();
    quits_after_save_ = true;
  }
  if (answer.save) save(*answer.save);
  if (writer_) dialogs_.shown() == Dialogs::Kind::progress ? write_on() : give_up_writing();
  if (answer.picture) save_views(f, *answer.picture);
  if (dialogs_.shown() == Dialogs::Kind::none) quits_after_save_ = false;
}

void Workbench::commit(Frame& f) {
  const bool changed = model_.commit(f.edited, f.tag, f.now);
  if (changed) message_.clear();
  f.changed |= changed;
  f.edited = model_.experiment();
}

void Workbench::draw_views(Frame& f) {
  const auto start = std::chrono::steady_clock::now();
  const auto sizes = f.view_sizes();
  const bool resting = !f.changed && !movements_.any() && !ImGui::IsAnyMouseDown() && !ImGui::IsAnyItemActive();
  if (resting && sizes[std::size_t(ViewId::eye)].x > 0) images_.trace_overlay(model_, profile_);
  if (resting && shows_texels()) count_texels();
  // A fit that a hidden view never had is found when the view shows.
  const ViewSettings shown = fitted_.shown(model_, sizes);
  // While the line moves, labels stay where they are.
  if (resting) images_.set_shown_parts(parts_.first);
  int drawn = images_.update(model_, shown, sizes, f.scale, settings_.theme, profile_);
  drawn += update_comparison(f, shown, resting);
  if (images_.has_scene_of(model_)) readback_.ask(model_, renderer_, profile_);
  report_model();
  views_drawn_ += std::uint64_t(drawn);
  if (drawn > 0) views_ms_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  for (ViewId id : kAllViews)
    if (sizes[std::size_t(id)].x > 0) draw_tile(f.ui, id, f.layout.view(id), images_, drag_);
  const ComparedParts parts = draw_seconds(f.ui, f.layout, f.second, images_, comparison_.images(), drag_);
  if (std::exchange(parts_, parts) != parts) wake();
  find_probe();
  for (ViewId id : kAllViews) {
    if (!probe_ || sizes[std::size_t(id)].x == 0) continue;
    const Rect first = first_part(id, f.layout.view(id), model_.experiment().view);
    ImGui::PushClipRect(vec(first.min), vec(first.max), true);
    draw_probe(f.ui, *probe_, id, f.layout.view(id), images_);
    ImGui::PopClipRect();
  }
  cover_tiles(f);
}

/// Somebody reads the sizes of texels, and not only as one number among many.
bool Workbench::shows_texels() const {
  return heat_scale(model_.experiment().view.eye_overlay) || (settings_.layout.lesson_shown && lessons_.needs_texels());
}

/// While something moves, the coarse grid's answer has to do.
void Workbench::count_texels() {
  if (model_.texels_counted()) return;
  profile_.run(Stage::texels, [&] { model_.count_texels(); });
  wake();
}

int Workbench::update_comparison(const Frame& f, const ViewSettings& shown, bool resting) {
  const auto start = std::chrono::steady_clock::now();
  const int drawn =
      comparison_.update(model_, shown, f.second, f.scale, settings_.theme, images_.emphasis(), parts_.second, resting);
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  if (drawn > 0)
    profile_.ran(Stage::compare, time.count());
  else if (!shown.compare)
    profile_.skipped(Stage::compare, "nothing is compared");
  return drawn;
}

void Workbench::report_model() {
  if (std::exchange(reported_analysis_, model_.analysis_revision()) != model_.analysis_revision())
    profile_.ran(Stage::analysis, model_.analysis_ms());
  const bool new_points = std::exchange(reported_points_, model_.points_revision()) != model_.points_revision();
  if (model_.points_source() != PointsSource::rays) return;  // the readback reports its own
  if (new_points)
    profile_.ran(Stage::points, model_.points_ms());
  else
    profile_.skipped(Stage::points, "unchanged: same eye, same scene");
}

void Workbench::end_frame(Frame& f) {
  if (!ImGui::IsAnyItemActive() && !ImGui::IsAnyMouseDown()) model_.end_gesture();
  if (f.changed || requests_.open || requests_.action || dialogs_.settling()) wake();
  if (readback_.waiting() || profile_.waiting()) wake();
  if (!lesson_commands_.empty()) wake();
  next_look_ = lessons_.seconds_to_look();
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  tooltip_waits_ = !presenting_ && g.HoveredId != 0 && g.ActiveId == 0 && g.HoveredIdTimer < double(kTooltipDelay);
  if (tooltip_waits_) next_look_ = std::min(next_look_, double(kTooltipDelay) - g.HoveredIdTimer + 0.01);
  profile_.end_frame();
  settings_ = clamped(settings_);
  if (settings_ == saved_settings_ || ImGui::IsAnyMouseDown()) return;
  write_settings(settings_, options_.settings);
  saved_settings_ = settings_;
  wake();
}

}  // namespace psm
