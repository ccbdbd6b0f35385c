// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model.h"

#include <chrono>

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
  const auto start = std::chrono::steady_clock::now();
  analysis_ = analyze_with_statistics(loaded_.experiment, loaded_.scene, tracer_);
  analysis_ms_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  ++analysis_revision_;
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

std::optional<InputError> Model::open(const std::string& source) {
  Result<LoadedExperiment> loaded = load_experiment(source, {});
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

bool Model::unsaved() const { return !same_but_views(saved_, loaded_.experiment); }

}  // namespace psm
