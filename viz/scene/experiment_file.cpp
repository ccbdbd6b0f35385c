// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/experiment_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "scene/experiment_members.h"
#include "scene/share_text.h"

namespace psm {
namespace {

namespace fs = std::filesystem;

InputError prefixed(const std::string& prefix, const InputError& error) { return {prefix + ": " + error.text}; }

bool is_builtin(const std::string& source) {
  const auto ids = builtin_scene_ids();
  return std::find(ids.begin(), ids.end(), source) != ids.end();
}

std::string builtin_ids_text() {
  std::string text;
  for (const std::string& id : builtin_scene_ids()) text += (text.empty() ? "" : ", ") + id;
  return text;
}

bool is_gltf(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return extension == ".gltf" || extension == ".glb";
}

Result<std::string> read_experiment_text(const fs::path& file) {
  constexpr std::size_t most = 16u << 20;
  const std::string name = quotable(file.string());
  std::error_code error;
  if (fs::is_directory(file, error)) return InputError{name + ": is a folder; allowed: an experiment file (.psm.json)"};
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    return InputError{name + ": cannot be read: " + std::strerror(errno ? errno : EIO) +
                      "; allowed: an experiment file (.psm.json), a .gltf or .glb file, or one of: " + builtin_ids_text()};
  std::string text(most + 1, '\0');
  stream.read(text.data(), std::streamsize(text.size()));
  text.resize(std::size_t(stream.gcount()));
  if (stream.bad()) return InputError{name + ": cannot be read to its end"};
  if (text.size() > most) return InputError{name + ": larger than 16 MiB; allowed: an experiment file (.psm.json) up to 16 MiB"};
  return text;
}

/// A path given on the command line is relative to the current folder; the experiment's are relative to `base`.
std::string relative_to_base(const std::string& source, const fs::path& base) {
  if (is_builtin(source) || fs::path(source).is_absolute()) return source;
  std::error_code error;
  const fs::path relative = fs::proximate(source, base.empty() ? "." : base, error);
  return error ? source : relative.string();
}

/// Members that mean nothing beside this type of light are not an error, but the user is told.
void note_dropped(const ExperimentMembers& members, const Experiment& experiment, Scene& scene) {
  for (const Field* field : members.set) {
    if (field->applies(experiment)) continue;
    scene.notes.push_back({"member_dropped",
                           field->path + " has no meaning for a " + name_of(experiment.light.type) + " light and was dropped.",
                           std::nullopt, std::nullopt});
  }
}

/// `file_prefix` starts every message about the file's members.
Result<LoadedExperiment> resolve(const ExperimentMembers& file, const std::string& file_prefix, ExperimentMembers overrides,
                                 const fs::path& base) {
  if (overrides.has("scene.source")) {
    std::string& source = overrides.values.scene.source;
    source = relative_to_base(source, base);
  }
  LoadedExperiment loaded;
  loaded.base = base;
  Experiment& experiment = loaded.experiment;
  file.copy_to(experiment);
  overrides.copy_to(experiment);
  auto scene = load_scene(experiment.scene.source, base);
  if (!scene)
    return overrides.has("scene.source") ? prefixed("--set scene.source", scene.error())
           : file_prefix.empty()         ? scene.error()  // the scene itself was named, and the error names it
                                         : prefixed(file_prefix + "scene.source", scene.error());
  loaded.scene = std::move(*scene);

  experiment = scene_experiment(experiment.scene.source, loaded.scene);
  if (auto error = check_experiment(experiment)) return prefixed("scene " + quotable(loaded.scene.id), *error);
  file.copy_to(experiment);
  if (auto error = check_experiment(experiment)) return InputError{file_prefix + error->text};
  note_dropped(file, experiment, loaded.scene);
  overrides.copy_to(experiment);
  if (auto error = check_experiment(experiment)) return InputError{"--set " + error->text};
  note_dropped(overrides, experiment, loaded.scene);
  return loaded;
}

Result<ExperimentMembers> read_overrides(const std::vector<std::string>& overrides) {
  auto members = members_from_overrides(overrides);
  if (!members) return InputError{"--set " + members.error().text};
  return members;
}

/// The scene alone is the experiment.
Result<LoadedExperiment> from_scene(const std::string& source, const std::vector<std::string>& overrides) {
  auto given = read_overrides(overrides);
  if (!given) return given.error();
  ExperimentMembers members;
  members.values.scene.source = source;
  members.set.push_back(find_field("scene.source"));
  if (auto error = check_field(*members.set.front(), members.values)) return *error;
  return resolve(members, "", *given, fs::path("."));
}

/// Its scene's path is relative to the current folder.
Result<LoadedExperiment> from_share_text(const std::string& text, const std::vector<std::string>& overrides) {
  const auto members = members_from_share_text(text);
  if (!members) return members.error();
  auto given = read_overrides(overrides);
  if (!given) return given.error();
  return resolve(*members, "", *given, fs::path("."));
}

}  // namespace

Result<LoadedExperiment> load_members(const ExperimentMembers& members, const std::string& place, const fs::path& base) {
  return resolve(members, place + ": ", {}, base);
}

Result<LoadedExperiment> parse_experiment(const std::string& json_text, const std::string& name, const fs::path& base,
                                          const std::vector<std::string>& overrides) {
  const auto file = members_from_json(json_text);
  if (!file) return prefixed(quotable(name), file.error());
  auto given = read_overrides(overrides);
  if (!given) return given.error();
  return resolve(*file, quotable(name) + ": ", *given, base);
}

Result<LoadedExperiment> load_experiment(const std::string& source, const std::vector<std::string>& overrides) {
  if (is_share_text(source)) return from_share_text(source, overrides);
  if (source.empty() || is_builtin(source) || is_gltf(source))
    return from_scene(source.empty() ? SceneSettings().source : source, overrides);
  const auto text = read_experiment_text(source);
  if (!text) return text.error();
  const fs::path folder = fs::path(source).parent_path();
  return parse_experiment(*text, source, folder.empty() ? fs::path(".") : folder, overrides);
}

Result<LoadedExperiment> experiment_from_text(const std::string& text) {
  if (is_share_text(text)) return from_share_text(text, {});
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first != std::string::npos && text[first] == '{') return parse_experiment(text, "the pasted text", ".", {});
  const std::string shown = text.size() == 0 ? "an empty text" : quotable(text);
  return InputError{shown + ": is no experiment; allowed: psmlab:SCENE?PATH=VALUE&PATH=VALUE, or an experiment as JSON"};
}

std::optional<InputError> save_experiment(const LoadedExperiment& loaded, const fs::path& file) {
  const std::string name = quotable(file.string());
  if (auto error = check_experiment(loaded.experiment)) return prefixed(name, *error);
  Experiment experiment = loaded.experiment;
  std::string& source = experiment.scene.source;
  if (!is_builtin(source) && fs::path(source).is_relative()) {
    std::error_code error;
    const fs::path folder = file.parent_path().empty() ? fs::path(".") : file.parent_path();
    const fs::path moved = fs::proximate(loaded.base / source, folder, error);
    if (error) return InputError{name + ": cannot be written: " + error.message() + "; allowed: a file in an existing folder"};
    source = moved.string();
  }
  return write_file_atomically(file, experiment_to_json(experiment));
}

}  // namespace psm
