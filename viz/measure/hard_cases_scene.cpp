// SPDX-License-Identifier: GPL-3.0-or-later
// Cases 21 to 24, 27 to 30, 39, 42, and parts of 7, 17, 37: bodies and whole analyses.
#include <cmath>

#include "math/psm_variants.h"
#include "math/texel_footprint.h"
#include "measure/hard_case_maps.h"
#include "scene/analysis.h"

namespace psm {
namespace {

using glm::dvec3, glm::dvec4;

Scene room() { return box_scene({-4, 0, -5}, {4, 3, 5}); }

Experiment standing(Technique technique = Technique::psm) {
  Experiment x;
  x.camera = {{0, 1.7, 0}, {0, 1.7, -1}, {0, 1, 0}, 60, 0.1, 100};
  x.image = {1024, 1024};
  x.shadow.technique = technique;
  return x;
}

Experiment point_lit(dvec3 position, Technique technique = Technique::psm) {
  Experiment x = standing(technique);
  x.light.type = LightType::point;
  x.light.position = position;
  return x;
}

bool has_note(const Analysis& a, const char* code) {
  return std::any_of(a.notes.begin(), a.notes.end(), [&](const Note& n) { return n.code == code; });
}

CaseAnswer name_if_noted(const Analysis& a, const char* code) { return has_note(a, code) ? named(code) : answer(0); }

int not_finite(const Analysis& a) {
  int bad = 0;
  for (int i = 0; i < 16; ++i) bad += a.map_from_world && !std::isfinite((*a.map_from_world)[i / 4][i % 4]);
  return bad;
}

/// Smallest w of the map on the receivers over the largest.
template <class T>
CaseAnswer smallest_w(const Analysis& a) {
  Range<double> w;
  const std::vector<dvec3>& points = a.receivers_body.vertices;
  if constexpr (std::is_same_v<T, float>)
    for (const glm::vec4& q : float_clip_points(*a.map_from_world, {}, points, FloatPath::composed)) w.add(q.w);
  else
    for (const dvec3& x : points) w.add((*a.map_from_world * dvec4(x, 1)).w);
  return answer(w.min / w.max);
}

/// A row that an analysis answers, in float as the graphics processor sees its matrix.
template <class F>
HardCase& analysis_row(Rows& rows, int number, const char* name, const char* computed, Demand demand, double bound, F f) {
  HardCase& row = rows.analysis(number, name, computed, demand, f);
  row.double_bound = row.float_bound = bound;
  return row;
}

/// The note `reason` must stand in the analysis; with Demand::refused there is no single map either.
HardCase& notes(Rows& rows, int number, const char* name, const char* computed, Demand demand, const char* reason,
                const Experiment& x, const Scene& scene) {
  HardCase& row = rows.analysis(number, name, computed, demand, [=] {
    const Analysis a = analyze(x, scene);
    return demand == Demand::refused && a.map_from_world ? answer(1) : name_if_noted(a, reason);
  });
  row.reason = reason;
  return row;
}

void add_lights_in_the_scene(Rows& rows) {
  rows.equals(21, "point 3 behind the eye, H shifted in front", "w after the shift = n", exactly(1), 1e-15, [](auto t) {
    using T = decltype(t);
    const std::vector<T> depths{T(-3), T(-1), T(4)};  // the light and two vertices of H
    return T(-3) + shift_in_front<T>(depths, T(1));
  });
  analysis_row(rows, 21, "point 3 behind the eye, inside S", "w after psm_divided's own shift; below 0 if its depth is reversed",
               Demand::above, 0, [scene = room(), x = point_lit({0, 1, 3}, Technique::psm_divided)] {
                 const Analysis a = analyze(x, scene);
                 return a.reversed_depth ? -1.0 : a.light_case.w + a.camera_shift;
               });
  notes(rows, 22, "point inside R", "a single map", Demand::refused, "light_inside_receivers", point_lit({0, 1, -3}), room());
  analysis_row(rows, 22, "point inside V, outside R", "smallest w on R over the largest, single map", Demand::above, 0,
               [scene = room(), x = point_lit({0, 3.2, -4.5})] {
                 const Analysis a = analyze(x, scene);
                 return a.map_from_world && a.light_case.inside_frustum ? smallest_w<double>(a) : answer(-1);
               });
  notes(rows, 23, "light on a face of R", "a single map", Demand::refused, "light_inside_receivers", point_lit({0, 0, -3}),
        room());
  rows.at_most(23, "light on a face of R", "cosine of the half angle of the cone around R, not above 0", 1e-15, 1e-6, [](auto t) {
    using T = decltype(t);
    std::vector<Vec3<T>> d;
    for (int i = 0; i < 8; ++i) d.push_back(safe_normalize(Vec3<T>(T(i & 1 ? 4 : -3), T(i & 2 ? 3 : 0), T(i & 4 ? 2 : -5))));
    return smallest_enclosing_cone<T>(d).cosine;
  });
  Experiment spot = standing();
  spot.light.type = LightType::spot;
  spot.light.position = {0, 1, -3}, spot.light.target = {0, 0, -4};
  HardCase& row = analysis_row(rows, 24, "spot inside the frustum", "smallest w on its cone's part of R over the largest",
                               Demand::above, 0, [=, scene = room()] { return smallest_w<double>(analyze(spot, scene)); });
  row.in_float = [=, scene = room()] { return smallest_w<float>(analyze(spot, scene)); };
}

void add_degenerate_bodies(Rows& rows) {
  Experiment away = standing();
  away.camera.target = {0, 50, -1};
  Experiment outside = away;
  outside.camera.position = {0, 20, 0};
  notes(rows, 27, "R empty: the eye looks away", "note of the analysis", Demand::said, "nothing_visible", outside, room());
  analysis_row(rows, 27, "R empty: the eye looks away", "entries of the map that are not finite", Demand::at_most, 0,
               [=, scene = room()] { return not_finite(analyze(outside, scene)); });
  Experiment grazing = standing();
  grazing.light.to_light = {1, 0, 0};
  const Scene flat = box_scene({-5, 0, -9}, {5, 0, 0});
  notes(rows, 28, "flat scene, light in its plane", "note of the analysis", Demand::said, "window_padded", grazing, flat);
  analysis_row(rows, 28, "flat scene, light in its plane", "entries of the map that are not finite", Demand::at_most, 0,
               [=] { return not_finite(analyze(grazing, flat)); });
  analysis_row(rows, 28, "flat scene, light above", "smallest w on R over the largest", Demand::above, 0,
               [=] { return smallest_w<double>(analyze(standing(), flat)); });
  Experiment infinite = standing();
  infinite.camera.far = std::numeric_limits<double>::infinity();
  analysis_row(rows, 17, "f = infinity, PSM", "entries of the map that are not finite", Demand::at_most, 0,
               [=, scene = room()] { return not_finite(analyze(infinite, scene)); });
  Experiment deep = standing(Technique::gmnpr);
  deep.camera.near = 1, deep.camera.far = 800;
  deep.light.to_light = {0, std::sin(20 / kDegrees), -std::cos(20 / kDegrees)};
  notes(rows, 7, "f = 800, theta = 20 deg", "note of the analysis", Demand::said, "worse_than_uniform", deep,
        box_scene({-1000, -1, -1000}, {1000, 1.6, 1000}));
  analysis_row(rows, 37, "eye inside the scene, LiSPSM", "smallest depth of R in an analysis", Demand::above, 0,
               [scene = room(), x = standing(Technique::lispsm_reference)] { return *analyze(x, scene).near; });
  rows.equals(39, "5 of 8 points rejected", "lower end of the range of those at 5, 6, 7", exactly(5), 0, [](auto t) {
    using T = decltype(t);
    Range<T> range;
    for (int i = 0; i < 8; ++i)
      if (given(i) >= 5) range.add(T(i));
    return range.min;
  });
  Rows::naive(
      rows.equals(39, "5 of 8 points rejected", "the same where they stay in an array of zeros", exactly(5), 0, [](auto t) {
        using T = decltype(t);
        T kept[8] = {};
        for (int i = 5; i < 8; ++i) kept[i] = given(T(i));
        return *std::min_element(kept, kept + 8);
      }));
}

template <class T>
T tan_phi_effective(T light_x, T light_y, T tan_x, T tan_y) {
  return (abs(light_x) * tan_x + abs(light_y) * tan_y) / hypot(light_x, light_y);
}

void add_angles_and_footprints(Rows& rows) {
  const Exact root_2 = in_digits([](auto t) { return sqrt(decltype(t)(2)); });
  rows.equals(29, "square frustum, diagonal light", "tan(phi_eff) / tan(phi)", root_2, 1e-15,
              [](auto t) { return tan_phi_effective<decltype(t)>(given(decltype(t)(1)), 1, 1, 1); });
  HardCase& row =
      rows.analysis(29, "square frustum, diagonal light", "the same in an analysis", Demand::equals, [scene = room()] {
        Experiment x = standing(Technique::gmnpr);
        x.light.to_light = {1, 1, -0.5};
        return std::tan(*analyze(x, scene).phi) / std::tan(30 / kDegrees);
      });
  row.exact = root_2;
  row.double_bound = 1e-14;
  const Exact inf{std::numeric_limits<double>::infinity(), ExactKind::rational};
  const auto m_of = [](auto t, dvec4 light, dvec3 normal) {
    using T = decltype(t);
    MapScene s;
    s.light = light;
    s = frustum_scene(s);
    return texel_footprint<T>(clip_from_world<T>(s), map_from_world<T>(s, MapTechnique::uniform), Vec3<T>(0, 0, -8),
                              Vec3<T>(normal), 1024, 1024, 1024)
        .m;
  };
  rows.equals(30, "receiver contains the light ray, along an axis", "m, px", inf, 0, [=](auto t) {
    return m_of(t, {0, 1, 0, 0}, {0, 0, 1});
  });
  rows.above(30, "receiver contains the light ray, askew", "m, px: large, not NaN", 1e4,
             [=](auto t) {
               return m_of(t, {0.1, 1, -0.4, 0}, {0.0, 0.4, 1.0});
             })
      .exact = inf;
}

/// The room times a factor, seen and lit alike.
Analysis scaled_room(double factor) {
  Experiment x = standing();
  x.light.to_light = {0.3, 1, -0.4};
  for (dvec3* p : {&x.camera.position, &x.camera.target}) *p *= factor;
  x.camera.near *= factor, x.camera.far *= factor;
  const Scene s = room();
  return analyze(x, box_scene(s.bounds.min * factor, s.bounds.max * factor));
}

int bodies_that_differ(const Analysis& a, const Analysis& b) {
  int differ = 0;
  for (const auto body : {&Analysis::scene_body, &Analysis::receivers_body, &Analysis::caster_body, &Analysis::depth_body})
    differ += (a.*body).facets != (b.*body).facets || (a.*body).vertices.size() != (b.*body).vertices.size();
  return differ;
}

void add_scales(Rows& rows) {
  for (const double factor : {1e-4, 1e4}) {
    const char* name = factor < 1 ? "scene times 1e-4" : "scene times 1e4";
    HardCase& same = analysis_row(rows, 42, name, "of S, R, H, H_R: bodies with other facets than at scale 1", Demand::equals, 0,
                                  [=] { return bodies_that_differ(scaled_room(factor), scaled_room(1)); });
    same.exact = exactly(0);
    const auto difference = [=](auto t) {
      using T = decltype(t);
      const Analysis a = scaled_room(1), b = scaled_room(factor);
      std::vector<dvec3> scaled;
      for (const dvec3& x : a.receivers_body.vertices) scaled.push_back(x * factor);
      const auto map = [](const Analysis& of) { return [&of](auto u) { return Mat4<decltype(u)>(*of.map_from_world); }; };
      const double d = texel_distance(map_points<T>(map(a), {}, a.receivers_body.vertices), map_points<T>(map(b), {}, scaled));
      return answer(d, d);
    };
    HardCase& row = analysis_row(rows, 42, name, "the map less that at scale 1, texels", Demand::at_most, 0.5,
                                 [=] { return difference(double{}); });
    row.double_bound = kDoubleTexels;
    row.in_float = [=] { return difference(float{}); };
  }
}

}  // namespace

void add_scene_cases(Rows& rows) {
  add_lights_in_the_scene(rows);

  add_degenerate_bodies(rows);
  add_angles_and_footprints(rows);

  add_scales(rows);
}

}  // namespace psm
