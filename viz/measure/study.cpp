// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/study.h"

#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "scene/light_angles.h"

namespace psm {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;
constexpr double kLowestSun = 4.0;  // degrees above the horizon: below, the ground is hardly lit

/// The sun shines from where the scene's light stands, so that theta means the same in every scene.
LoadedExperiment with_sun(LoadedExperiment base) {
  const Bounds& b = base.scene.bounds;
  base.experiment.light = with_type(base.experiment.light, LightType::directional, 0.5 * (b.min + b.max), 1.0);
  return base;
}

StudyScene builtin(const std::string& id, const ImageSettings& image) {
  auto loaded = load_experiment(id, {});
  assert(loaded);
  StudyScene scene{id, with_sun(std::move(*loaded))};
  scene.base.experiment.image = image;
  return scene;
}

/// Those at which the sun stands above the horizon.
std::vector<std::optional<double>> daytime(const Experiment& experiment, const std::vector<double>& theta_deg) {
  std::vector<std::optional<double>> angles;
  for (const double theta : theta_deg) {
    const double elevation = bearing_of(with_theta(experiment, theta).light.to_light).elevation;
    if (elevation >= kLowestSun * kDegree) angles.push_back(theta);
  }
  return angles;
}

/// Ahead of the viewer, then the same angles behind.
std::vector<std::optional<double>> ahead_and_behind(const std::vector<double>& theta_deg) {
  std::vector<std::optional<double>> angles(theta_deg.begin(), theta_deg.end());
  for (const double theta : theta_deg)
    if (theta != 90.0) angles.push_back(180.0 - theta);
  return angles;
}

void add_box(Scene& scene, const glm::dvec3& a, const glm::dvec3& b) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) mesh.positions.push_back({i & 1 ? b.x : a.x, i & 2 ? b.y : a.y, i & 4 ? b.z : a.z});
  mesh.triangles = {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};
  scene.meshes.push_back(mesh);
  update_bounds(scene);
}

std::uint64_t hash(std::uint64_t state, const std::string& text) {
  for (const char c : text) state = (state ^ static_cast<unsigned char>(c)) * 1099511628211u;  // FNV-1a
  return (state ^ 0xff) * 1099511628211u;                                                      // between two texts
}

}  // namespace

Experiment with_theta(Experiment experiment, double theta_deg) {
  const double theta = theta_deg == 90.0 ? std::acos(0.0) : theta_deg * kDegree;
  experiment.light.to_light = to_light_at(experiment, theta, theta_side(experiment));
  return experiment;
}

Experiment Study::experiment(const StudyRun& run) const {
  Experiment x = scenes[run.scene].base.experiment;
  if (run.far) x.camera.far = *run.far;
  if (run.theta_deg) x = with_theta(x, *run.theta_deg);
  x.shadow.technique = run.technique;
  x.shadow.resolution = run.resolution;
  return x;
}

void add_runs(Study& study, std::size_t scene, const Sweep& sweep) {
  for (const auto& far : sweep.far)
    for (const auto& theta : sweep.theta_deg)
      for (const int resolution : sweep.resolutions)
        for (const Technique technique : sweep.techniques)
          study.runs.push_back({scene, theta, far, technique, resolution, sweep.equal_error_at == resolution});
}

StudyScene slab_scene() {
  StudyScene slab{kSlab, {}};
  slab.base.scene.id = kSlab;
  slab.base.scene.materials.emplace_back();
  add_box(slab.base.scene, {-100, -10, -100}, {100, 0, 100});
  Experiment& x = slab.base.experiment;
  x.scene.source = kSlab;
  x.camera = {{0, 1.7, 0}, {0, 1.7, -1}, {0, 1, 0}, 60.0, 1.0, 100.0};
  x.image = {640, 360};
  x.light.to_light = {0, 1, 0};
  return slab;
}

std::vector<Technique> techniques_to_compare() {
  std::vector<Technique> techniques;
  for (int i = 0; i < int(Technique::custom); ++i) techniques.push_back(Technique(i));
  return techniques;
}

