// SPDX-License-Identifier: GPL-3.0-or-later
// The truth pass (what the eye sees, and whether it is lit) beside bare Embree loops over the same rays and triangles in the same
// run, and the statistics of texels. One row a scene, engine and pass; each pass once a frame of 640 x 360.
#include <benchmark/benchmark.h>
#include <embree3/rtcore.h>

#include <array>
#include <limits>
#include <thread>

#include "measure/parallel_rows.h"
#include "measure/shadow_error.h"
#include "scene/eye_and_light.h"

namespace {

using namespace psm;
constexpr int kWidth = 640, kHeight = 360;

struct Setting {
  Scene scene;
  Experiment experiment;
  explicit Setting(const char* id) : scene(*builtin_scene(id)) {
    experiment.camera = *scene.camera;
    experiment.light = *scene.light;
  }
};

const Setting& setting(int index) {
  static const Setting all[] = {Setting("chessboard"), Setting("ground")};
  return all[index];
}

/// Embree as one would write it down: floats in world space, no robust flag, no filter, no doubles.
class Bare {
 public:
  explicit Bare(const Scene& scene) : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
    for (const Mesh& mesh : scene.meshes) add(mesh);
    rtcCommitScene(scene_);
  }
  ~Bare() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  Bare(const Bare&) = delete;
  Bare& operator=(const Bare&) = delete;

  /// Distance; infinite where nothing is met.
  float nearest(const glm::vec3& origin, const glm::vec3& direction, float from, float to) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    RTCRayHit hit{};
    hit.ray = ray(origin, direction, from, to);
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &context, &hit);
    return hit.hit.geomID == RTC_INVALID_GEOMETRY_ID ? std::numeric_limits<float>::infinity() : hit.ray.tfar;
  }
  bool blocked(const glm::vec3& origin, const glm::vec3& direction, float from, float to) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    RTCRay r = ray(origin, direction, from, to);
    rtcOccluded1(scene_, &context, &r);
    return r.tfar < 0;
  }

 private:
  static RTCRay ray(const glm::vec3& o, const glm::vec3& d, float from, float to) {
    RTCRay r{};
    r.org_x = o.x, r.org_y = o.y, r.org_z = o.z;
    r.dir_x = d.x, r.dir_y = d.y, r.dir_z = d.z;
    r.tnear = from, r.tfar = to;
    r.mask = ~0u;
    return r;
  }
  void add(const Mesh& mesh) {
    if (mesh.triangles.empty()) return;
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertex = static_cast<std::array<float, 3>*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, mesh.positions.size()));
    for (const glm::dvec3& p : mesh.positions) *vertex++ = {float(p.x), float(p.y), float(p.z)};
    auto* index = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.triangles.size() / 3));
    std::copy(mesh.triangles.begin(), mesh.triangles.end(), index);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
  }

  RTCDevice device_;
  RTCScene scene_;
};

