// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model.h"

#include <chrono>
#include <cmath>

#include "measure/texel_analysis.h"
#include "scene/eye_and_light.h"

namespace psm {
namespace {

namespace fs = std::filesystem;

bool is_builtin(const std::string& source) {
  for (const std::string& id : builtin_scene_ids())
    if (id == source) return true;
  return false;
}

bool same_but_views(Experiment a, const Experiment& b) {
  a.view = b.view;
  return a == b;
}

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) { return std::chrono::duration<double, std::milli>(Clock::now() - start).count(); }

/// Those that another eye saw and this one has in its frustum as well.
std::vector<SurfacePoint> in_frustum(const std::vector<SurfacePoint>& points, const Experiment& x) {
  const ViewFrame view = camera_frame(x);
  std::vector<SurfacePoint> out;
  for (const SurfacePoint& p : points) {
    const glm::dvec3 from_eye = p.position - view.eye;
    const double depth = view.depth(p.position), right = glm::dot(from_eye, view.right), up = glm::dot(from_eye, view.up);
    const bool inside = depth >= x.camera.near && depth <= x.camera.far && std::abs(right) <= view.tan_x * depth &&
                        std::abs(up) <= view.tan_y * depth;
    if (inside && glm::dot(p.normal, from_eye) < 0.0) out.push_back(p);
  }
  return out;
}

/// In all that visible points have a say in.
bool same_answer(const Analysis& a, const Analysis& b) {
  return a.map_from_world == b.map_from_world && a.map_beyond_from_world == b.map_beyond_from_world &&
         a.cube_maps_from_world == b.cube_maps_from_world && a.vanishing_plane == b.vanishing_plane && a.near == b.near &&
         a.far == b.far && a.rho == b.rho && a.technique_used == b.technique_used && a.camera_shift == b.camera_shift &&
         a.notes == b.notes && a.worse_than_uniform == b.worse_than_uniform && a.fitted_body.vertices == b.fitted_body.vertices &&
         a.texels == b.texels;
}

}  // namespace

Model::Model(LoadedExperiment loaded) : loaded_(std::move(loaded)), tracer_(loaded_.scene) {
  adopt_scene_source();
  original_ = saved_ = loaded_.experiment;
  originals_[loaded_.experiment.scene.source] = original_;
  scene_revision_ = 1;
  analyze_now();
}

// History steps may lead back here from a scene that was opened elsewhere: the path must not depend on the folder.
void Model::adopt_scene_source() {
  std::string& source = loaded_.experiment.scene.source;
  if (is_builtin(source) || fs::path(source).is_absolute()) return;
  std::error_code ignored;
  const fs::path absolute = fs::absolute(loaded_.base / source, ignored);
  if (!absolute.empty()) source = absolute.lexically_normal().string();
}

void Model::analyze_now() {
  trace_points();
  adopt(analyzed());
}

void Model::adopt(Analysis analysis) {
  analysis_ = std::move(analysis);
  ++analysis_revision_;
  ++texels_revision_;
}

void Model::count_texels() {
  if (texels_counted()) return;
  counted_of_ = analysis_revision_;
  const ImageSettings& size = loaded_.experiment.image;
  if (image_sight_ != sight() || image_.width != size.width) image_ = see(tracer_, loaded_.experiment, size.width, size.height);
  image_sight_ = sight();
  psm::count_texels(analysis_, loaded_.scene, tracer_, image_);
  ++texels_revision_;
}

Analysis Model::analyzed() {
  const auto start = Clock::now();
  const bool known = points_sight_ && points_sight_->scene == scene_revision_;
  const std::vector<SurfacePoint> older =
      known && points_sight_ != sight() ? in_frustum(points_, loaded_.experiment) : std::vector<SurfacePoint>();
  const std::vector<SurfacePoint>& visible = points_sight_ == sight() ? points_ : older;
  Analysis out = analyze(loaded_.experiment, loaded_.scene, visible);
  out.texels = texel_statistics(visible, out);
  analysis_ms_ = ms_since(start);
  return out;
}

