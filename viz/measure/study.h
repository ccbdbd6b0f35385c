// SPDX-License-Identifier: GPL-3.0-or-later
// What a speed-against-error study measures: scenes x angles x resolutions x techniques, as a plain list of runs.
#pragma once

#include <string>
#include <vector>

#include "measure/equal_error.h"
#include "measure/repeats.h"
#include "measure/study_row.h"
#include "scene/experiment_file.h"

namespace psm {

struct StudyScene {
  std::string name;  // in rows
  LoadedExperiment base;
};

struct StudyRun {
  std::size_t scene = 0;
  std::optional<double> theta_deg;  // nothing: the light as it is
  std::optional<double> far;        // of the camera; nothing: as it is
  Technique technique = Technique::uniform;
  int resolution = 1024;
  bool equal_error = false;  // also look for the uniform map with the same error
};

struct Study {
  std::vector<StudyScene> scenes;
  std::vector<StudyRun> runs;
  Repeats::Limits repeats;
  ResolutionRange equal_error;  // where it is looked for

  /// The run's own experiment: the scene's with light, technique and resolution set.
  Experiment experiment(const StudyRun& run) const;
};

/// What `psmlab report` measures; `quick`: a small part of it, for tests and first looks.
Study default_study(bool quick);

/// The scene of the table "what users could pick instead": a slab whose top is the ground, a directional light straight above.
StudyScene slab_scene();
inline constexpr const char* kSlab = "slab";
inline constexpr const char* kSlabVisible = "slab_visible";  // the same, fitted to what is visible of it
inline constexpr const char* kSlabFar = "slab_far";          // the same at one angle, for several far distances

/// One run for each combination, scenes and angles outermost, so that what they share is computed once.
struct Sweep {
  std::vector<std::optional<double>> theta_deg, far;
  std::vector<Technique> techniques;
  std::vector<int> resolutions;
  std::optional<int> equal_error_at;  // resolution at which the equal uniform map is looked for
};
void add_runs(Study& study, std::size_t scene, const Sweep& sweep);

/// The experiment with its sun at this angle to the view direction, in the plane of the two; above the horizon where it can be.
Experiment with_theta(Experiment experiment, double theta_deg);

/// Changes with the program's version, the runs and their experiments: rows of different fingerprints do not belong together.
std::string fingerprint(const Study& study, const std::string& version);

/// Whether the row is what its run asks for. Rows come from files, which anybody may have changed.
bool is_row_of(const Study& study, const StudyRow& row);

/// All techniques but `custom`, which needs a plane of somebody's own.
std::vector<Technique> techniques_to_compare();

}  // namespace psm
