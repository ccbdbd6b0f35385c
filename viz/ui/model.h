// SPDX-License-Identifier: GPL-3.0-or-later
// The experiment at hand with its scene, its analysis and its history. Knows no widgets and no OpenGL.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "measure/shadow_error.h"
#include "scene/experiment_file.h"
#include "ui/history.h"
#include "ui/points_source.h"

namespace psm {

/// All that the visible points depend on.
struct Sight {
  CameraSettings camera;
  double aspect = 1.0;
  std::uint64_t scene = 0;  // revision
  bool operator==(const Sight&) const = default;
};

class Model {
 public:
  explicit Model(LoadedExperiment loaded);

  const LoadedExperiment& loaded() const { return loaded_; }
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
  /// Goes to a valid experiment of the same scene; no step of the history.
  void follow(const Experiment& experiment) { (void)go_to(experiment); }

  /// An experiment file, a .gltf or .glb, a built-in scene's id or a share text. On an error everything stays as it is. Can be
  /// undone.
  std::optional<InputError> open(const std::string& source) { return take_over(load_experiment(source, {})); }
  /// The same with a share text or the JSON of an experiment.
  std::optional<InputError> paste(const std::string& text) { return take_over(experiment_from_text(text)); }
  std::optional<InputError> save(const std::filesystem::path& file);
  /// Where resets go back to from now on; none: how it was opened.
  void set_original(const std::optional<Experiment>& original);
  /// More than the views differs from what was opened or last saved.
  bool unsaved() const { return unsaved(loaded_.experiment); }
  bool unsaved(const Experiment& experiment) const;

  /// Points of another source are forgotten.
  void set_points_source(PointsSource source);
  /// What the eye of `sight` sees, from the card. Analyzed again only where that changes the answer; returns whether it does.
  bool set_visible_points(std::vector<SurfacePoint> points, const Sight& sight, double ms);
  /// Statistics of texels over all pixels in place of those over the visible points, unless this analysis has them. Takes a
  /// hundred milliseconds, several where the eye has moved.
  void count_texels();
  bool texels_counted() const { return counted_of_ == analysis_revision_; }
  Sight sight() const;
  /// What the analysis went by, and of which eye that was: an older one while new points are on their way.
  const std::vector<SurfacePoint>& visible_points() const { return points_; }
  const std::optional<Sight>& points_sight() const { return points_sight_; }
  PointsSource points_source() const { return source_; }

  const History& history() const { return history_; }
  /// Undo begins anew with `history`; returns what there was.
  History replace_history(History history) { return std::exchange(history_, std::move(history)); }
  std::uint64_t analysis_revision() const { return analysis_revision_; }  // grows with each analysis
  std::uint64_t texels_revision() const { return texels_revision_; }      // grows with that, and when the texels are counted
  std::uint64_t scene_revision() const { return scene_revision_; }        // grows with each scene
  std::uint64_t points_revision() const { return points_revision_; }      // grows with each set of visible points
  double analysis_ms() const { return analysis_ms_; }                     // without the visible points
  double points_ms() const { return points_ms_; }

 private:
  std::optional<InputError> take_over(Result<LoadedExperiment> loaded);
  std::optional<InputError> go_to(const Experiment& experiment);
  std::optional<InputError> load_scene_of(const Experiment& experiment);
  void analyze_now();
  Analysis analyzed();
  void adopt(Analysis analysis);
  void trace_points();
  void adopt_scene_source();

  LoadedExperiment loaded_;
  RayTracer tracer_;  // of loaded_.scene
  Experiment original_, saved_;
  std::map<std::string, Experiment> originals_;  // by scene source, for undo across scenes
  Analysis analysis_;
  History history_;
  std::uint64_t analysis_revision_ = 0, texels_revision_ = 0, scene_revision_ = 0;
  std::uint64_t counted_of_ = 0;  // analysis revision
  double analysis_ms_ = 0.0, points_ms_ = 0.0;
  VisibleImage image_;  // of all pixels, for image_sight_
  std::optional<Sight> image_sight_;
  PointsSource source_ = PointsSource::rays;
  std::vector<SurfacePoint> points_;
  std::optional<Sight> points_sight_;
  std::uint64_t points_revision_ = 0;
};

/// `edited` with each member back in its range and members that are tied together agreeing (near < far, up not along the view
/// direction ...); members that cannot be helped fall back to those of `before`, which is valid.
Experiment made_valid(const Experiment& before, Experiment edited);

/// The value back into its row's range.
void clamp_field(const Field& field, Experiment& experiment);

/// Copies one member.
void copy_field(const Field& field, const Experiment& from, Experiment& to);

}  // namespace psm
