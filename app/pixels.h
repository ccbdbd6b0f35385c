// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures put together from rectangles, without OpenGL.
#pragma once

#include <glm/glm.hpp>

#include "draw/image.h"

namespace psm {

Image filled(const glm::ivec2& size, const glm::vec4& color);

/// The rectangle from `min` to before `max`, as far as it lies in the picture; opaque.
void fill(Image& image, glm::ivec2 min, glm::ivec2 max, const glm::vec3& color);

/// The columns of `part` from `columns.x` to before `columns.y`, where they stand when its top left is at `origin`. They lie in
/// `whole`.
void paste(const Image& part, const glm::ivec2& columns, const glm::ivec2& origin, Image& whole);

}  // namespace psm
