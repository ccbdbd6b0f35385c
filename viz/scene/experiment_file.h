// SPDX-License-Identifier: GPL-3.0-or-later
// Experiments as text: *.psm.json files, and --set PATH=VALUE over them. Unknown members and out-of-range values are errors that
// name the JSON path, the value and what is allowed; the input is then refused whole.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/experiment.h"
#include "scene/result.h"
#include "scene/scene.h"

namespace psm {

/// An experiment with the scene it needs, ready to analyze.
struct LoadedExperiment {
  Experiment experiment;
  Scene scene;
  std::filesystem::path base;  // relative scene paths are relative to this folder
};

/// Resolves, in this order: defaults, the scene's own camera and light, the file's members, the overrides
/// ("light.to_light=0,1,0"). `source`: an experiment file, a .gltf or .glb, a built-in scene's id, a share text
/// (scene/share_text.h), or empty (the default experiment).
Result<LoadedExperiment> load_experiment(const std::string& source, const std::vector<std::string>& overrides);

/// The same from JSON text; `name` stands for the file in messages, `base` is the folder of relative paths.
Result<LoadedExperiment> parse_experiment(const std::string& json_text, const std::string& name,
                                          const std::filesystem::path& base, const std::vector<std::string>& overrides);

/// What was pasted: a share text, or the JSON of an experiment.
Result<LoadedExperiment> experiment_from_text(const std::string& text);

/// One override on a complete experiment; null on success. Does not load a scene.
std::optional<InputError> set_field(Experiment& experiment, const std::string& path_and_value);

/// All members as JSON, two-space indented; numbers round-trip.
std::string experiment_to_json(const Experiment& experiment);

/// Written whole or not at all. Relative scene paths stay valid for the new place.
std::optional<InputError> save_experiment(const LoadedExperiment& loaded, const std::filesystem::path& file);

/// Temporary file beside `file`, then rename.
std::optional<InputError> write_file_atomically(const std::filesystem::path& file, const std::string& bytes);

}  // namespace psm
