// SPDX-License-Identifier: GPL-3.0-or-later
// analyze() without texel statistics: every technique on every built-in scene, with its own camera and light; then S in its
// three grains. Without visible points, so it includes the estimate of m over stand-in surfaces.
//   analyze_bench [--benchmark_repetitions=9 --benchmark_report_aggregates_only=true]
#include <benchmark/benchmark.h>

#include "scene/analysis.h"

namespace psm {
namespace {

void measure(benchmark::State& state, const Experiment& experiment, const Scene& scene) {
  for (auto _ : state) benchmark::DoNotOptimize(analyze(experiment, scene));
}

void add(const std::string& name, const Experiment& experiment, const Scene& scene) {
  benchmark::RegisterBenchmark(name.c_str(), [experiment, &scene](benchmark::State& s) {
    measure(s, experiment, scene);
  })->Unit(benchmark::kMicrosecond);
}

void add_scene(const Scene& scene) {
  Experiment x;
  x.scene.source = scene.id;
  if (scene.camera) x.camera = *scene.camera;
  if (scene.light) x.light = *scene.light;
  for (const std::string& technique : technique_names()) {
    x.shadow.technique = *technique_from_name(technique);
    add(scene.id + ", " + technique, x, scene);
  }
  x.shadow.technique = Technique::uniform;
  for (const auto& [name, grain] : {std::pair{"hull", SceneBody::hull}, {"auto", SceneBody::automatic}}) {
    x.shadow.scene_body = grain;
    add(scene.id + ", uniform, S " + name, x, scene);
  }
}

}  // namespace
}  // namespace psm

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  std::vector<psm::Scene> scenes;
  for (const std::string& id : psm::builtin_scene_ids()) scenes.push_back(*psm::builtin_scene(id));
  for (const psm::Scene& scene : scenes) psm::add_scene(scene);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
