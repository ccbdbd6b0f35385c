// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history.h"

namespace psm {
namespace {

constexpr double join_seconds = 1.0;

std::optional<Experiment> step(std::vector<Experiment>& from, std::vector<Experiment>& to, const Experiment& current) {
  if (from.empty()) return std::nullopt;
  Experiment next = from.back();
  from.pop_back();
  to.push_back(current);
  return next;
}

}  // namespace

void History::record(const Experiment& before, const std::string& tag, double now) {
  const bool joins = !tag.empty() && tag == last_tag_ && now - last_time_ < join_seconds && !past_.empty();
  if (!open_ && !joins) {
    past_.push_back(before);
    if (past_.size() > limit_) past_.erase(past_.begin());
  }
  future_.clear();
  open_ = true;
  last_tag_ = tag;
  last_time_ = now;
}

void History::end_gesture(const Experiment& current) {
  if (open_ && !past_.empty() && past_.back() == current) past_.pop_back();
  open_ = false;
}

std::optional<Experiment> History::undo(const Experiment& current) {
  end_gesture(current);
  last_tag_.clear();
  return step(past_, future_, current);
}

std::optional<Experiment> History::redo(const Experiment& current) {
  end_gesture(current);
  last_tag_.clear();
  return step(future_, past_, current);
}

}  // namespace psm
