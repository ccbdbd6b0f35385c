// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"

namespace psm {

/// Whether the triangles are the whole surface of solid pieces, seen from outside: each edge is used as often one way as the other,
/// where corners at the very same place count as one, and each connected piece holds a positive volume. Seen from outside, the
/// backs of such triangles are always hidden.
bool is_closed(const Mesh& mesh);

}  // namespace psm
