// SPDX-License-Identifier: GPL-3.0-or-later
// Cases 13 to 20: lights before and after the eye's projection, and the maps that follow. The camera stands at
// (0, 1.7, 0), looks along -z, n = 1, f = 100, 60 degrees, square; the receivers fill its frustum.
#include <cmath>

#include "math/light_case.h"
#include "math/psm_variants.h"
#include "math/texel_footprint.h"
#include "measure/hard_case_maps.h"

namespace psm {
namespace {

template <class T>
int post_sign(const MapScene& s) {
  return classify_light(Vec4<T>(s.light), Vec3<T>(s.eye), safe_normalize(Vec3<T>(s.forward))).sign;
}

/// The receivers as a camera at the light's image L.xyz / L.w sees them, with an opening angle around the cube.
template <class T>
std::vector<Vec3<T>> divided_points(const MapScene& s) {
  const Mat4<T> clip = clip_from_world<T>(s);
  const Vec4<T> L = clip * unit_light<T>(s);
  const Vec3<T> eye = Vec3<T>(L) / L.w;
  const Mat4<T> view = look_along(eye, -eye, Vec3<T>(0, 0, 1));
  std::vector<Vec3<T>> out;
  for (const glm::dvec3& x : s.receivers) {
    const Vec4<T> q = clip * Vec4<T>(Vec3<T>(x), 1), v = view * Vec4<T>(Vec3<T>(q) / q.w, 1);
    out.push_back(glm::length(eye) / T(2) * Vec3<T>(v) / -v.z);  // the cube is about two wide
  }
  return out;
}

void add_lights_near_the_camera_plane(Rows& rows) {
  const MapScene parallel = lit_by({0.1, 1, 0, 0}), front = lit_by({0.1, 1, -1e-7, 0}), behind = lit_by({0.1, 1, 1e-7, 0});
  rows.map(13, "w = 0", "u, PSM", parallel, kDoubleTexels, map_builder(parallel, MapTechnique::psm));
  rows.map(13, "w = 1e-7", "u, PSM", front, kDoubleTexels, map_builder(front, MapTechnique::psm));
  rows.map(13, "w = -1e-7", "u, PSM", behind, kDoubleTexels, map_builder(behind, MapTechnique::psm));
  // u and v move by |dw| times the range of w, 100, times a small factor.
  rows.map_at_most(13, "w = -1e-7 to 1e-7", "jump of the map, texels, PSM", 1e-2, kFlicker,
                   [=](auto t, FloatPath path) { return jump<decltype(t)>(behind, front, path); });
  // The light's image is 1e7 cubes away: the divided form subtracts coordinates of that size.
  const auto exact = std::make_shared<std::vector<glm::dvec3>>(Rows::rounded(divided_points<Wide<100>>(front)));
  Rows::naive(
      rows.error_at_most(13, "w = 1e-7, L.xyz / L.w", "error of the light's lookAt, texels", 1e-3, kVisibleTexels, [=](auto t) {
        const double d = texel_distance(divided_points<decltype(t)>(front), *exact);
        return answer(d, d);
      }));

  MapScene in_plane;  // nothing axis-aligned, so that every dot product rounds
  in_plane.eye = {0.1, 1.7, 0.3}, in_plane.forward = {0.36, -0.48, -0.8};
  in_plane.light = glm::dvec4(in_plane.eye + glm::dvec3(0.8, 0.6, 0) * 3.0 + glm::dvec3(-0.48, 0.64, -0.6) * 20.0, 1);
  in_plane = frustum_scene(in_plane);
  // The position's own roundings leave it a little beside the plane: that is what the four roundings are for.
  HardCase& w =
      rows.equals(19, "point in the camera plane", "|w|, w = v.(l - e)", exactly(depth_of<Rational>(in_plane.light, in_plane)),
                  4 * epsilon<double>() * 21, [=](auto t) { return abs(depth_of<decltype(t)>(in_plane.light, in_plane)); });
  w.demand = Demand::at_most;
  w.float_bound = 4 * double(epsilon<float>()) * 21;  // |l - e| = 21
  rows.equals(19, "point in the camera plane", "sign of w within 4 roundings", exactly(0), 0,
              [=](auto t) { return post_sign<decltype(t)>(in_plane); });
  rows.at_most(19, "point in the camera plane", "depth of a point nearer to the light less that of its receiver", -1e-3, -1e-3,
               [=](auto t) {
                 using T = decltype(t);
                 const glm::dvec3 x = in_plane.receivers.back(), nearer = x + 0.1 * (glm::dvec3(in_plane.light) - x);
                 const auto z = map_points<T>(map_builder(in_plane, MapTechnique::psm), in_plane, {x, nearer});
                 return z[1].z - z[0].z;
               });
}

void add_points_near_the_camera_plane(Rows& rows) {
  const MapScene front = lit_by({6, 21.7, -1e-6, 1}), behind = lit_by({6, 21.7, 1e-6, 1});
  const auto sign = [](const Rational& w) { return double(w) > 0 ? 1 : double(w) < 0 ? -1 : 0; };
  const int signs = sign(depth_of<Rational>(front.light, front)) - sign(depth_of<Rational>(behind.light, behind));
  // 1e-6 at a distance of 20 is less than a rounding of float: there the light stands in the camera plane, both times.

  rows.equals(20, "point at depth 1e-6 and -1e-6", "difference of the signs of w", exactly(signs), 0, [=](auto t) {
    using T = decltype(t);
    return post_sign<T>(front) - post_sign<T>(behind);
  });
  rows.map_at_most(20, "point at depth 1e-6 and -1e-6", "jump of the map, texels, PSM", 1e-2, kFlicker,
                   [=](auto t, FloatPath path) { return jump<decltype(t)>(behind, front, path); });
}

/// m and anisotropy of every receiver, each with a normal of its own, in an image of 1280 x 720.
template <class T>
Range<T> footprints(const MapScene& s, T TexelFootprint<T>::*member) {
  const Mat4<T> clip = clip_from_world<T>(s), map = map_from_world<T>(s, MapTechnique::psm);
  Range<T> range;
  for (std::size_t i = 8; i < s.receivers.size(); ++i) {
    const Vec3<T> normal(T(0.2) * T(int(i % 5) - 2), T(1), T(0.3) * T(int(i % 3)));
    range.add(texel_footprint<T>(clip, map, Vec3<T>(s.receivers[i]), normal, 1280, 720, 1024).*member);
  }
  return range;
}

void add_lights_on_the_view_axis(Rows& rows) {
  const MapScene along = lit_by({0, 0, 1, 0}), at_eye = lit_by({0, 1.7, 0, 1});
  rows.map_at_most(14, "light parallel to the view", "PSM less the uniform map, texels", kDoubleTexels, kVisibleTexels,
                   [=](auto t, FloatPath path) { return jump<decltype(t)>(along, along, path, MapTechnique::uniform); });
  rows.at_most(15, "light parallel to the view, up = (0,0,1)", "entries of the recipe's matrix that are not finite", 0, 0,
               [=](auto t) {
                 using T = decltype(t);
                 const auto map = recipe_map(clip_from_world<T>(along), unit_light<T>(along)).map_from_world;
                 int bad = 0;
                 for (int i = 0; i < 16; ++i) bad += !isfinite(map[i / 4][i % 4]);
                 return bad;
               });
  rows.says(15, "light parallel to the view, up = (0,0,1)", "what the recipe says", "recipe_up_degenerate", [=](auto t) {
    using T = decltype(t);
    return recipe_map(clip_from_world<T>(along), unit_light<T>(along)).degenerate_up ? named("recipe_up_degenerate") : answer(0);
  });
  Rows::naive(rows.at_most(15, "the same by lookAt as libraries have it", "entries that are not finite", 0, 0, [](auto t) {
    using T = decltype(t);
    const auto view = glm::lookAtRH(Vec3<T>(0, 0, given(T(4))), Vec3<T>(0), Vec3<T>(0, 0, 1));
    int bad = 0;
    for (int i = 0; i < 16; ++i) bad += !isfinite(view[i / 4][i % 4]);
    return bad;
  }));
  // What the eye sees is what the light sees: a point and any point behind it share a texel, in the same order.
  rows.map_at_most(18, "light at the eye", "(u, v) of a receiver less that of a point behind it, texels", kDoubleTexels,
                   kVisibleTexels, [=](auto t, FloatPath path) {
                     using T = decltype(t);
                     std::vector<glm::dvec3> behind;
                     for (const glm::dvec3& x : at_eye.receivers) behind.push_back(x + 0.5 * (x - at_eye.eye));
                     const auto build = map_builder(at_eye, MapTechnique::psm);
                     const double d = texel_distance(map_points<T>(build, at_eye, at_eye.receivers, path),
                                                     map_points<T>(build, at_eye, behind, path));
                     return answer(d, d);
                   });
  // det of the 2 x 2 Jacobians cancels by the square of n / f at grazing receivers: 1e4 roundings.
  rows.error_at_most(18, "light at the eye", "largest m over smallest m, less 1", 1e-10, 1e-2, [=](auto t) {
    using T = decltype(t);
    const Range<T> m = footprints<T>(at_eye, &TexelFootprint<T>::m);
    return m.max / m.min - T(1);
  });
  rows.equals(18, "light at the eye, image 1280 x 720", "anisotropy = aspect", exactly(16, 9), 1e-10,
              [=](auto t) {
                using T = decltype(t);
                return footprints<T>(at_eye, &TexelFootprint<T>::anisotropy).max;
              })
      .float_bound = 1e-2;
}

/// L = (0.5, 0, A, 1) in the cube; its world direction.
MapScene on_screen_light() {
  MapScene s;
  s.light = glm::dvec4(0.5 * s.tan_phi, 0, -1, 0);
  return frustum_scene(s);
}

void add_aim(Rows& rows) {
  const Rational A = Rational(101) / Rational(99);
  const MapScene s = on_screen_light();
  rows.equals(16, "vanishing point (0.5, 0)", "w'' at (1, 1, 1), looking at the centre",
              exactly(Rational(1) - (Rational(0.5) + A) / (Rational(0.25) + A * A)), 1e-14, [=](auto t) {
                using T = decltype(t);
                const Vec4<T> L = clip_from_world<T>(s) * unit_light<T>(s);
                const T r = glm::length(Vec3<T>(L));
                return T(1) - L.w / r * glm::dot(Vec3<T>(L) / r, Vec3<T>(1));
              });
  rows.above(16, "vanishing point (0.5, 0), aimed again", "smallest w on the receivers over the largest", 1e-9, [=](auto t) {
    using T = decltype(t);
    const auto build = map_builder(s, MapTechnique::psm);
    Range<T> w;
    if constexpr (std::is_same_v<T, float>)
      for (const glm::vec4& q : float_clip_points(build(double{}), s, s.receivers, FloatPath::composed)) w.add(q.w);
    else
      w = value_range<T>(row(build(T{}), 3), points_in<T>(s.receivers));
    return w.min / w.max;
  });
  rows.map(16, "vanishing point (0.5, 0), aimed again", "u, PSM", s, 1e-6, map_builder(s, MapTechnique::psm));
  rows.equals(17, "f = infinity", "z / w of a directional light: the far face", exactly(1), 0, [](auto t) {
    using T = decltype(t);
    const Vec4<T> L =
        perspective(T(1), T(1), T(1), given(std::numeric_limits<T>::infinity())) * Vec4<T>(T(0.3), T(0.4), given(T(-0.7)), T(0));
    return L.z / L.w;
  });
}

}  // namespace

void add_projection_cases(Rows& rows) {
  add_lights_near_the_camera_plane(rows);
  add_points_near_the_camera_plane(rows);
  add_lights_on_the_view_axis(rows);
  add_aim(rows);
}

}  // namespace psm
