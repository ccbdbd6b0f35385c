// SPDX-License-Identifier: GPL-3.0-or-later
// An analysis's matrices as text to paste into a program, in the clip space that the program uses.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "scene/analysis.h"

namespace psm {

enum class MatrixLanguage {
  glsl,  // float, 9 digits
  cpp,   // GLM's dmat4, 17 digits
  json   // rows, as in the analysis
};

/// Where the near and the far end of the depth range lie after the division by w.
enum class ClipConvention {
  opengl,     // -1, 1
  d3d,        // 0, 1
  reversed_z  // 1, 0
};

const char* name_of(MatrixLanguage language);
const char* name_of(ClipConvention convention);
std::optional<MatrixLanguage> matrix_language_from_name(const std::string& name);
std::optional<ClipConvention> clip_convention_from_name(const std::string& name);

/// A matrix into OpenGL's clip space, in another one: x, y and w stay bit for bit.
glm::dmat4 in_convention(const glm::dmat4& clip_from_space, ClipConvention convention);

/// The eye's projection, with the depth row from near and far themselves, so that nothing cancels where far >> near.
glm::dmat4 eye_projection(const Analysis& analysis, ClipConvention convention);

/// view_from_world, clip_from_view, map_from_world (and the second, or the six instead of it, where there are such maps).
std::string matrices_text(const Analysis& analysis, MatrixLanguage language, ClipConvention convention);

}  // namespace psm
