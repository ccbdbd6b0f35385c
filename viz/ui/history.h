// SPDX-License-Identifier: GPL-3.0-or-later
// Undo and redo: a bounded list of Experiment values, one for each gesture.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scene/experiment.h"

namespace psm {

class History {
 public:
  explicit History(std::size_t limit = 200) : limit_(limit) {}

  /// A change is about to replace `before`. All changes until end_gesture() are one entry. `tag` names changes that come in steps
  /// (wheel clicks): equal tags within a second of each other join one entry. `now` in seconds.
  void record(const Experiment& before, const std::string& tag, double now);

  /// The button was released or the widget let go. Drops the entry if the gesture came back to where it began.
  void end_gesture(const Experiment& current);

  /// The experiment to go to; nothing at the end of the list.
  std::optional<Experiment> undo(const Experiment& current);
  std::optional<Experiment> redo(const Experiment& current);

  std::size_t undo_count() const { return past_.size(); }

 private:
  std::vector<Experiment> past_, future_;
  std::size_t limit_;
  bool open_ = false;
  std::string last_tag_;
  double last_time_ = 0.0;
};

}  // namespace psm
