// SPDX-License-Identifier: GPL-3.0-or-later
// Cases 25, 26, 41 and 43: casters where the eye does not look, and an eye that moves.
#include <cmath>

#include "measure/hard_case_maps.h"

namespace psm {
namespace {

using glm::dvec3;

/// A light from behind: the ray from the receiver (1, 0, -4) to it meets the camera plane z = 0 at (2, 10, 0).
MapScene lit_from_behind() {
  MapScene s;
  s.light = {0.1, 1, 0.4, 0};
  return frustum_scene(s);
}

auto psm_builder(const MapScene& s) {
  return [s](auto t) { return map_from_world<decltype(t)>(s, MapTechnique::psm); };
}

void add_casters_behind_the_eye(Rows& rows) {
  const MapScene s = lit_from_behind();
  const dvec3 receiver(1, 0, -4), in_plane(2, 10, 0), behind(6, 50, 16);
  rows.at_most(25, "caster 16 behind the eye", "its depth in the map less its receiver's, no shift", -1e-6, -1e-6, [=](auto t) {
    using T = decltype(t);
    const auto p = map_points<T>(psm_builder(s), s, {receiver, behind});
    return p[1].z - p[0].z;
  });
  const auto at_its_receiver = [&](int number, const char* name, const dvec3& caster) {
    rows.map_at_most(number, name, "its (u, v) less its receiver's, texels", kDoubleTexels, kVisibleTexels,
                     [=](auto t, FloatPath path) {
                       using T = decltype(t);
                       const auto p = map_points<T>(psm_builder(s), s, {receiver, caster}, path);
                       const double d = texel_distance<T, T>({p[0]}, {p[1]});
                       return answer(d, d);
                     });
  };
  at_its_receiver(25, "caster 16 behind the eye", behind);
  at_its_receiver(26, "vertex of H with w = 0", in_plane);
  Rows::naive(
      rows.at_most(26, "vertex of H with w = 0", "coordinates in the cube, divided by w, that are not finite", 0, 0, [=](auto t) {
        using T = decltype(t);
        const Vec4<T> q = clip_from_world<T>(s) * Vec4<T>(Vec3<T>(in_plane), 1);
        int bad = 0;
        for (int i = 0; i < 3; ++i) bad += !isfinite(q[i] / q.w);
        return bad;
      }));
  // c.l = 0: w does not change along a ray. The eye's own w does.
  rows.at_most(43, "caster inside the receivers' footprint", "change of w from receiver to caster, GMNPR", 1e-12, 1e-4,
               [=](auto t) {
                 using T = decltype(t);
                 const std::vector<dvec3> points{receiver, behind};
                 const auto build = [&](auto u) { return map_from_world<decltype(u)>(s, MapTechnique::gmnpr); };
                 if constexpr (std::is_same_v<T, float>) {
                   const auto q = float_clip_points(build(double{}), s, points, FloatPath::composed);
                   return std::abs(q[1].w / q[0].w - 1);
                 } else {
                   const Vec4<T> c = row(build(T{}), 3);
                   return abs(glm::dot(c, Vec4<T>(Vec3<T>(behind), 1)) / glm::dot(c, Vec4<T>(Vec3<T>(receiver), 1)) - T(1));
                 }
               });
  Rows::naive(
      rows.above(43, "caster inside the receivers' footprint", "w by which a divided PSM divides, at the caster", 0, [=](auto t) {
        using T = decltype(t);
        return (clip_from_world<T>(s) * Vec4<T>(Vec3<T>(behind), 1)).w;
      }));
}

void add_snapping(Rows& rows) {
  const auto zero_step = [](auto t, auto snap) {
    using T = decltype(t);
    int at_zero = 0;  // of 4,000 places, 1,000 a texel
    for (int i = -2000; i < 2000; ++i) at_zero += snap((given(T(i)) + T(0.5)) / T(1000)) == T(0);
    return T(at_zero) / T(1000);
  };
  Rows::naive(rows.at_most(41, "snapping to texels, x - fmod(x, 1)", "width of the step around 0, texels", 1, 1,
                           [=](auto t) { return zero_step(t, [](auto x) { return x - fmod(x, decltype(x)(1)); }); }));
  rows.map_at_most(41, "eye moved from x = -1e-6 to 1e-6, psmlab does not snap", "jump of the map, texels, PSM", 1e-3, 0.1,
                   [](auto t, FloatPath path) {
                     using T = decltype(t);
                     MapScene left = frustum_scene(), right = left;  // the same receivers
                     left.eye.x = -1e-6, right.eye.x = 1e-6;
                     const double d = texel_distance(map_points<T>(psm_builder(left), left, left.receivers, path),
                                                     map_points<T>(psm_builder(right), right, left.receivers, path));
                     return answer(d, d);
                   });
}

}  // namespace

void add_caster_cases(Rows& rows) {
  add_casters_behind_the_eye(rows);
  add_snapping(rows);
}

}  // namespace psm
