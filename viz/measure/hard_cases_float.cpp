// SPDX-License-Identifier: GPL-3.0-or-later
// Case 40, and the conventions behind all of them: what one narrowed matrix, or two in a row, cost on the graphics processor.
#include <algorithm>
#include <cmath>

#include "measure/hard_case_rows.h"

namespace psm {
namespace {

using glm::dvec3;

auto psm_builder(const MapScene& s) {
  return [s](auto t) { return map_from_world<decltype(t)>(s, MapTechnique::psm); };
}

/// 60 suns over the upper hemisphere, by golden angles.
std::vector<glm::dvec4> suns() {
  std::vector<glm::dvec4> lights;
  for (int i = 0; i < 60; ++i) {
    const double y = (i + 0.5) / 60, r = std::sqrt(1 - y * y), turn = 2.399963229728653 * i;
    lights.push_back({r * std::cos(turn), y, r * std::sin(turn), 0});
  }
  return lights;
}

/// A scene and where its receivers belong on the map, each coordinate rounded once.
struct Reference {
  MapScene scene;
  std::vector<double> w;
  std::vector<dvec3> points;
};

Reference reference(const MapScene& s) {
  Reference r{s, {}, {}};
  const auto map = map_from_world<Wide<100>>(s, MapTechnique::psm);
  for (const dvec3& x : s.receivers) {
    const Vec4<Wide<100>> q = map * Vec4<Wide<100>>(Vec3<Wide<100>>(x), 1);
    r.w.push_back(double(q.w));
    r.points.push_back(dvec3(Vec3<Wide<100>>(q) / q.w));
  }
  return r;
}

/// Largest relative error of w on the receivers, with w scaled to agree where it is largest; and the error on the map.
template <class T>
CaseAnswer w_error(const Reference& r, FloatPath path) {
  const MapScene& s = r.scene;
  const glm::dmat4 map = map_from_world<double>(s, MapTechnique::psm);
  std::vector<glm::dvec4> here;
  if constexpr (std::is_same_v<T, float>)
    for (const glm::vec4& q : float_clip_points(map, s, s.receivers, path)) here.push_back(q);
  else
    for (const dvec3& x : s.receivers) here.push_back(map * glm::dvec4(x, 1));
  const std::size_t largest = std::max_element(r.w.begin(), r.w.end()) - r.w.begin();
  const double scale = here[largest].w / r.w[largest];
  std::vector<dvec3> points;
  double worst = 0;
  for (std::size_t i = 0; i < here.size(); ++i) {
    worst = std::max(worst, std::abs(here[i].w / r.w[i] / scale - 1));
    points.push_back(dvec3(here[i]) / here[i].w);
  }
  return answer(worst, texel_distance(points, r.points));
}

/// Over all suns.
void add_path(Rows& rows, const char* name, const char* computed, const std::vector<Reference>& references, FloatPath path,
              Form form) {
  // Rows of the view matrix are rounded once; f / n = 1e7 roundings of double is what is left of w at the near distance.
  HardCase& row = rows.error_at_most(0, name, computed, 1e-6, 1e-2, [=](auto t) {
    CaseAnswer worst = answer(0, 0);
    for (const Reference& r : references) {
      const CaseAnswer a = w_error<decltype(t)>(r, path);
      worst.value = std::max(worst.value, a.value);
      worst.texels = std::max(worst.texels, a.texels);
    }
    return worst;
  });
  row.form = form;
}

void add_two_stages(Rows& rows) {
  std::vector<Reference> references;
  for (const glm::dvec4& light : suns()) {
    MapScene s;
    s.eye = dvec3(0), s.forward = {0.36, -0.48, -0.8}, s.near = 0.01, s.far = 1e5, s.light = light;
    references.push_back(reference(frustum_scene(s)));
  }
  const char* name = "n = 0.01, f = 1e5, eye at the origin, 60 suns";
  add_path(rows, name, "error of w, one composed matrix, world positions", references, FloatPath::world, Form::ours);
  add_path(rows, name, "error of w, two matrices by way of view space", references, FloatPath::world_through_view, Form::naive);
  add_path(rows, name, "error of w, two matrices by way of clip space", references, FloatPath::world_through_clip, Form::naive);
  // Floats around the middle of a scene of 1e5 are 0.004 apart: nothing at 0.01 from the eye survives, in the image neither.
  add_path(rows, name, "error of w, composed, positions around the scene's middle (as uploaded)", references, FloatPath::composed,
           Form::ours);
}

/// As case 13's camera, moved away from the world's origin.
MapScene away_by(double distance) {
  MapScene s;
  s.eye += dvec3(distance, 0, distance);
  return frustum_scene(s);
}

void add_far_from_the_origin(Rows& rows) {
  for (const double distance : {2000.0, 6.4e6}) {
    const MapScene s = away_by(distance);
    const char* name = distance == 2000 ? "2,000 from the origin" : "6,400,000 from the origin";
    // Positions of double are 1e-9 apart at 6.4e6, the frustum is 1.2 wide at the near distance.
    rows.map(40, name, "u, PSM, positions around the scene's middle (as uploaded)", s, distance == 2000 ? 1e-8 : 1e-3,
             psm_builder(s));
    const auto exact = Rows::exact_map(s, psm_builder(s));
    HardCase& row = rows.map_against(40, name, "u, PSM, positions in world space", s, distance == 2000 ? 1e-8 : 1e-3, exact,
                                     psm_builder(s), FloatPath::world);
    Rows::naive(row);
  }
}

}  // namespace

void add_float_cases(Rows& rows) {
  add_two_stages(rows);
  add_far_from_the_origin(rows);
}

}  // namespace psm
