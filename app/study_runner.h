// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the runs of a study: truth by rays, the map and its verdicts by OpenGL, the time of each stage.
#pragma once

#include <memory>
#include <string>

#include "measure/study.h"
#include "measure/study_row.h"

namespace psm {

class StudyRunner {
 public:
  /// An error where there is no OpenGL. `study` outlives it.
  static Result<std::unique_ptr<StudyRunner>> create(const Study& study);
  ~StudyRunner();

  /// Runs that share scene and light one after another share their truth.
  StudyRow measure(std::size_t run);

 private:
  struct State;
  explicit StudyRunner(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace psm