void report_rays(benchmark::State& state, std::size_t rays) {
  state.counters["Mrays/s"] = benchmark::Counter(double(rays) * 1e-6, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["threads"] = double(std::thread::hardware_concurrency());
  state.counters["triangles"] = double(setting(int(state.range(0))).scene.triangle_count());
}

/// Pixels that face the light: one shadow ray each.
std::size_t shadow_rays(const std::vector<Lit>& truth) {
  return std::size_t(std::count(truth.begin(), truth.end(), Lit::lit) + std::count(truth.begin(), truth.end(), Lit::dark));
}

struct Frame {
  RayTracer tracer;
  VisibleImage image;
  std::vector<Lit> truth;
  Frame(const Setting& s, RayTracer::Engine engine)
      : tracer(s.scene, engine),
        image(see(tracer, s.experiment, kWidth, kHeight)),
        truth(trace_light(tracer, image, s.experiment)) {}
};

void see_pass(benchmark::State& state, RayTracer::Engine engine) {
  const Setting& s = setting(int(state.range(0)));
  const RayTracer tracer(s.scene, engine);
  for (auto _ : state) benchmark::DoNotOptimize(see(tracer, s.experiment, kWidth, kHeight));
  report_rays(state, kWidth * kHeight);
}

void light_pass(benchmark::State& state, RayTracer::Engine engine) {
  const Setting& s = setting(int(state.range(0)));
  const Frame frame(s, engine);
  for (auto _ : state) benchmark::DoNotOptimize(trace_light(frame.tracer, frame.image, s.experiment));
  report_rays(state, shadow_rays(frame.truth));
}

void bare_see(benchmark::State& state) {
  const Setting& s = setting(int(state.range(0)));
  const Bare bare(s.scene);
  const ViewFrame view = camera_frame(s.experiment);
  const glm::vec3 eye(view.eye);
  std::vector<float> depth(kWidth * kHeight);
  for (auto _ : state) {
    for_each_row(kHeight, [&](int row) {
      for (int column = 0; column < kWidth; ++column) {
        const glm::vec3 direction(view.at((2.0 * column + 1) / kWidth - 1, 1 - (2.0 * row + 1) / kHeight, 1) - view.eye);
        depth[std::size_t(row * kWidth + column)] =
            bare.nearest(eye, direction, float(s.experiment.camera.near), float(s.experiment.camera.far));
      }
    });
    benchmark::DoNotOptimize(depth.data());
  }
  report_rays(state, kWidth * kHeight);
}

void bare_light(benchmark::State& state) {
  const Setting& s = setting(int(state.range(0)));
  const Bare bare(s.scene);
  const Frame frame(s, RayTracer::default_engine());
  const glm::vec4 light(homogeneous_light(s.experiment.light));
  std::vector<char> dark(frame.truth.size());
  for (auto _ : state) {
    for_each_row(kHeight, [&](int row) {
      for (int column = 0; column < kWidth; ++column) {
        const auto i = std::size_t(row * kWidth + column);
        if (frame.truth[i] != Lit::lit && frame.truth[i] != Lit::dark) continue;
        const glm::vec3 at(frame.image.points[i].position);
        dark[i] = bare.blocked(at, glm::vec3(light) - light.w * at, 1e-4f,
                               light.w == 0 ? std::numeric_limits<float>::infinity() : 1.0f);
      }
    });
    benchmark::DoNotOptimize(dark.data());
  }
  report_rays(state, shadow_rays(frame.truth));
}

void texels(benchmark::State& state) {
  const Setting& s = setting(int(state.range(0)));
  const Frame frame(s, RayTracer::default_engine());
  const Analysis analysis = analyze(s.experiment, s.scene);
  for (auto _ : state) benchmark::DoNotOptimize(texel_statistics(texel_sizes(frame.image, analysis)));
  state.counters["Mpixels/s"] =
      benchmark::Counter(double(shadow_rays(frame.truth)) * 1e-6, benchmark::Counter::kIsIterationInvariantRate);
}

void coarse_points(benchmark::State& state) {
  const Setting& s = setting(int(state.range(0)));
  const RayTracer tracer(s.scene);
  for (auto _ : state) benchmark::DoNotOptimize(visible_points(tracer, s.experiment));
}

#define PSM_BENCH(call) \
  call->ArgName("scene")->Arg(0)->Arg(1)->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond)
PSM_BENCH(BENCHMARK(bare_see));
PSM_BENCH(BENCHMARK_CAPTURE(see_pass, Embree, RayTracer::Engine::embree));
PSM_BENCH(BENCHMARK_CAPTURE(see_pass, CGAL, RayTracer::Engine::cgal));
PSM_BENCH(BENCHMARK(bare_light));
PSM_BENCH(BENCHMARK_CAPTURE(light_pass, Embree, RayTracer::Engine::embree));
PSM_BENCH(BENCHMARK_CAPTURE(light_pass, CGAL, RayTracer::Engine::cgal));
PSM_BENCH(BENCHMARK(texels));
PSM_BENCH(BENCHMARK(coarse_points));

}  // namespace

BENCHMARK_MAIN();
