// SPDX-License-Identifier: GPL-3.0-or-later
// The window's contents: the lesson, one to four views, the control pane, the badges. The real window and the tests run the same
// frame().
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gl/renderer.h"
#include "scene/light_quiz.h"
#include "ui/comparison.h"
#include "ui/control_pane.h"
#include "ui/depth_readback.h"
#include "ui/dialogs.h"
#include "ui/input_queue.h"
#include "ui/lesson_panel.h"
#include "ui/model.h"
#include "ui/movements.h"
#include "ui/probe_hover.h"
#include "ui/profile_panel.h"
#include "ui/settings.h"
#include "ui/shown_views.h"
#include "ui/theme.h"
#include "ui/view_images.h"
#include "ui/view_tile.h"

namespace psm {

struct WorkbenchOptions {
  std::filesystem::path assets, font;
  std::filesystem::path settings;        // empty: neither read nor written
  std::filesystem::path pictures = ".";  // folder of saved pictures
  std::filesystem::path lessons;         // the shipped ones' folder
  bool start_card = false;               // the first run says where to begin: nothing was asked for
  std::string lesson;                    // to begin with: a name or a folder, "/3" behind it for its third step; empty: none
  std::function<std::optional<InputError>(const std::filesystem::path&, const Image&)> write_picture;
  /// The ending says what is written.
  std::function<Result<std::unique_ptr<ViewsWriter>>(const std::filesystem::path&, const ShownViews&)> write_views;
};

/// How much larger everything is in front of a class, in a window of this size: capitals of a 48th of its height, so that the
/// last row reads them. `scale`: without a class.
double presenting_scale(glm::ivec2 window, double scale);

/// Needs a current OpenGL context and a current ImGui context.
class Workbench {
 public:
  Workbench(LoadedExperiment loaded, WorkbenchOptions options);
  ~Workbench();

  /// Between ImGui::NewFrame and ImGui::Render, `size` in pixels. Events → widgets edit a copy of the experiment → if it differs,
  /// analyze → draw, all in this frame. `presses`: the keys that went down. `display_scale`: pixels per pixel of a plain display.
  void frame(glm::ivec2 size, double display_scale, const std::vector<KeyPress>& presses);

  /// Fonts and style that the next frame needs, in a window of this size.
  LookKey look(glm::ivec2 size, double display_scale) const;

  /// In front of a class: large type, no controls. The window that shows it fills the screen meanwhile.
  void present(bool on);
  bool presenting() const { return presenting_; }

  /// Something happened: the next three frames are drawn (ImGui settles late).
  void wake() { frames_left_ = 3; }
  bool needs_redraw() const { return frames_left_ > 0; }
  /// Seconds until something may be due; infinite if nothing will be.
  double next_look() const { return next_look_; }
  /// They have passed without an event: wakes for a tooltip, or for a lesson whose files changed. Costs next to nothing else.
  void look() {
    if (tooltip_waits_ || lessons_.files_changed()) wake();
  }

  /// A file dropped on the window, or a source chosen elsewhere: as Model::open, errors in a pop-up.
  void open(const std::string& source);
  void act(Action action);

  /// Events have to wait for the next frame.
  bool holds_input() const { return dialogs_.settling(); }
  bool wants_quit() const { return wants_quit_; }
  /// The window is to be closed: unsaved changes are asked about first.
  void ask_to_quit();
  /// What is lost where nobody can be asked, as a line to paste; none where all is saved.
  std::optional<std::string> unsaved_text() const;

  /// The window's picture is wanted for a PNG: whoever composed the frame hands it over.
  bool wants_screen() const { return wants_screen_; }
  void take_screen(const Image& image);

  const Model& model() const { return model_; }
  const Settings& settings() const { return settings_; }
  void set_settings(const Settings& settings) { settings_ = clamped(settings), wake(); }
  const std::filesystem::path& font() const { return options_.font; }
  const Places& places() const { return places_; }
  Renderer& renderer() { return renderer_; }
  std::optional<HandleKind> selected_handle() const { return drag_.selected; }
  const ViewImages& images() const { return images_; }
  const Comparison& comparison() const { return comparison_; }
  const std::optional<Probe>& probe() const { return probe_; }
  const std::optional<LightQuiz>& quiz() const { return quiz_; }
  const Profile& profile() const { return profile_; }
  const LessonSession& lessons() const { return lessons_; }
  Dialogs::Kind dialog() const { return dialogs_.shown(); }
  const std::string& message() const { return message_; }
  std::string window_title() const;
  std::filesystem::path last_picture() const { return last_picture_; }
  std::uint64_t frames() const { return frames_; }            // drawn so far
  std::uint64_t views_drawn() const { return views_drawn_; }  // pictures of views, so far

