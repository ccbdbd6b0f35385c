// SPDX-License-Identifier: GPL-3.0-or-later
// The built-in scenes; builtin_scenes.cpp lists them.
#pragma once

#include "scene/scene.h"

namespace psm {

Scene make_chessboard();
Scene make_ground();
Scene make_ball();
Scene make_robots();
Scene make_ceiling();

}  // namespace psm
