// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/study_runner.h"

#include <chrono>
#include <cmath>
#include <map>

#include "app/assets.h"
#include "app/headless_context.h"
#include "app/machine.h"
#include "geom/frustum.h"
#include "gl/pass_timer.h"
#include "gl/renderer.h"
#include "measure/line_error.h"
#include "measure/shadow_error.h"

namespace psm {
namespace {

constexpr double kDegrees = 57.29577951308232;

/// To the nanosecond; a time that was not measured does not exist.
double microseconds(double seconds) { return seconds < 0 ? kNone : std::round(seconds * 1e9) / 1e3; }

double seconds_of(const std::function<void()>& work) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// What the runs under one light share, whatever their technique and resolution.
struct Condition {
  Experiment experiment;  // with any technique and resolution
  VisibleImage image;
  std::vector<float> fractions;  // of the light that is seen
  std::vector<Lit> truth;
  std::vector<SurfacePoint> points;     // for analyze()
  std::map<int, double> uniform_error;  // by resolution, as far as anybody asked
};

bool same_condition(Experiment a, const Experiment& b) {
  a.shadow = b.shadow;
  return a == b;
}

/// The eye's image without anything drawn over it.
ViewPicture plain_eye(const Analysis& analysis) {
  ViewPicture picture;
  picture.id = ViewId::eye;
  picture.clip_from_world = analysis.clip_from_world();
  return picture;
}

/// The bodies that the analysis makes, from the same planes: R, H and H_R. A spot's cone is left out.
void make_bodies(const Analysis& a) {
  const CameraSettings& c = a.experiment.camera;
  const double tan_y = std::tan(c.vertical_fov_deg / kDegrees / 2);
  const ViewFrame view = view_frame(c.position, c.target - c.position, c.up, tan_y * a.experiment.image.aspect(), tan_y);
  const std::vector<Plane> planes = frustum_planes(view, c.near, c.far);
  const ConvexBody receivers = clip(a.scene_body, planes);
  const ConvexBody casters = clip(a.scene_body, frustum_hull_with_light(planes, a.light));
  const ConvexBody depth = clip(a.scene_body, hull_with_light(receivers, a.light));
}

void set_experiment(StudyRow& row, const Study& study, const StudyRun& run, const Analysis& a) {
  const Experiment& x = a.experiment;
  row.scene = study.scenes[run.scene].name;
  row.technique = name_of(run.technique);
  row.resolution = run.resolution;
  row.theta_deg = run.theta_deg.value_or(kNone);
  row.width = x.image.width, row.height = x.image.height, row.camera_far = x.camera.far;
  row.light_radius = x.light.radius;
  row.depth_bias = x.shadow.depth_bias, row.slope_bias = x.shadow.slope_bias, row.normal_bias = x.shadow.normal_bias;
  row.cull = name_of(x.shadow.cull), row.filter = name_of(x.shadow.filter);
  row.filter_size = x.shadow.filter == Filter::pcf ? x.shadow.filter_size : kNone;
  row.technique_used = name_of(a.technique_used);
  for (const Note& note : a.notes) row.notes += (row.notes.empty() ? "" : " ") + note.code;
}

void set_model(StudyRow& row, const Analysis& a) {
  row.near = a.near.value_or(kNone), row.far = a.far.value_or(kNone);
  row.phi_deg = a.phi ? *a.phi * kDegrees : kNone;
  row.rho = a.rho.value_or(kNone);
  if (a.theta && std::isnan(row.theta_deg)) row.theta_deg = *a.theta * kDegrees;
  if (a.model_error) row.model_F = a.model_error->F_max, row.model_E = a.model_error->E_max_line;
  row.line_E = largest_line_error(a).value_or(kNone);
}

void set_texels(StudyRow& row, const std::optional<TexelStatistics>& texels) {
  if (!texels) return;
  row.m_mean = texels->m_mean, row.m_p50 = texels->m_p50, row.m_p95 = texels->m_p95, row.m_max = texels->m_max;
  row.undersampled = texels->undersampled_fraction;
}

void set_errors(StudyRow& row, const ShadowError& error) {
  const auto cause = [&](ErrorCause c) { return double(error.by_cause[std::size_t(c)]); };
  row.compared = double(error.compared);
  row.error_fraction = error.compared > 0 ? error.fraction() : kNone;
  row.wrongly_lit = double(error.wrongly_lit), row.wrongly_dark = double(error.wrongly_dark);
  row.outside = cause(ErrorCause::outside), row.by_resolution = cause(ErrorCause::resolution);
  row.acne = cause(ErrorCause::acne), row.leak = cause(ErrorCause::leak);
}

int maps_of(const Analysis& a) { return a.cube_maps_from_world ? 6 : a.map_beyond_from_world ? 2 : 1; }

void set_times(StudyRow& row, const Repeats& repeats) {
  const FrameTimes t = repeats.medians();
  row.analysis_us = microseconds(t.analysis), row.bodies_us = microseconds(t.bodies);
  row.map_us = microseconds(t.map), row.map_gpu_us = microseconds(t.map_gpu);
  row.eye_us = microseconds(t.eye), row.eye_gpu_us = microseconds(t.eye_gpu);
  row.timing_runs = repeats.count();
  row.timing_spread = std::round(repeats.spread() * 1e4) / 1e4;
}

}  // namespace

struct StudyRunner::State {
  State(const Study& s, std::unique_ptr<HeadlessContext> gl)
      : study(s), context(std::move(gl)), renderer(assets_folder(), font_file()), machine(this_machine()) {
    print = fingerprint(study, PSMLAB_VERSION);
  }

