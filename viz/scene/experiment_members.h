// SPDX-License-Identifier: GPL-3.0-or-later
// Members of an experiment as they come in, from a file, a line of text, --set or a lesson, before they go over a scene's own
// camera and light.
#pragma once

#include <string>
#include <vector>

#include "scene/experiment.h"
#include "scene/experiment_file.h"
#include "scene/result.h"
#include "scene/scene.h"

namespace psm {

/// What a scene alone is: the defaults, with its own camera and light. Not checked.
Experiment scene_experiment(const std::string& source, const Scene& scene);

/// Some members and their values, each within its range. Members that are not in `set` mean nothing.
struct ExperimentMembers {
  Experiment values;
  std::vector<const Field*> set;

  bool has(const std::string& path) const;
  void copy_to(Experiment& experiment) const;
  /// These values go over the ones here.
  void add(const ExperimentMembers& over);
};

/// From JSON text. Errors start at the JSON path.
Result<ExperimentMembers> members_from_json(const std::string& json_text);

/// From "PATH=VALUE" each. Errors start at the path.
Result<ExperimentMembers> members_from_overrides(const std::vector<std::string>& overrides);

/// Defaults, the scene's own camera and light, then the members. Errors start with `place`.
Result<LoadedExperiment> load_members(const ExperimentMembers& members, const std::string& place,
                                      const std::filesystem::path& base);

/// What a user typed, fit for a line of a message: no control characters, at most 80 bytes.
std::string quotable(const std::string& text);

/// "PATH: VALUE is not allowed; allowed: ...".
InputError not_allowed(const std::string& path, const std::string& value, const std::string& allowed);

/// "PATH: no such member; allowed: ...", with the members that the path could have meant.
InputError unknown_member(const std::string& path);

}  // namespace psm