Sight Model::sight() const { return {loaded_.experiment.camera, loaded_.experiment.image.aspect(), scene_revision_}; }

// The light does not change what the eye sees.
void Model::trace_points() {
  if (source_ != PointsSource::rays || points_sight_ == sight()) return;
  const auto start = Clock::now();
  points_ = psm::visible_points(tracer_, loaded_.experiment);
  points_ms_ = ms_since(start);
  points_sight_ = sight();
  ++points_revision_;
}

void Model::set_points_source(PointsSource source) {
  if (source == source_) return;
  source_ = source;
  points_sight_.reset();
  analyze_now();
}

bool Model::set_visible_points(std::vector<SurfacePoint> points, const Sight& sight, double ms) {
  if (source_ != PointsSource::depth || sight.scene != scene_revision_) return false;
  points_ = std::move(points);
  points_sight_ = sight;
  points_ms_ = ms;
  ++points_revision_;
  Analysis next = analyzed();
  if (texels_counted()) next.texels = analysis_.texels;  // they do not go by these points
  if (same_answer(next, analysis_)) return false;
  adopt(std::move(next));
  return true;
}

std::optional<InputError> Model::load_scene_of(const Experiment& experiment) {
  Result<Scene> scene = load_scene(experiment.scene.source, loaded_.base);
  if (!scene) return scene.error();
  loaded_.scene = std::move(*scene);
  tracer_ = RayTracer(loaded_.scene);
  ++scene_revision_;
  const auto known = originals_.find(experiment.scene.source);
  original_ = known != originals_.end() ? known->second : experiment;
  return std::nullopt;
}

std::optional<InputError> Model::go_to(const Experiment& next) {
  if (next.scene != loaded_.experiment.scene)
    if (auto error = load_scene_of(next)) return error;
  const bool views_only = same_but_views(loaded_.experiment, next);
  loaded_.experiment = next;
  if (views_only)
    analysis_.experiment.view = next.view;
  else
    analyze_now();
  return std::nullopt;
}

bool Model::commit(const Experiment& edited, const std::string& tag, double now) {
  if (edited == loaded_.experiment) return false;
  const Experiment before = loaded_.experiment;
  const Experiment next = made_valid(before, edited);
  if (next == before || go_to(next)) return false;
  history_.record(before, tag, now);
  return true;
}

void Model::end_gesture() { history_.end_gesture(loaded_.experiment); }

bool Model::undo() {
  const auto target = history_.undo(loaded_.experiment);
  return target && !go_to(*target);
}

bool Model::redo() {
  const auto target = history_.redo(loaded_.experiment);
  return target && !go_to(*target);
}

void Model::reset() {
  end_gesture();
  commit(original_, "", 0.0);
  end_gesture();
}

std::optional<InputError> Model::take_over(Result<LoadedExperiment> loaded) {
  if (!loaded) return loaded.error();
  end_gesture();
  const Experiment before = loaded_.experiment;
  loaded_ = std::move(*loaded);
  tracer_ = RayTracer(loaded_.scene);
  adopt_scene_source();
  original_ = saved_ = loaded_.experiment;
  originals_[original_.scene.source] = original_;
  ++scene_revision_;
  analyze_now();
  if (before != loaded_.experiment) history_.record(before, "", 0.0);
  end_gesture();
  return std::nullopt;
}

std::optional<InputError> Model::save(const fs::path& file) {
  if (auto error = save_experiment(loaded_, file)) return error;
  saved_ = loaded_.experiment;
  return std::nullopt;
}

bool Model::unsaved(const Experiment& experiment) const { return !same_but_views(saved_, experiment); }

void Model::set_original(const std::optional<Experiment>& original) {
  const auto known = originals_.find(loaded_.experiment.scene.source);
  original_ = original ? *original : known != originals_.end() ? known->second : loaded_.experiment;
}

}  // namespace psm
