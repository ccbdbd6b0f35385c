// SPDX-License-Identifier: GPL-3.0-or-later
// H by every way on the same 1,000 random and 60 degenerate cases: medians of time beside errors, in one run.
//   body_bench [--benchmark_filter=...]
#include <CGAL/assertions.h>
#include <CGAL/assertions_behaviour.h>
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "../geom/exact_oracle.h"
#include "ways.h"

namespace psm {
namespace {

/// What is exact about H: by trying all triples of planes, independent of every way.
struct Truth {
  std::vector<glm::dvec3> vertices;
  std::vector<int> facet_sizes;
  double volume = 0, size = 0;
};

Truth truth_of(const BodyCase& c) {
  const CasePlanes p = planes_of(c);
  std::vector<Plane> planes = p.scene.planes;
  planes.insert(planes.end(), p.caster.begin(), p.caster.end());
  const OracleBody oracle = exact_intersection(planes);
  Truth t{oracle.vertices, {}, exact_volume(caster_body_of(p)), 0};
  std::map<int, int> sizes;
  for (const auto& facets : oracle.vertex_facets)
    for (const int f : facets) ++sizes[f];
  for (const auto& [facet, size] : sizes) t.facet_sizes.push_back(size);
  std::sort(t.facet_sizes.begin(), t.facet_sizes.end());
  for (const auto& v : t.vertices) t.size = std::max(t.size, glm::length(v - t.vertices[0]));
  return t;
}

struct Set {
  const char* name;
  std::vector<BodyCase> cases;
  std::vector<Truth> truths;
};

std::vector<Set>& sets() {
  static std::vector<Set> all = [] {
    std::vector<Set> s{{"random", random_cases(1000, 1), {}}, {"degenerate", degenerate_cases(), {}}};
    for (Set& set : s)
      for (const BodyCase& c : set.cases) set.truths.push_back(truth_of(c));
    return s;
  }();
  return all;
}

double farthest(const std::vector<glm::dvec3>& a, const std::vector<glm::dvec3>& b) {
  double largest = 0;
  for (const auto& p : a) {
    double nearest = INFINITY;
    for (const auto& q : b) nearest = std::min(nearest, glm::length(p - q));
    largest = std::max(largest, nearest);
  }
  return largest;
}

struct Errors {
  int equal = 0, failed = 0;
  double vertex = 0, volume = 0;  // largest among the cases of equal topology: relative to the body's diameter, to its volume

  void add(WayBody body, const Truth& t) {
    std::sort(body.facet_sizes.begin(), body.facet_sizes.end());
    failed += body.failed;
    if (body.failed || body.vertices.size() != t.vertices.size() || body.facet_sizes != t.facet_sizes) return;
    ++equal;
    if (t.size > 0)
      vertex = std::max(vertex, std::max(farthest(body.vertices, t.vertices), farthest(t.vertices, body.vertices)) / t.size);
    if (t.volume > 0) volume = std::max(volume, std::abs(body.volume - t.volume) / t.volume);
  }
};

double median(std::vector<double> v) {
  std::nth_element(v.begin(), v.begin() + v.size() / 2, v.end());
  return v[v.size() / 2];
}

struct Row {
  std::string way, set;
  double median_us, p95_us;
  Errors errors;
  std::size_t cases;
};
std::vector<Row>& rows() {
  static std::vector<Row> all;
  return all;
}

/// Iteration i computes case i modulo their number. Each case's time is its median over the rounds.
void run(benchmark::State& state, const char* name, Way way, const Set& set) {
  const std::size_t n = set.cases.size();
  std::vector<std::vector<double>> times(n);
  std::size_t i = 0;
  for (auto _ : state) {
    const auto start = std::chrono::steady_clock::now();
    WayBody body = way(set.cases[i]);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    benchmark::DoNotOptimize(body.vertices.data());
    state.SetIterationTime(spent.count());
    times[i].push_back(spent.count() * 1e6);
    i = (i + 1) % n;
  }
  std::vector<double> medians;
  for (const auto& t : times) medians.push_back(median(t));
  Row row{name, set.name, median(medians), 0, {}, n};
  std::sort(medians.begin(), medians.end());
  row.p95_us = medians[medians.size() * 95 / 100];
  for (std::size_t k = 0; k < n; ++k) row.errors.add(way(set.cases[k]), set.truths[k]);
  state.counters["median_us"] = row.median_us;
  state.counters["same_topology"] = row.errors.equal;
  rows().push_back(row);
}

void print_machine() {
  std::ifstream info("/proc/cpuinfo");
  std::string line;
  while (std::getline(info, line))
    if (line.rfind("model name", 0) == 0) {
      std::printf("\nMachine: %s", line.substr(line.find(':') + 2).c_str());
      break;
    }
  std::ifstream load("/proc/loadavg");
  std::getline(load, line);
  std::printf("; load average %s; compiler %s\n", line.substr(0, line.find(' ')).c_str(), __VERSION__);
}

void print_table() {
  print_machine();
  std::printf(
      "H = hull(V + l) ∩ S ∩ L. Time of a case: median over its rounds. Errors: largest over the cases with the exact topology;\n"
      "of a vertex relative to the body's diameter, of the volume relative to itself.\n\n");
  std::printf("| %-28s | %-10s | median µs | 95 %% µs | exact topology | gave up | vertex error | volume error |\n", "way",
              "cases");
  std::printf("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const Row& r : rows())
    std::printf("| %-28s | %-10s | %9.2f | %7.2f | %6d of %4zu | %7d | %12.1e | %12.1e |\n", r.way.c_str(), r.set.c_str(),
                r.median_us, r.p95_us, r.errors.equal, r.cases, r.errors.failed, r.errors.vertex, r.errors.volume);
}

}  // namespace
}  // namespace psm

int main(int argc, char** argv) {
  CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
  CGAL::set_warning_behaviour(CGAL::CONTINUE);
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});  // counted, not printed
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  const std::tuple<const char*, psm::Way, int> ways[] = {{"viz/geom (exact)", psm::way_exact, 51},
                                                         {"double clipper", psm::way_double_clipper, 51},
                                                         {"CGAL EPICK half-spaces", psm::way_epick_halfspaces, 5},
                                                         {"CGAL EPECK half-spaces", psm::way_epeck_halfspaces, 3},
                                                         {"CGAL Nef polyhedra", psm::way_nef, 1}};
  for (const psm::Set& set : psm::sets())
    for (const auto& [name, way, rounds] : ways)
      benchmark::RegisterBenchmark((std::string(name) + ", " + set.name).c_str(),
                                   [name = name, way = way, &set](benchmark::State& s) { psm::run(s, name, way, set); })
          ->UseManualTime()
          ->Unit(benchmark::kMicrosecond)
          ->Iterations(set.cases.size() * rounds);
  benchmark::RunSpecifiedBenchmarks();
  psm::print_table();
  return 0;
}