  const Scene& scene_of(const StudyRun& run) const { return study.scenes[run.scene].base.scene; }
  void set_scene(const StudyRun& run);
  void set_condition(const StudyRun& run, const Experiment& experiment);
  Analysis analyzed(const StudyRun& run, const Experiment& experiment) {
    return analyze(experiment, scene_of(run), condition.points);
  }
  /// What the map that was drawn last gets wrong.
  ShadowError error_of(const MapReading& map, const std::vector<float>& m);
  MapReading read_map(const Analysis& analysis) {
    return renderer.read_map(analysis, condition.image.width, condition.image.height);
  }
  double uniform_error(const StudyRun& run, int resolution);
  FrameTimes time_frame(const StudyRun& run, const Experiment& experiment, bool with_eye);

  const Study& study;
  std::unique_ptr<HeadlessContext> context;
  Renderer renderer;
  PassTimer timer;
  Machine machine;
  std::string print;
  std::optional<std::size_t> scene;  // that tracer and renderer hold
  std::optional<RayTracer> tracer;
  Condition condition;
};

void StudyRunner::State::set_scene(const StudyRun& run) {
  if (scene == run.scene) return;
  scene = run.scene;
  tracer.emplace(scene_of(run));
  renderer.set_scene(scene_of(run));
  condition = {};
}

void StudyRunner::State::set_condition(const StudyRun& run, const Experiment& experiment) {
  set_scene(run);
  if (!condition.truth.empty() && same_condition(experiment, condition.experiment)) return;
  condition = {experiment, see(*tracer, experiment, experiment.image.width, experiment.image.height), {}, {}, {}, {}};
  condition.fractions = trace_fractions(*tracer, condition.image, experiment);
  condition.truth = lit_by_half(condition.image, condition.fractions);
  condition.points = visible_points(*tracer, experiment);
}

ShadowError StudyRunner::State::error_of(const MapReading& map, const std::vector<float>& m) {
  const VisibleImage& image = condition.image;
  return count_errors(condition.truth, find_errors(condition.truth, map.verdicts, m, image.width, image.height));
}

double StudyRunner::State::uniform_error(const StudyRun& run, int resolution) {
  const auto known = condition.uniform_error.find(resolution);
  if (known != condition.uniform_error.end()) return known->second;
  Experiment experiment = study.experiment(run);
  experiment.shadow.technique = Technique::uniform;
  experiment.shadow.resolution = resolution;
  const Analysis analysis = analyzed(run, experiment);
  renderer.draw_shadow_map(analysis);
  const double error = error_of(read_map(analysis), texel_sizes(condition.image, analysis)).fraction();
  return condition.uniform_error[resolution] = error;
}

FrameTimes StudyRunner::State::time_frame(const StudyRun& run, const Experiment& experiment, bool with_eye) {
  FrameTimes times;
  Analysis analysis;
  times.analysis = seconds_of([&] { analysis = analyzed(run, experiment); });
  times.bodies = seconds_of([&] { make_bodies(analysis); });
  const PassTime map = timer.time([&] { renderer.draw_shadow_map(analysis); });
  times.map = map.wall, times.map_gpu = map.gpu.value_or(-1);
  if (!with_eye) return times;
  const ViewPicture picture = plain_eye(analysis);
  const glm::ivec2 size(experiment.image.width, experiment.image.height);
  const PassTime eye = timer.time([&] { renderer.draw_view(picture, analysis, size, 1.0, Theme::light); });
  times.eye = eye.wall, times.eye_gpu = eye.gpu.value_or(-1);
  return times;
}

Result<std::unique_ptr<StudyRunner>> StudyRunner::create(const Study& study) {
  auto context = HeadlessContext::create();
  if (!context) return context.error();
  return std::unique_ptr<StudyRunner>(new StudyRunner(std::make_unique<State>(study, std::move(*context))));
}

StudyRunner::StudyRunner(std::unique_ptr<State> state) : state_(std::move(state)) {}
StudyRunner::~StudyRunner() = default;

StudyRow StudyRunner::measure(std::size_t index) {
  State& s = *state_;
  const StudyRun& run = s.study.runs[index];
  const Experiment experiment = s.study.experiment(run);
  s.set_condition(run, experiment);
  const Analysis analysis = s.analyzed(run, experiment);

  StudyRow row;
  row.version = PSMLAB_VERSION, row.study = s.print, row.run = double(index);
  set_experiment(row, s.study, run, analysis);
  set_model(row, analysis);
  s.renderer.draw_shadow_map(analysis);
  const double side = s.renderer.map_resolution();
  row.texels = side * side * (s.renderer.map_triangles() > 0 ? maps_of(analysis) : 0);
  if (side < run.resolution) row.notes += (row.notes.empty() ? "" : " ") + std::string("resolution_reduced");
  const std::vector<float> m = texel_sizes(s.condition.image, analysis);
  set_texels(row, texel_statistics(m));
  const MapReading map = s.read_map(analysis);
  set_errors(row, s.error_of(map, m));
  row.lit_difference = lit_difference(s.condition.fractions, map).value_or(kNone);

  if (run.equal_error && row.compared > 0) {
    const auto error_at = [&](int resolution) { return s.uniform_error(run, resolution); };
    const auto equal = equal_error_resolution(error_at, row.error_fraction, s.study.equal_error);
    row.equal_error_resolution = equal ? double(*equal) : INFINITY;
  }

  Repeats repeats(s.study.repeats);
  while (!repeats.enough()) repeats.add(s.time_frame(run, experiment, repeats.wants_eye()));
  set_times(row, repeats);
  row.cpu = s.machine.cpu, row.compiler = s.machine.compiler;
  row.opengl = gl_renderer_name(), row.tracer = s.tracer->engine();
  return row;
}

}  // namespace psm
