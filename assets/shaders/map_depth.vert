// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 0) in vec4 a_clip;
layout(location = 1) in vec2 a_map;
out vec2 v_map;

void main() {
  gl_Position = a_clip;
  v_map = a_map;
}
