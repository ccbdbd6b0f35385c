// SPDX-License-Identifier: GPL-3.0-or-later
// The experiment at hand with its scene, its analysis and its history. Knows no widgets and no OpenGL.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "measure/shadow_error.h"
#include "scene/experiment_file.h"
#include "ui/history.h"

namespace psm {

class Model {
 public:
  explicit Model(LoadedExperiment loaded);

  const Experiment& experiment() const { return loaded_.experiment; }
  const Scene& scene() const { return loaded_.scene; }
  const RayTracer& tracer() const { return tracer_; }
  const Analysis& analysis() const { return analysis_; }
  const Experiment& original() const { return original_; }  // as opened: what resets go back to

  /// Takes over an edited copy, made valid, and analyzes it unless only the views changed. `tag`: see History. Returns whether
  /// anything changed.
  bool commit(const Experiment& edited, const std::string& tag, double now);
  /// No button is down and no widget is active any more.
  void end_gesture();

  bool undo();
  bool redo();
  void reset();  // to original(); can be undone

  /// An experiment file, a .gltf or .glb, or a built-in scene's id. On an error everything stays as it is. Can be undone.
  std::optional<InputError> open(const std::string& source);
  std::optional<InputError> save(const std::filesystem::path& file);
  /// More than the views differs from what was opened or last saved.
  bool unsaved() const;

  const History& history() const { return history_; }
  std::uint64_t analysis_revision() const { return analysis_revision_; }  // grows with each analysis
  std::uint64_t scene_revision() const { return scene_revision_; }        // grows with each scene
  double analysis_ms() const { return analysis_ms_; }

 private:
  std::optional<InputError> go_to(const Experiment& experiment);
  std::optional<InputError> load_scene_of(const Experiment& experiment);
  void analyze_now();
  void adopt_scene_source();

  LoadedExperiment loaded_;
  RayTracer tracer_;  // of loaded_.scene
  Experiment original_, saved_;
  std::map<std::string, Experiment> originals_;  // by scene source, for undo across scenes
  Analysis analysis_;
  History history_;
  std::uint64_t analysis_revision_ = 0, scene_revision_ = 0;
  double analysis_ms_ = 0.0;
};

/// `edited` with each member back in its range and members that are tied together agreeing (near < far, up not along the view
/// direction ...); members that cannot be helped fall back to those of `before`, which is valid.
Experiment made_valid(const Experiment& before, Experiment edited);

/// The value back into its row's range.
void clamp_field(const Field& field, Experiment& experiment);

/// Copies one member.
void copy_field(const Field& field, const Experiment& from, Experiment& to);

}  // namespace psm