 private:
  const Experiment& own_experiment() const;
  struct Frame;  // what one frame passes around
  void take_keys(const std::vector<KeyPress>& presses);
  bool take_presenting_key(const KeyPress& press);
  void step_screen(int step);
  void draw_black(glm::ivec2 size) const;
  void splitters(Frame& f);
  void tiles(Frame& f);
  void tile_controls(Frame& f);
  void quiz(Frame& f);
  void pane_fields(Frame& f);
  void paste();
  void show_opened(const std::string& message);
  void lesson_pane(Frame& f);
  bool stages_lesson() const;
  LayoutSettings shown_layout(UiContext& ui, glm::ivec2 size);
  int bar_height(glm::ivec2 size) const;
  void bar(Frame& f);
  void lesson_line(Frame& f);
  bool step_stage(int by);
  void show_answer();
  void perform(const std::vector<LessonCommand>& commands);
  void perform(const LessonCommand& command);
  void show_lesson_experiment(const std::optional<Experiment>& experiment);
  void toggle_lesson_pane();
  bool step_lesson(int by);
  void lesson_way_back();
  bool key_is_free(const KeyPress& press);
  bool is_covered(ViewId id) const;
  void cover_tiles(Frame& f);
  void reveal(const Experiment& to);
  void keep_light_in_place(Experiment& edited) const;
  void pane_header(Frame& f);
  void pane_numbers(Frame& f);
  void badge_line(Frame& f);
  void dialogs(Frame& f);
  void ask_for_path_to_save();
  void save(const std::string& file);
  void commit(Frame& f);
  void draw_views(Frame& f);
  bool shows_texels() const;
  void count_texels();
  int update_comparison(const Frame& f, const ViewSettings& shown, bool resting);
  void end_frame(Frame& f);
  void report_model();
  std::filesystem::path free_picture_name(const std::string& ending) const;
  void ask_for_picture();
  ShownViews shown_views(const Frame& f);
  void save_views(const Frame& f, const std::string& file);
  void write_on();
  void give_up_writing();
  void save_screen();
  void write_screen(const Image& image);
  void picture_saved(const std::filesystem::path& file);
  void change_technique(int step);
  void change_eye_overlay();
  void toggle_texel_grid();
  void toggle_quiz();
  void move_split(double by);
  void next_pane();
  bool shows_start_card() const;
  bool take_start_key(const KeyPress& press);
  void start_card(Frame& f);
  void copy_curves();
  void pin_probe();
  void toggle_comparison();
  void change_compare_layout();
  void find_probe();
  void select_handle(int step);
  void move_selected_handle(const Rect& world, double scale, Experiment& edited, std::string& tag);
  void maximise(std::optional<ViewId> view);
  void fit_views();
  void commit_now(const Experiment& edited);

  WorkbenchOptions options_;
  Settings settings_, saved_settings_;
  Model model_;
  Renderer renderer_;
  ViewImages images_;
  Comparison comparison_;
  ComparedParts parts_;  // as last drawn
  std::vector<std::filesystem::path> experiments_;
  Profile profile_;
  ProfilePanel profile_panel_;
  DepthReadback readback_;
  std::uint64_t reported_analysis_ = 0, reported_points_ = 0;
  std::optional<bool> show_profile_;  // in the next frame
  FittedOrbits fitted_;
  ViewDrag drag_;
  bool world_shown_ = true;           // in the last frame
  std::optional<PointedAt> pointed_;  // where the mouse is, unless it is busy
  std::optional<Probe> probe_;        // there, or where the experiment has one
  std::optional<LightQuiz> quiz_;     // open beside the explorer's map
  LightControls light_;
  LessonSession lessons_;
  LessonPanel lesson_panel_;
  std::vector<LessonCommand> lesson_commands_;  // for the next frame
  bool pane_before_lesson_ = true;
  Movements movements_{model_};
  Dialogs dialogs_;
  Requests requests_;
  Places places_;
  KeyboardPane keyboard_;
  std::string message_;
  History own_history_;     // the student's, while a lesson is open
  std::string typed_path_;  // in the Open dialog, until it has been opened
  std::filesystem::path last_picture_;
  std::string picture_ending_ = ".png";  // of the last name that was asked for
  std::unique_ptr<ViewsWriter> writer_;  // at work, into this file
  std::string written_file_;
  int frames_left_ = 3;
  double next_look_ = std::numeric_limits<double>::infinity();
  bool tooltip_waits_ = false;
  double views_ms_ = 0.0;
  std::uint64_t frames_ = 0, views_drawn_ = 0;
  bool presenting_ = false, black_ = false;
  bool wants_screen_ = false, wants_quit_ = false, quits_after_save_ = false, show_notes_ = false;
};

}  // namespace psm
