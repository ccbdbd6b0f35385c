// SPDX-License-Identifier: GPL-3.0-or-later
// The lesson that is open in the window: what was asked for becomes experiments to show. No widgets.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "draw/draw_list.h"
#include "lesson/lesson_run.h"
#include "lesson/progress_file.h"
#include "ui/model.h"

namespace psm {

/// What a widget, a key or the command line asks of the lesson.
struct LessonCommand {
  enum class Kind {
    open,          // text: a shipped lesson's name or a folder, as somebody left it; "/3" behind it: at its third step
    follow,        // text: the same, of a link: without "/3" at its first step
    back,          // to where one followed a link, or came from the lesson before
    next_lesson,   // of the shipped ones, at its first step
    close,         // the student's own experiment comes back
    go_to,         // index: of a step
    reset_step,    // its experiment, answers and tasks
    reset_lesson,  // all steps
    set,           // text: a "set:" link
    choose,        // index: of a question, choice
    answer,        // index: of a question, number
    show_answer,   // index: of a question
    hint,          // index: of a task
    solve          // index: of a task
  };
  Kind kind = Kind::open;
  std::size_t index = 0;
  std::string text;
  int choice = 0;
  double number = 0.0;
};

struct LessonEntry {
  std::filesystem::path folder;
  std::string name, title, summary;
};

/// A step of a lesson that somebody has left for another lesson.
struct LessonPlace {
  std::filesystem::path folder;
  std::size_t step = 0;
  std::string title;
  bool linked = false;  // by a link; else at its end, for the next lesson
};

class LessonSession {
 public:
  /// `lessons`: the shipped ones' folder. `progress`: the file of what is finished; empty: none is kept.
  LessonSession(std::filesystem::path lessons, std::filesystem::path progress);

  /// Returns the experiment to show next, if it is another one.
  std::optional<Experiment> perform(const LessonCommand& command, const Model& model);
  /// Once a frame: tasks are checked on what is new, once it is no longer `moving`, since passing through is no answer; files
  /// that changed are read again, looked at once a second.
  std::optional<Experiment> update(const Model& model, double now, bool moving = false);

  const std::vector<LessonEntry>& shipped() const { return shipped_; }
  const ProgressByLesson& progress() const { return progress_; }
  const LessonRun* run() const { return open_ ? &open_->run : nullptr; }
  /// The student's own experiment, from before the lesson.
  const Experiment& own() const { return own_; }
  /// Where `back` leads, if anywhere, and whether a shipped lesson follows the open one.
  const LessonPlace* way_back() const { return way_back_.empty() ? nullptr : &way_back_.back(); }
  bool has_next_lesson() const { return next_lesson() != nullptr; }
  /// The analysis at hand as live values see it.
  const JsonTree& values() const { return values_.analysis; }
  /// Grows whenever something that texts show has changed.
  std::uint64_t revision() const { return revision_; }
  /// What went wrong last: a file and its line; empty: nothing. The last good version stays open.
  const std::string& error() const { return error_; }
  std::vector<ViewId> covered() const { return open_ ? open_->run.covered() : std::vector<ViewId>(); }
  Emphasis emphasis() const { return open_ ? open_->run.step().emphasis : Emphasis(); }
  /// The step speaks of texels over all pixels, or asks for them.
  bool needs_texels() const;
  /// Whether files changed since they were read, so that `update` has something to do.
  bool files_changed() const;
  /// Seconds after which to ask that again; infinite without a lesson.
  double seconds_to_look() const;

 private:
  /// A lesson that has been opened stays, so that it comes back as it was left.
  struct Opened {
    LessonRun run;
    std::vector<std::filesystem::file_time_type> written;  // of its two files, when they were read
  };
  std::optional<Experiment> change_lesson(const LessonCommand& command, const Model& model);
  std::optional<Experiment> open(const std::filesystem::path& folder, std::optional<std::size_t> step, const Model& model);
  std::optional<Experiment> close(const Model& model);
  std::filesystem::path folder_of(const std::string& name) const;
  const LessonEntry* next_lesson() const;
  std::optional<Experiment> answer(const LessonCommand& command, const Model& model);
  std::optional<Experiment> over(const ExperimentMembers& members, const Model& model, const std::string& place);
  std::optional<Experiment> shown(Result<Experiment> experiment);
  std::optional<Experiment> read_again(const Model& model);
  void keep_progress();

  std::filesystem::path lessons_, progress_file_;
  std::vector<LessonEntry> shipped_;
  ProgressByLesson progress_;
  std::map<std::filesystem::path, Opened> opened_;  // by folder
  Opened* open_ = nullptr;
  Experiment own_;
  std::vector<LessonPlace> way_back_;
  LessonState values_;
  std::uint64_t revision_ = 1, analysis_ = 0;  // analysis_: as Model counts them with their texels
  ViewSettings view_;
  bool unchecked_ = false;
  std::string error_;
  double looked_ = 0.0;
};

/// A step's views as the experiment's tiles.
void show_views(const std::vector<ViewId>& views, ViewSettings& settings);

}  // namespace psm
