// SPDX-License-Identifier: GPL-3.0-or-later
// Cases 11, 33, 34, 36 and 38: light vectors, depth conventions, bases and angles.
#include <cmath>

#include "measure/hard_case_maps.h"
#include "scene/experiment.h"

namespace psm {
namespace {

void add_light_vectors(Rows& rows) {
  for (const double scale : {1e-30, 1e30}) {
    const char* name = scale < 1 ? "light vector times 1e-30" : "light vector times 1e30";
    const auto length = [scale](auto t, auto normalize) {
      using T = decltype(t);
      return glm::length(normalize(Vec3<T>(given(T(0.48 * scale)), T(0.6 * scale), T(-0.64 * scale))) -
                         Vec3<T>(T(0.48), T(0.6), T(-0.64)));
    };
    rows.at_most(11, name, "|change of the unit vector|, safe_normalize", 1e-15, 1e-6,
                 [length](auto t) { return length(t, [](const auto& v) { return safe_normalize(v); }); });
    Rows::naive(rows.at_most(11, name, "the same by v / sqrt(v.v)", 1e-15, 1e-6,
                             [length](auto t) { return length(t, [](const auto& v) { return glm::normalize(v); }); }));
  }
  rows.analysis(11, "light vector 0", "check_field of light.to_light", Demand::refused,
                [] {
                  Experiment x;
                  x.light.to_light = glm::dvec3(0);
                  const auto error = check_field(*find_field("light.to_light"), x);
                  return error && error->text.find("light.to_light") == 0 ? named("light.to_light") : answer(0);
                })
      .reason = "light.to_light";
}

void add_depth_conventions(Rows& rows) {
  const MapScene s = lit_by({0.1, 1, -0.4, 0}), opposite = lit_by({-0.1, -1, 0.4, 0});
  rows.map_at_most(33, "l -> -l", "|u|, v less those of l, texels", kDoubleTexels, kVisibleTexels, [=](auto t, FloatPath path) {
    using T = decltype(t);
    auto a = map_points<T>(map_builder(s, MapTechnique::psm), s, s.receivers, path),
         b = map_points<T>(map_builder(opposite, MapTechnique::psm), opposite, s.receivers, path);
    for (auto& p : b) p.x = -p.x;  // the map is seen from its other side
    const double d = texel_distance(a, b);
    return answer(d, d);
  });
  rows.at_most(33, "l -> -l", "product of the depth steps along a ray: order flipped", -1e-9, -1e-9, [=](auto t) {
    using T = decltype(t);
    const glm::dvec3 x = s.receivers.back();
    const std::vector<glm::dvec3> ray{x, x + glm::dvec3(s.light)};
    const auto a = map_points<T>(map_builder(s, MapTechnique::psm), s, ray),
               b = map_points<T>(map_builder(opposite, MapTechnique::psm), opposite, ray);
    return (a[1].z - a[0].z) * (b[1].z - b[0].z);
  });
  // z' = (z + w) / 2 and its reverse, and the clip matrix undone to the symmetric cube before the aim is taken.
  const auto depth_row = [](auto t, int convention) {
    using T = decltype(t);
    Mat4<T> m(1);
    if (convention == 0) m[2][2] = T(0.5), m[3][2] = T(0.5);   // D3D: 0 near, 1 far
    if (convention == 1) m[2][2] = T(-0.5), m[3][2] = T(0.5);  // reversed: 1 near, 0 far
    return m;
  };
  for (const int convention : {0, 1}) {
    const char* name = convention == 0 ? "D3D depth" : "reversed depth";
    rows.equals(34, name, "z / w of the infinity plane", convention == 0 ? exactly(100, 99) : exactly(-1, 99), 1e-13,
                [=](auto t) {
                  using T = decltype(t);
                  const Vec4<T> L = depth_row(t, convention) * clip_from_world<T>(s) * unit_light<T>(s);
                  return L.z / L.w;
                });
    // The map of the GL cube is what both must match.
    const auto of_cube = [=](auto t, bool symmetric) {
      using T = decltype(t);
      const Mat4<T> depth = depth_row(t, convention);
      const Mat4<T> clip = (symmetric ? glm::inverse(depth) : Mat4<T>(1)) * depth * clip_from_world<T>(s);
      const auto receivers = points_in<T>(s.receivers);
      return fit_map<T>(frame_of<T>(s), psm_plane<T>(clip, unit_light<T>(s), receivers).plane, receivers, receivers)
          .map_from_world;
    };
    const auto exact = Rows::exact_map(s, map_builder(s, MapTechnique::psm));
    rows.map_against(34, name, "u, PSM in the symmetric cube", s, kDoubleTexels, exact, [=](auto t) { return of_cube(t, true); });
    Rows::naive(rows.map_against(34, name, "u, looking at the origin of that cube: another plane", s, kDoubleTexels, exact,
                                 [=](auto t) { return of_cube(t, false); }));
  }
}

/// The largest move of the map while the light turns through +Y (or -Y) by 1e-7.
template <class T>
CaseAnswer jump_at_pole(double y, FloatPath path) {
  CaseAnswer worst = answer(0, 0);
  for (const glm::dvec2 side : {glm::dvec2(1e-7, 0), glm::dvec2(0, 1e-7), glm::dvec2(1e-7, 1e-7)}) {
    const CaseAnswer j = jump<T>(lit_by({side.x, y, side.y, 0}), lit_by({-side.x, y, -side.y, 0}), path);
    if (!(j.texels <= worst.texels)) worst = j;
  }
  return worst;
}

void add_bases(Rows& rows) {
  rows.map_at_most(36, "light through +Y", "jump of the map, texels, PSM", 2e-2, kFlicker,
                   [](auto t, FloatPath path) { return jump_at_pole<decltype(t)>(1, path); });
  rows.map_at_most(36, "light through -Y", "jump of the map, texels, PSM", 2e-2, kFlicker,
                   [](auto t, FloatPath path) { return jump_at_pole<decltype(t)>(-1, path); });
  // A window must turn somewhere: psmlab's follows the view direction as the light sees it, so it turns where the two are
  // parallel. There the map is uniform: its texels keep their size, but their grid turns.
  rows.map_at_most(36, "light through the view direction by 1e-7", "jump of the map, texels, PSM", 2e-2, kFlicker,
                   [](auto t, FloatPath path) {
                     using T = decltype(t);
                     return jump<T>(lit_by({1e-7, 0, 1, 0}), lit_by({0, 1e-7, 1, 0}), path);
                   })
      .known_limit = true;
  Rows::naive(rows.at_most(36, "light through +Y, up = +Y fixed", "turn of the light's x axis, degrees", 1, 1, [](auto t) {
    using T = decltype(t);
    const auto x_axis = [](T x) { return row(glm::lookAtRH(Vec3<T>(given(x), 1, 0), Vec3<T>(0), Vec3<T>(0, 1, 0)), 0); };
    const Vec3<T> a(x_axis(T(1e-7))), b(x_axis(T(-1e-7)));
    return atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * degrees<T>();
  }));
}

/// Some unit vectors whose dot product with themselves rounds to more than 1, among 1,000.
template <class T>
std::vector<Vec3<T>> unit_vectors() {
  std::vector<Vec3<T>> v;
  for (int i = 0; i < 1000; ++i)
    v.push_back(glm::normalize(Vec3<T>(T(i % 10) - T(4.3), T(i / 10 % 10) - T(5.1), T(i / 100) + T(0.7))));
  return v;
}

void add_angles(Rows& rows) {
  rows.equals(38, "|dot| > 1 by rounding", "angles between a unit vector and itself that are no number", exactly(0), 0,
              [](auto t) {
                int bad = 0;
                for (const auto& v : unit_vectors<decltype(t)>()) bad += isnan(line_angle(v, v));
                return bad;
              });
  Rows::naive(rows.equals(38, "|dot| > 1 by rounding", "the same by acos, of 1,000", exactly(0), 0, [](auto t) {
    int bad = 0;
    for (const auto& v : unit_vectors<decltype(t)>()) bad += isnan(acos(glm::dot(v, v)));
    return bad;
  }));
  const Wide<100> a = Wide<100>(1) / Wide<100>(100) * half_turn<Wide<100>>() / Wide<100>(180);
  const glm::dvec2 turned(double(sin(a)), double(cos(a)));
  const auto vectors = [turned](auto t) {
    using T = decltype(t);
    const Vec3<T> v(0, given(T(0.6)), T(-0.8)), l(T(turned.x), T(0.6 * turned.y), T(-0.8 * turned.y));
    return std::pair(v, l);
  };
  // The vectors' own roundings turn them by 1e-16 rad, of 1.7e-4.
  rows.equals(38, "theta = 0.01 deg", "theta by atan2, degrees", exactly(1, 100), 1e-11,
              [=](auto t) {
                const auto [v, l] = vectors(t);
                return line_angle(v, l) * degrees<decltype(t)>();
              })
      .float_bound = 1e-2;
  Rows::naive(rows.equals(38, "theta = 0.01 deg", "theta by acos, degrees", exactly(1, 100), 1e-11, [=](auto t) {
    const auto [v, l] = vectors(t);
    return acos(std::min(glm::dot(v, l), decltype(t)(1))) * degrees<decltype(t)>();
  }));
}

}  // namespace

void add_convention_cases(Rows& rows) {
  add_light_vectors(rows);
  add_depth_conventions(rows);
  add_bases(rows);
  add_angles(rows);
}

}  // namespace psm