namespace {

/// The one-scene table with the window around the receivers' body, with it around what is visible, and at one angle over n/f.
void add_slabs(Study& study, const ImageSettings& image, const std::vector<Technique>& techniques, bool quick) {
  const std::vector<std::optional<double>> table =
      ahead_and_behind(quick ? std::vector<double>{90, 20} : std::vector<double>{90, 75, 60, 45, 35, 30, 20, 10, 5, 1});
  const std::vector<Technique> few{Technique::uniform, Technique::psm,           Technique::lispsm_reference,
                                   Technique::gmnpr,   Technique::plane_optimal, Technique::best_plane};
  const auto add = [&](const char* name, Focus focus, const Sweep& sweep) {
    study.scenes.push_back(slab_scene());
    study.scenes.back().name = name;
    study.scenes.back().base.experiment.image = image;
    study.scenes.back().base.experiment.shadow.focus = focus;
    add_runs(study, study.scenes.size() - 1, sweep);
  };
  add(kSlab, Focus::bounds, {table, {std::nullopt}, techniques, {1024}, {}});
  add(kSlabVisible, Focus::visible, {table, {std::nullopt}, quick ? techniques : few, {1024}, {}});
  const std::vector<std::optional<double>> far =
      quick ? std::vector<std::optional<double>>{10, 100} : std::vector<std::optional<double>>{5, 10, 20, 50, 100};
  add(kSlabFar, Focus::bounds, {{60}, far, quick ? techniques : few, {1024}, {}});
}

}  // namespace

Study default_study(bool quick) {
  Study study;
  const ImageSettings image = quick ? ImageSettings{160, 90} : ImageSettings{640, 360};
  // Not 90: there the shadows of upright things run along the rows of texels, and errors say more about the rows than the map.
  const std::vector<double> theta = quick ? std::vector<double>{80, 30} : std::vector<double>{80, 60, 45, 30, 15, 5, 120, 150};
  const std::vector<Technique> techniques =
      quick ? std::vector<Technique>{Technique::uniform, Technique::psm, Technique::gmnpr, Technique::best_plane}
            : techniques_to_compare();
  Sweep sweep{{}, {std::nullopt}, techniques, {256, 512, 1024, 2048}, 1024};
  if (quick) {
    sweep.resolutions = {256, 512};
    sweep.equal_error_at = 256;
    study.equal_error = {16, 2048, 1.0 / 16};
    study.repeats = {3, 3, 0.05, 0.2, 1};
  }
  for (const char* id : {"chessboard", "ground"}) {  // more scenes would take hours and say the same
    if (quick && std::string(id) != "ground") continue;
    study.scenes.push_back(builtin(id, image));
    sweep.theta_deg = daytime(study.scenes.back().base.experiment, theta);
    add_runs(study, study.scenes.size() - 1, sweep);
  }
  add_slabs(study, image, techniques, quick);
  return study;
}

std::string fingerprint(const Study& study, const std::string& version) {
  std::uint64_t state = hash(14695981039346656037u, version);
  for (const StudyScene& scene : study.scenes) {
    state = hash(state, scene.name + experiment_to_json(scene.base.experiment));
    state = hash(state, std::to_string(scene.base.scene.triangle_count()));
  }
  for (const StudyRun& run : study.runs) {
    std::string text = std::to_string(run.scene) + " " + name_of(run.technique) + " " + std::to_string(run.resolution);
    text += run.theta_deg ? " theta " + number_text(*run.theta_deg) : "";
    text += run.far ? " far " + number_text(*run.far) : "";
    state = hash(state, text + (run.equal_error ? " equal" : ""));
  }
  char text[20];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(state));
  return text;
}

bool is_row_of(const Study& study, const StudyRow& row) {
  if (!(row.run >= 0 && row.run < double(study.runs.size()) && std::trunc(row.run) == row.run)) return false;
  const StudyRun& run = study.runs[std::size_t(row.run)];
  const StudyScene& scene = study.scenes[run.scene];
  const ImageSettings& image = scene.base.experiment.image;
  return row.scene == scene.name && row.technique == name_of(run.technique) && row.resolution == run.resolution &&
         (!run.theta_deg || row.theta_deg == *run.theta_deg) && (!run.far || row.camera_far == *run.far) &&
         row.width == image.width && row.height == image.height;
}

}  // namespace psm
