// SPDX-License-Identifier: GPL-3.0-or-later
// From the world to the unit cube, continuously: what the cube view shows at view.world_to_cube = t.
//
//   M(t) = (1 - t) d0 S + t C
//
// C is cube_from_world, with w = d, the depth before the eye. S is a similarity with w = 1: the world along the eye's axes, on
// the scale at which what is lit and in view just fits the cube. d0 is the geometric mean of that part's depths. So
//
//   w(t) = (1 - t) d0 + t d,   which is zero in the plane of an eye (1 - t)/t d0 behind the eye's place:
//
// x and y are divided by the depth before that withdrawn eye, and z is a + b/w. M(t) is that eye's own perspective map, but for a
// scaling and a shift along the axes: the virtual camera shift of PSM 2002, section 4.2, carried on to infinity. At 0 angles and
// shapes are the world's, at 1 it is the cube. On the frustum d > 0, and w with it, at every t.
#pragma once

#include "scene/analysis.h"

namespace psm {

struct WorldToCube {
  glm::dmat4 shown_from_world{1.0};
  glm::dmat4 shown_from_cube{1.0};  // the identity at t = 1
  double withdrawn = 0.0;           // how far the virtual eye is behind the eye's place, scene units; infinite at t = 0
};

WorldToCube world_to_cube(const Analysis& analysis);

}  // namespace psm
