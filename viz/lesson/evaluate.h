// SPDX-License-Identifier: GPL-3.0-or-later
// What quantities and conditions of a lesson come to, for an experiment.
#pragma once

#include <functional>

#include "lesson/json_tree.h"
#include "lesson/lesson.h"
#include "scene/analysis.h"
#include "scene/experiment_file.h"

namespace psm {

/// Analyses as `psmlab analyze` does; with the statistics of texels where they are asked for.
using Analyze = std::function<Analysis(const LoadedExperiment&, bool texels)>;

/// An experiment and its analysis, as the tree that paths lead into.
struct LessonState {
  const LoadedExperiment* loaded = nullptr;
  JsonTree analysis;
};

LessonState state_of(const LoadedExperiment& loaded, const Analysis& analysis);

/// The experiment with these members over it; a scene of another name brings its own camera and light.
Result<LoadedExperiment> with_members(const LoadedExperiment& loaded, const ExperimentMembers& members, const std::string& place);

/// The error says that the path leads to no value. A curve that does not exist is null; an array is its JSON text.
Result<Scalar> evaluate(const Quantity& quantity, const LessonState& state, const Analyze& analyze);

/// Numbers are the same within a part in 1e9; what is null is neither above nor below anything.
Result<bool> holds(const Condition& condition, const LessonState& state, const Analyze& analyze);

/// "0.53 is not above 0.6", for a condition that does not hold.
std::string why_not(const Condition& condition, const LessonState& state, const Analyze& analyze);

/// The value at the path, 4 significant digits, yes or no, a vector in brackets; "-" where it is null or the path leads nowhere.
std::string live_text(const JsonTree& analysis, const std::string& path);

/// Whether an experiment's own analysis lacks what this path leads to: statistics of texels must be asked for.
bool needs_texels(const std::string& path);

}  // namespace psm
